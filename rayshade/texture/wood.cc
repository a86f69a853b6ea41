// See wood.h.
#include "rayshade/texture/wood.h"

#include <algorithm>
#include <cmath>

#include "rayshade/texture/noise.h"

namespace rayshade {

void WoodTexture::Apply(TextureHit* hit) const {
  const Vector p = PointOf(*hit);
  const double c = Chaos(p, 7);
  const double t = std::abs(std::sin(std::sin(8.0 * c + 7.0 * p.x + 3.0 * p.y)));
  const double e = std::abs(std::sin(40.0 * c + 50.0 * p.z));
  const double bp = 0.6 * e + 0.3, gp = 0.2 * e + 0.8, hp = 0.15 * e + 0.85;
  const double G = 0.5 * std::pow(t, 0.3);
  const double ring = std::pow(0.5 * (t + 1.0), 0.6);
  const double B = ring * bp, E = ring * gp;
  const Color factor{(0.5 * B + 0.35 * E) * 2.0 * G, G * std::max(B, E) * hp,
                     (0.25 * B + 0.35 * E) * 2.0 * G};
  hit->surface.ambient = factor * hit->surface.ambient;
  hit->surface.diffuse = factor * hit->surface.diffuse;
}

size_t WoodTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
