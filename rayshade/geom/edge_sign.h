// On which side of an edge does a ray pass? The question that decides between neighbouring polygons
// and triangles, answered alike from both sides, so that no ray slips through between them.
#pragma once

#include "rayshade/common/vector.h"

namespace rayshade {

// The sign (-1, 0, 1) of D . ((a - O) x (b - O)), computed with more than twice the digits of a
// double.
//
//   1. EdgeSign(a, b) == -EdgeSign(b, a), always: it does not depend on which polygon asks.
//   2. 0 where the ray meets the edge's line as far as the digits can tell.
int EdgeSign(const Vector& origin, const Vector& direction, const Vector& a, const Vector& b);

// The same for the ray moved aside by a step that is smaller than every number, first along -x,
// then along -y, then along -z: never 0 but for edges that are parallel to the ray. All who ask
// about one ray speak of the same step; a closed surface that would be met in an edge or a vertex
// is met in the faces beside.
int EdgeSignBeside(const Vector& origin, const Vector& direction, const Vector& a, const Vector& b);

// A relative margin for edge functions in plain double: results nearer to zero than this times the
// magnitudes that went in are left to EdgeSign.
inline constexpr double kEdgeMargin = 0x1.0p-47;

}  // namespace rayshade
