// See extended.h.
#include "rayshade/light/extended.h"

#include <algorithm>

#include "rayshade/common/keyed_random.h"
#include "rayshade/common/sample_pattern.h"
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
  const uint32_t number = NumberOf(key.sample_number);
  PlaceInCell place{random(0), random(1)};
  if (IsLowDiscrepancy(key.sample_number)) {
    place = LowDiscrepancyPlace(
        static_cast<int>(n), static_cast<int>(number % n), static_cast<int>(number / n),
        PatternKey(key.sample_number, RandomUse::kExtendedLight, key.light));
  }
  const double v = -radius_ + (number % n) * width + place.x * width;
  const double u = -radius_ + (number / n) * width + place.y * width;

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
