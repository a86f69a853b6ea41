// See fbm.h.
#include "rayshade/texture/fbm.h"

namespace rayshade {

void FbmTexture::Apply(TextureHit* hit) const {
  const double f = Fbm(PointOf(*hit), omega_, spec_.lambda, spec_.octaves);
  const double v =
      f < spec_.threshold ? spec_.offset : spec_.offset + spec_.scale * (f - spec_.threshold);
  const Color factor = spec_.map ? MapEntry(*spec_.map, 255.0 * v) : Color{v, v, v};
  hit->surface.ambient = factor * hit->surface.ambient;
  hit->surface.diffuse = factor * hit->surface.diffuse;
}

size_t FbmTexture::bytes() const {
  return sizeof(*this) + space().bytes() + (spec_.map ? spec_.map->size() * sizeof(Color) : 0);
}

}  // namespace rayshade
