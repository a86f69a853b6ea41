// Which of several hits at one distance counts [rayshade4/2 s.5, 8.2, 8.3]. Rayshade tests objects
// in a fixed order: in a list the unbounded members as written, then the bounded ones last written
// first; in a grid the unbounded, then the bounded members as written; an aggregate or instance is
// tested as a block where it stands. Inclusive kinds (disc, triangle, polygon, CSG) replace a hit
// at the same distance and strict ones do not, so the last tested inclusive candidate wins, and
// where there is none the first tested strict one. One number says both: the least rank wins.
#pragma once

#include <cstdint>

#include "rayshade/accel/object_set.h"

namespace rayshade {

// The most placed objects that ranks can tell apart.
inline constexpr uint64_t kMaxPlacedObjects = (uint64_t{1} << 31) - 1;

// order: place in the order of testing, 0 … objects - 1. REQUIRES: objects <= kMaxPlacedObjects.
constexpr Rank RankOf(uint32_t order, bool inclusive, uint32_t objects) {
  return inclusive ? objects - 1 - order : objects + order;
}

}  // namespace rayshade
