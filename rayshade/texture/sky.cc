// See sky.h.
#include "rayshade/texture/sky.h"

#include <cmath>

namespace rayshade {

void SkyTexture::Apply(TextureHit* hit) const {
  const double sum = Fbm(PointOf(*hit), omega_, spec_.lambda, spec_.octaves);
  double f = NoiseFraction(sum, 1.0 / (1.0 - omega_));
  f = Clamped((f - spec_.lthresh) / (spec_.cthresh - spec_.lthresh));
  if (spec_.scale != 0) f = std::pow(f, spec_.scale);
  Surface& s = hit->surface;
  s.transp = 1.0 - f;
  s.diffuse = f * s.diffuse;
  s.ambient = f * s.ambient;
}

size_t SkyTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
