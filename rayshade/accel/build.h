// Builds the hierarchy of an object set: surface area heuristic by binning [Wal07] down to a binary
// tree, of which eight branches at a time become one node [WBB08].
//
//   1. Spheres are sorted in place, records and keys together, without any temporary; all other
//   objects are sorted by reference.
//   2. The tree is at most kDepthMax deep, whatever the objects.
//   3. When a leaf is made, its spheres' records become rows (trace_view.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rayshade/accel/growing_array.h"
#include "rayshade/accel/trace_view.h"

namespace rayshade {

struct SphereRecord {
  double x, y, z, radius;
};

// An object that is not a flat sphere, as the builder sees it: its box relative to the center.
struct BuildRef {
  float low[3], high[3];
  uint32_t index;  // given by the caller
  LeafKind kind;
};

struct BuildInput {
  double center[3];
  std::span<SphereRecord> spheres;
  std::span<ObjectKey> keys;       // of the spheres
  std::span<const double> growth;  // of a sphere's box, by placement
  std::span<BuildRef> refs;
};

struct BuildOutput {
  GrowingArray<Node> nodes;            // the root first; empty where there is nothing
  GrowingArray<uint64_t> leaf_begins;  // one bit a sphere, one behind all, and a word
};

// Permutes spheres, keys and refs. In the leaves, first counts spheres (kSphereLeaf), or refs.
BuildOutput BuildHierarchy(const BuildInput& input);

// Bounds in single precision that contain the number; values near the limits of float go to
// infinity.
float RoundedDown(double x);
float RoundedUp(double x);

}  // namespace rayshade
