// See area_cell.h.
#include "rayshade/light/area_cell.h"

#include "rayshade/common/keyed_random.h"
#include "rayshade/light/point.h"

namespace rayshade {

LightDirection AreaCellLight::Toward(const Vector& point, const LightKey& key) const {
  Vector position = cell_.corner;
  for (uint32_t axis = 0; axis < 3; ++axis) {
    const auto random = [&](uint32_t component) {
      return KeyedRandom(key.key, RandomUse::kAreaLight, 6 * key.light + component);
    };
    const int a = static_cast<int>(axis);
    position[a] += random(axis) * cell_.u[a];
    position[a] += random(3 + axis) * cell_.v[a];
  }
  return TowardPosition(position, point);
}

std::optional<LightArrival> AreaCellLight::Arrive(const Vector&, const LightDirection& direction,
                                                  const LightKey&) const {
  return LightArrival{intensity(), direction.toward, direction.distance};
}

}  // namespace rayshade
