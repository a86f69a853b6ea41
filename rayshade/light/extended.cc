// See extended.h.
#include "rayshade/light/extended.h"

#include <algorithm>

#include "rayshade/common/keyed_random.h"
#include "rayshade/geom/unit.h"
#include "rayshade/light/point.h"

namespace rayshade {

LightDirection ExtendedLight::Toward(const Vector& point, const LightKey&) const {
  return TowardPosition(center_, point);
}

std::optional<LightArrival> ExtendedLight::Arrive(const Vector& point, const LightDirection&,
                                                  const LightKey& key) const {
  // A jittered cell of the square, the one that the sample number names.
  const uint32_t n = static_cast<uint32_t>(std::max(key.samples, 1));
  const double width = 2.0 * radius_ / n;
  const auto random = [&](uint32_t component) {
    return KeyedRandom(key.key, RandomUse::kExtendedLight, 2 * key.light + component);
  };
  const double v = -radius_ + (key.sample_number % n) * width + random(0) * width;
  const double u = -radius_ + (key.sample_number / n) * width + random(1) * width;

  // The square stands across the way to the centre.
  const Vector to_center = center_ - point;
  const AxisPair axes = AxesAcross(to_center);
  LightArrival arrival;
  arrival.color = intensity();
  arrival.shadow_direction = to_center + u * axes.u + v * axes.v;
  arrival.shadow_distance = Normalize(&arrival.shadow_direction);
  return arrival;
}

}  // namespace rayshade
