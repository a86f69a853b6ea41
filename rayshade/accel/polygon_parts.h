// A polygon that is no convex quadrilateral, cut into triangles and convex quadrilaterals, so that
// the kernels can look at these (quads.h) instead of at a rectangle around it.
//
//   1. Corners of parts are points of the polygon. But for lines through edges, a line winds around
//   the polygon as often as it passes through parts: the winding of a closed path is the sum of
//   those of the triangles into which diagonals cut it, whatever its shape, and all of them turn
//   the same way.
//   2. A polygon that cannot be cut in this way (it winds both ways round) or has too many points
//   has no parts.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rayshade/common/vector.h"

namespace rayshade {

// Three or four corners, around the normal or against it, as the polygon's points.
struct PolygonPart {
  std::array<uint32_t, 4> corner;
  uint32_t count;
};

// normal: unit.
std::vector<PolygonPart> CutIntoParts(std::span<const Vector> points, const Vector& normal);

}  // namespace rayshade
