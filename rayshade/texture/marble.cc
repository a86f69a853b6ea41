// See marble.h.
#include "rayshade/texture/marble.h"

#include <cmath>

#include "rayshade/texture/noise.h"

namespace rayshade {

void MarbleTexture::Apply(TextureHit* hit) const {
  const Vector p = PointOf(*hit);
  const double v = std::pow(0.5 * (std::sin(8.0 * Chaos(p, 6) + 7.0 * p.z) + 1.0), 0.77);
  const Color factor = map_ ? MapEntry(*map_, 255.0 * v) : Color{v, v, v};
  hit->surface.ambient = factor * hit->surface.ambient;
  hit->surface.diffuse = factor * hit->surface.diffuse;
}

size_t MarbleTexture::bytes() const {
  return sizeof(*this) + space().bytes() + (map_ ? map_->size() * sizeof(Color) : 0);
}

}  // namespace rayshade
