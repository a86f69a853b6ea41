// Random numbers and directions for tests that try many rays.
#pragma once

#include <cmath>
#include <random>

#include "rayshade/common/constants.h"
#include "rayshade/common/vector.h"

namespace rayshade::test {

using Random = std::mt19937_64;

inline double Uniform(Random* random, double low, double high) {
  return low + (high - low) * (static_cast<double>((*random)() >> 11) * 0x1.0p-53);
}

// In the cube of edge 2 * size around the origin.
inline Vector RandomPoint(Random* random, double size) {
  const double x = Uniform(random, -size, size), y = Uniform(random, -size, size);
  return {x, y, Uniform(random, -size, size)};
}

// Evenly over the sphere.
inline Vector RandomDirection(Random* random) {
  const double z = Uniform(random, -1, 1), turn = Uniform(random, 0, 2 * kPi);
  const double rho = std::sqrt(1 - z * z);
  return {rho * std::cos(turn), rho * std::sin(turn), z};
}

}  // namespace rayshade::test
