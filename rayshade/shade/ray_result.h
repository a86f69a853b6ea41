// What comes back for a ray: its colour after everything behind it, and the distance it travelled
// (attenuation inside a medium needs it).
#pragma once

#include <cmath>

#include "rayshade/common/color.h"
#include "rayshade/common/constants.h"

namespace rayshade {

// What the picture can do with a colour: numbers that overflowed become as large as leaves room for
// sums, and what is no number 0, as in Rayshade's pictures [rayshade4/1 s.10.2].
inline Color Bounded(const Color& color) {
  constexpr double kMost = 1e300;
  if (std::abs(color.r) + std::abs(color.g) + std::abs(color.b) <= kMost) return color;
  Color bounded;
  for (int k = 0; k < 3; ++k) {
    const double x = color[k];
    bounded[k] = x > kMost ? kMost : x < -kMost ? -kMost : x == x ? x : 0;
  }
  return bounded;
}

struct RayResult {
  Color color;
  double distance = kFar;  // kFar where nothing was hit
  bool hit = false;        // of primary rays: the sample's alpha
};

}  // namespace rayshade
