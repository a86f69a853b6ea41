// What comes back for a ray: its colour after everything behind it, and the distance it travelled
// (attenuation inside a medium needs it).
#pragma once

#include "rayshade/common/color.h"
#include "rayshade/common/constants.h"

namespace rayshade {

struct RayResult {
  Color color;
  double distance = kFar;  // kFar where nothing was hit
  bool hit = false;        // of primary rays: the sample's alpha
};

}  // namespace rayshade
