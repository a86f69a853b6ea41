// Default surface and blending; see surface.h.
#include "rayshade/surface/surface.h"

#include "rayshade/common/constants.h"

namespace rayshade {

Surface DefaultSurface() {
  Surface s;
  s.ambient = {.1, .1, .1};
  s.diffuse = {.6, .6, .6};
  s.specular = {.5, .5, .5};
  s.specpow = 12;
  s.translucent_pow = 12;
  return s;
}

Surface Blend(const Surface& a, const Surface& b, double p, double q) {
  if (q < kEpsilon) return a;
  Surface c;
  c.ambient = a.ambient * p + b.ambient * q;
  c.diffuse = a.diffuse * p + b.diffuse * q;
  c.specular = a.specular * p + b.specular * q;
  c.translucent = a.translucent * p + b.translucent * q;
  c.body = a.body * p + b.body * q;
  c.specpow = a.specpow * p + b.specpow * q;
  c.translucent_pow = a.translucent_pow * p + b.translucent_pow * q;
  c.reflect = a.reflect * p + b.reflect * q;
  c.transp = a.transp * p + b.transp * q;
  c.translucency = a.translucency * p + b.translucency * q;
  c.extinct = a.extinct * p + b.extinct * q;
  c.index = a.index * p + b.index * q;
  c.noshadow = p < kEpsilon ? b.noshadow : a.noshadow && b.noshadow;
  return c;
}

}  // namespace rayshade
