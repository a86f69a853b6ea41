// See area_cell.h.
#include "rayshade/light/area_cell.h"

#include <cmath>

#include "rayshade/common/keyed_random.h"
#include "rayshade/common/sample_pattern.h"
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

// The cells in their order are cut into as many equal parts as one sample asks cells, and each part
// into as many again as the pixel has samples: the cell that a sample asks in each part lies at
// random in the piece of its number. Over all samples every cell is asked equally often.
double AreaCellLight::Share(const LightKey& key) const {
  const double asked = key.area_cells;
  if (!(asked < cell_.cells)) return 1;
  const double samples = double(key.samples) * key.samples;
  const double random = KeyedRandom(key.key, RandomUse::kAreaShare, cell_.area);
  const double place = std::fmod((NumberOf(key.sample_number) + random) / samples, 1);
  const double part = std::floor((cell_.order + 1) * asked / cell_.cells);
  for (const double j : {part - 1, part}) {
    const double at = (j + place) / asked * cell_.cells;
    if (j >= 0 && j < asked && std::floor(at) == cell_.order) return cell_.cells / asked;
  }
  return 0;
}

}  // namespace rayshade
