// Lengths that Rayshade 4 fixes for all scenes [rayshade4/2 s.1]. All are absolute, in world units.
#pragma once

namespace rayshade {

inline constexpr double kEpsilon = 1e-5;                  // least distance of a hit; "is zero"
inline constexpr double kShadowEpsilon = 4.0 * kEpsilon;  // least distance of a shadow ray's hit
inline constexpr double kFar = 1e14;  // "hits nothing"; distance of a directional light
inline constexpr double kPi = 3.14159265358979323846;

}  // namespace rayshade
