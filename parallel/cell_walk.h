// The cells along a ray, in its order: (entry distance, cell id). Nodes are opened nearest first,
// so that cells come out in that order even where boxes touch the ray alike (a ray along a face is
// in both cells beside it).
#pragma once

#include <algorithm>
#include <vector>

#include "parallel/cell_tree.h"

namespace rayshade::parallel {

// Calls visit(cell, interval) for the cells that the ray meets between distances 0 and limit, until
// visit returns false. skip(node) prunes subtrees. Returns the number of cells and nodes looked at.
template <class Skip, class Visit>
size_t WalkCells(const CellTree& tree, const Vector& origin, const Vector& direction, double limit,
                 Skip skip, Visit visit) {
  struct Step {
    RayInterval interval;
    bool leaf;
    uint32_t id;  // cell of a leaf, else node
    Bounds box;
  };
  // At equal entries nodes are opened before cells are visited: all cells of that entry are then
  // known.
  const auto later = [](const Step& a, const Step& b) {
    if (a.interval.entry != b.interval.entry) return a.interval.entry > b.interval.entry;
    if (a.leaf != b.leaf) return a.leaf;
    return a.id > b.id;
  };
  std::vector<Step> heap;
  const auto push = [&](uint32_t node, const Bounds& box) {
    if (skip(node)) return;
    const RayInterval interval = Intersect(box, origin, direction);
    if (interval.empty() || interval.exit < 0 || interval.entry > limit) return;
    const CellNode& n = tree.nodes()[node];
    heap.push_back({interval, n.axis == 3, n.axis == 3 ? n.low : node, box});
    std::push_heap(heap.begin(), heap.end(), later);
  };
  push(0, tree.bounds());
  size_t steps = 0;
  while (!heap.empty()) {
    std::pop_heap(heap.begin(), heap.end(), later);
    const Step step = heap.back();
    heap.pop_back();
    ++steps;
    if (step.leaf) {
      if (!visit(CellId{step.id}, step.interval)) break;
      continue;
    }
    const CellNode& n = tree.nodes()[step.id];
    Bounds low = step.box, high = step.box;
    low.high[n.axis] = n.plane;
    high.low[n.axis] = n.plane;
    push(n.low, low);
    push(n.high, high);
  }
  return steps;
}

}  // namespace rayshade::parallel
