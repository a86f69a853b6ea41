// See gloss.h.
#include "rayshade/texture/gloss.h"

#include <algorithm>

#include "rayshade/common/keyed_random.h"
#include "rayshade/common/sample_pattern.h"
#include "rayshade/geom/unit.h"

namespace rayshade {

void GlossTexture::Apply(TextureHit* hit) const {
  const uint32_t n = static_cast<uint32_t>(std::max(hit->samples, 1));
  const double cell = 2.0 / n;
  const auto random = [&](uint32_t component) {
    return KeyedRandom(hit->key, RandomUse::kGloss, 2 * hit->application + component);
  };
  const uint32_t number = NumberOf(hit->sample_number);
  PlaceInCell place{random(0), random(1)};
  if (IsLowDiscrepancy(hit->sample_number)) {
    place = LowDiscrepancyPlace(
        static_cast<int>(n), static_cast<int>(number % n), static_cast<int>(number / n),
        PatternKey(hit->sample_number, RandomUse::kGloss, hit->application));
  }
  const double a = place.x * cell - 1.0 + (number % n) * cell;
  const double b = place.y * cell - 1.0 + (number / n) * cell;
  const double r = 1.0 - gloss_;
  const AxisPair axes = AxesAcross(hit->normal);
  hit->normal = Normalized(hit->normal + r * a * axes.u + r * b * axes.v);
}

size_t GlossTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
