// Surface attributes [rayshade4/3 s.3].
#pragma once

#include "rayshade/common/color.h"

namespace rayshade {

// The defaults of the members are those of a newly defined surface ("blank").
struct Surface {
  Color ambient;
  Color diffuse;
  Color specular;  // highlights, and the tint of mirror rays
  double specpow = 15;
  Color body{1, 1, 1};  // tint of transmitted rays
  double extinct = 1;   // light left after one unit of length inside
  double transp = 0;
  double reflect = 0;  // scales specular for mirror rays
  double index = 1;
  double translucency = 0;
  Color translucent;  // colour of light from the far side
  double translucent_pow = 15;
  bool noshadow = false;  // it receives no shadows; it still casts them

  bool operator==(const Surface&) const = default;
};

// What an object without any surface gets.
Surface DefaultSurface();

// Numeric fields become a p + b q [rayshade4/3 s.3.3].
Surface Blend(const Surface& a, const Surface& b, double p, double q);

}  // namespace rayshade
