// A quadrilateral for each triangle and polygon that contains it, in single precision: what the
// kernels look at before they test the object itself (filter.inl).
//
//   1. Every line that an object's own test counts as a hit passes through its quadrilateral, but
//   for the margins of filter.inl, which know how far points are off the plane.
//   2. A leaf's quadrilaterals lie as rows: 12 rows of corners (x, y, z of each), three of the
//   normal, one of the offset, one of how far points are off the plane (infinite: nothing is known
//   about the object), one of the diameter, one that is 0 where the quadrilateral is the object
//   itself and its hits lie in its world box, else infinite.
//   3. Corners run around the normal the same way in all of them. Of a triangle, the fourth halves
//   an edge.
//   4. Leaves of other objects have boxes in the first six rows: low x, y, z, high x, y, z.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rayshade/common/vector.h"

namespace rayshade {

inline constexpr int kQuadRows = 19;
inline constexpr uint32_t kPartsMost = 64;  // of one polygon (polygon_parts.h)

// Relative to the hierarchy's center.
struct Quad {
  float row[kQuadRows];
};

// points: of a triangle or polygon with this plane. room: the object's world box is so much larger
// than its points' on every side; infinite where no hit is checked against it.
Quad QuadAround(std::span<const Vector> points, const Vector& normal, double offset,
                const double center[3], double room);

// Whether its quadrilateral is the object itself, however far its points are off the plane.
bool QuadIsObject(std::span<const Vector> points, const Vector& normal);

// An object's box, rounded outwards.
Quad BoxAsQuad(const float low[3], const float high[3]);

// Writes the quadrilaterals of a leaf as rows.
void WriteQuads(std::span<const Quad> quads, float* rows);

}  // namespace rayshade
