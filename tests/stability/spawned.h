// Do rays that leave a surface meet it where they begin? Random primitives with coordinates over 16
// decades, hit by rays, and the rays that the renderer spawns from there: reflected, transmitted,
// towards lights.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rayshade::stability {

struct SpawnedCount {
  std::string primitive;
  int objects = 0;
  int64_t rays = 0;             // spawned
  int64_t hits = 0;             // of them, that meet the object again
  int64_t own = 0;              // of these, that meet it where they begin
  int64_t at_edges = 0;         // begin so near to an edge that one cannot tell on which face
  int64_t own_by_original = 0;  // with Rayshade's fixed least distances: what the rule is for
};

// rays: spawned from each object. The same objects and rays on every machine.
std::vector<SpawnedCount> CountOwnHits(int objects, int rays);

}  // namespace rayshade::stability
