// PyraClip: which cells does a pyramid meet, in depth order [RJ s.3, figure 2; der Zwaan, Reinhard
// & Jansen 1995]. The clip list is what turns the tracing of a bundle into a demand-driven task: it
// names the data that the task needs.
#pragma once

#include <functional>
#include <vector>

#include "parallel/cell_tree.h"
#include "parallel/pyramid.h"

namespace rayshade::parallel {

struct ClippedCell {
  CellId cell = 0;
  double entry = 0;  // no ray of the pyramid is in the cell before this distance
};

// The cells that the pyramid meets between distances 0 and limit, in order of entry (then of id).
// `skip(node)` prunes subtrees that the caller need not hear of. No cell that a ray of the pyramid
// meets is missing; some that none meets may be there.
std::vector<ClippedCell> PyraClip(const CellTree& tree, const Pyramid& pyramid, double limit,
                                  const std::function<bool(uint32_t node)>& skip);

}  // namespace rayshade::parallel
