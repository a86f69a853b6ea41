// See gloss.h.
#include "rayshade/texture/gloss.h"

#include <algorithm>

#include "rayshade/common/keyed_random.h"
#include "rayshade/geom/unit.h"

namespace rayshade {

void GlossTexture::Apply(TextureHit* hit) const {
  const uint32_t n = static_cast<uint32_t>(std::max(hit->samples, 1));
  const double cell = 2.0 / n;
  const auto random = [&](uint32_t component) {
    return KeyedRandom(hit->key, RandomUse::kGloss, 2 * hit->application + component);
  };
  const double a = random(0) * cell - 1.0 + (hit->sample_number % n) * cell;
  const double b = random(1) * cell - 1.0 + (hit->sample_number / n) * cell;
  const double r = 1.0 - gloss_;
  const AxisPair axes = AxesAcross(hit->normal);
  hit->normal = Normalized(hit->normal + r * a * axes.u + r * b * axes.v);
}

size_t GlossTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
