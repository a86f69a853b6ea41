// The upper part of a hierarchy over very many objects: a binary tree whose leaves, the pieces, are
// few enough to be built on while they lie in the processor's cache. Objects are counted in the
// cells of a grid; the surface area heuristic divides the grid, instead of the objects, and then
// the objects are moved once, in place, instead of once a level.
#pragma once

#include <cstdint>
#include <vector>

#include "rayshade/accel/box.h"
#include "rayshade/accel/build_objects.h"

namespace rayshade {

inline constexpr uint32_t kPieceMax = 1 << 15;

struct Piece {
  uint32_t sphere_begin = 0, sphere_end = 0, ref_begin = 0, ref_end = 0;
  Box box = Box::Empty();
  uint32_t parts[2] = {0, 0};  // of an inner one

  uint32_t spheres() const { return sphere_end - sphere_begin; }
  uint32_t refs() const { return ref_end - ref_begin; }
  uint32_t count() const { return spheres() + refs(); }
  bool divided() const { return parts[0] != 0; }
};

// The root first. Permutes the objects: each piece is a range of spheres and one of refs. What is
// not divided holds at most kPieceMax objects. At most kPieceDepth deep.
std::vector<Piece> DivideIntoPieces(BuildObjects* objects);
inline constexpr int kPieceDepth = 24 + 17;

}  // namespace rayshade
