// The slab test of boxes, as primitives and as bounds [rayshade4/2 s.2.3]: one division per plane,
// no reciprocals, so that distances have the original's bits.
#pragma once

#include "rayshade/common/bounds.h"

namespace rayshade {

// The distance at which the ray enters the closed box, or leaves it where it begins inside
// (entries at or before `min` count as inside). False where that is not below `max`.
inline bool IntersectSlabs(const Bounds& box, const Vector& origin, const Vector& direction,
                           double min, double max, double* distance) {
  double low = min, high = max;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = origin[axis], d = direction[axis];
    if (d == 0) {
      if (o < box.low[axis] || o > box.high[axis]) return false;
      continue;
    }
    const double exit = ((d > 0 ? box.high[axis] : box.low[axis]) - o) / d;
    if (exit < low) return false;
    if (exit <= high) high = exit;
    const double entry = ((d > 0 ? box.low[axis] : box.high[axis]) - o) / d;
    if (entry >= low) {
      if (entry > high) return false;
      low = entry;
    }
  }
  const double hit = low == min ? high : low;
  if (!(hit < max)) return false;
  *distance = hit;
  return true;
}

// Is the distance that IntersectSlabs finds that of an entry?
inline bool EntersSlabs(const Bounds& box, const Vector& origin, const Vector& direction,
                        double min) {
  for (int axis = 0; axis < 3; ++axis) {
    const double o = origin[axis], d = direction[axis];
    if (d == 0) continue;
    const double entry = ((d > 0 ? box.low[axis] : box.high[axis]) - o) / d;
    if (entry > min) return true;
  }
  return false;
}

// Does the ray come into the closed box between min and max? For culling: touching counts.
inline bool MeetsBox(const Bounds& box, const Vector& origin, const Vector& direction, double min,
                     double max) {
  for (int axis = 0; axis < 3; ++axis) {
    const double o = origin[axis], d = direction[axis];
    if (d == 0) {
      if (o < box.low[axis] || o > box.high[axis]) return false;
      continue;
    }
    const double entry = ((d > 0 ? box.low[axis] : box.high[axis]) - o) / d;
    const double exit = ((d > 0 ? box.high[axis] : box.low[axis]) - o) / d;
    if (entry > min) min = entry;
    if (exit < max) max = exit;
  }
  return min <= max;
}

}  // namespace rayshade
