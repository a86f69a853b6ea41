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

// The samples of a pixel are spread evenly over the cells in their order, and the cells that one
// sample asks as well, so that over all samples every cell is asked equally often.
double AreaCellLight::Share(const LightKey& key) const {
  const uint32_t asked = static_cast<uint32_t>(key.area_cells);
  if (asked >= cell_.cells) return 1;
  const double samples = double(key.samples) * key.samples;
  const double number = NumberOf(key.sample_number);
  double place;
  if (IsLowDiscrepancy(key.sample_number)) {
    const uint64_t shift = PatternKey(key.sample_number, RandomUse::kAreaShare, cell_.area);
    place = number / samples + static_cast<double>(shift >> 11) * 0x1.0p-53;
  } else {
    place = (number + KeyedRandom(key.key, RandomUse::kAreaShare, cell_.area)) / samples;
  }
  const double step = double(cell_.cells) / asked;
  for (uint32_t j = 0; j < asked; ++j) {
    const double at = std::fmod(place * cell_.cells + j * step, cell_.cells);
    if (static_cast<uint32_t>(at) == cell_.order) return step;
  }
  return 0;
}

}  // namespace rayshade
