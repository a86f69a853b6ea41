// See cloud.h.
#include "rayshade/texture/cloud.h"

#include <cmath>

#include "rayshade/texture/noise.h"

namespace rayshade {

CloudTexture::CloudTexture(const CloudSpec& spec, const TransformChain& transforms)
    : PlacedTexture(transforms), spec_(spec), omega_(OmegaOf(spec.h, spec.lambda)) {
  max_ = 1.0 / (1.0 - (1.0 + 2.0 * spec.h));
}

void CloudTexture::Apply(TextureHit* hit) const {
  Surface& s = hit->surface;

  // The ray in the space of the sphere.
  const Transform& p = hit->primitive_to_model;
  const Transform t = space().At(hit->moment);
  const Vector origin = t.Point(p.InversePoint(hit->ray_origin));
  const Vector direction = Normalized(t.Direction(p.InverseDirection(hit->ray_direction)));

  // Seen from the inside there is no cloud.
  const double square = Dot(origin, origin);
  if (square < 1.0 + kEpsilon) {
    s.transp = 1;
    s.ambient = s.diffuse = {};
    return;
  }

  // Density, and how near the limb the ray meets the sphere: 0 there, 1 in the middle.
  const double f = NoiseFraction(Fbm(PointOf(*hit), omega_, spec_.lambda, spec_.octaves), max_);
  const double d = std::sqrt(square);
  const double beta = std::sqrt(square - 1.0) / d;
  const double alpha = -Dot(origin, direction) / d;
  const double limb = (alpha - beta) / (1.0 - beta);

  const double density = Clamped(f);
  const double threshold = spec_.cthresh + (spec_.lthresh - spec_.cthresh) * (1.0 - limb);
  s.transp = Clamped(1.0 - (density - threshold) / spec_.transcale);
  s.diffuse = s.diffuse * ((1.0 - s.transp) * (1.0 - spec_.scale + spec_.scale * density));
  s.ambient = s.ambient * (1.0 - s.transp);
}

size_t CloudTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
