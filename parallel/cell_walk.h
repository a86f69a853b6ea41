// The cells along a ray, in its order: (entry distance, cell id). Nodes are opened nearest first,
// so that cells come out in that order even where boxes touch the ray alike (a ray along a face is
// in both cells beside it).
//
// One walk serves many rays, one after the other, and keeps its memory. What it holds of a box are
// the distances of its planes along the ray: the boxes of a cut node differ in one plane, so that a
// node costs one division. They are those of Intersect (cell_tree.h), to the bit.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "parallel/cell_tree.h"

namespace rayshade::parallel {

class CellWalk {
 public:
  // tree: outlives the walk.
  explicit CellWalk(const CellTree* tree) : tree_(tree) {}

  // Calls visit(cell, interval) for the cells that the ray meets between distances 0 and limit,
  // until visit returns false. skip(node) prunes subtrees. Returns the number of cells and nodes
  // looked at.
  template <class Skip, class VisitCell>
  size_t Visit(const Vector& origin, const Vector& direction, double limit, Skip skip,
               VisitCell visit) {
    open_.clear();
    Step root;
    if (skip(0) || !Reach(tree_->bounds(), origin, direction, &root)) return 0;
    Open(0, root, limit);
    size_t steps = 0;
    while (!open_.empty()) {
      Step step = open_.back();
      open_.pop_back();
      ++steps;
      if (step.leaf) {
        if (!visit(CellId{step.id}, step.interval)) break;
        continue;
      }
      const CellNode& node = tree_->nodes()[step.id];
      const double o = origin[node.axis], d = direction[node.axis];
      const bool along = std::abs(d) < kAlongPlanes;
      const double plane = along ? 0 : (node.plane - o) / d;
      const auto open_low = [&] {
        if (skip(node.low) || (along && o > node.plane)) return;
        const double kept = step.of_high[node.axis];
        if (!along) step.of_high[node.axis] = plane;
        Open(node.low, step, limit);
        step.of_high[node.axis] = kept;
      };
      const auto open_high = [&] {
        if (skip(node.high) || (along && o < node.plane)) return;
        const double kept = step.of_low[node.axis];
        if (!along) step.of_low[node.axis] = plane;
        Open(node.high, step, limit);
        step.of_low[node.axis] = kept;
      };
      // The further one first: it comes to stand beneath the nearer one.
      if (d < 0) {
        open_low();
        open_high();
      } else {
        open_high();
        open_low();
      }
    }
    return steps;
  }

 private:
  struct Step {
    RayInterval interval;
    bool leaf;
    uint32_t id;                   // cell of a leaf, else node
    double of_low[3], of_high[3];  // distances of the box's planes; infinite where the ray runs
                                   // along them, between them
  };

  // At equal entries nodes are opened before cells are visited: all cells of that entry are then
  // known.
  static bool Later(const Step& a, const Step& b) {
    if (a.interval.entry != b.interval.entry) return a.interval.entry > b.interval.entry;
    if (a.leaf != b.leaf) return a.leaf;
    return a.id > b.id;
  }

  // The planes of a box; false where the ray runs beside it.
  static bool Reach(const Bounds& box, const Vector& origin, const Vector& direction, Step* step) {
    for (int axis = 0; axis < 3; ++axis) {
      const double d = direction[axis], o = origin[axis];
      step->of_low[axis] = -HUGE_VAL;
      step->of_high[axis] = HUGE_VAL;
      if (std::abs(d) < kAlongPlanes) {
        if (o < box.low[axis] || o > box.high[axis]) return false;
        continue;
      }
      step->of_low[axis] = (box.low[axis] - o) / d;
      step->of_high[axis] = (box.high[axis] - o) / d;
    }
    return true;
  }

  // Adds a node with these planes, if the ray meets it.
  void Open(uint32_t node, const Step& planes, double limit) {
    double entry = -HUGE_VAL, exit = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
      entry = std::max(entry, std::min(planes.of_low[axis], planes.of_high[axis]));
      exit = std::min(exit, std::max(planes.of_low[axis], planes.of_high[axis]));
    }
    const RayInterval interval = RoundedOutwards(entry, exit);
    if (interval.empty() || interval.exit < 0 || interval.entry > limit) return;
    const CellNode& n = tree_->nodes()[node];
    Step& step = open_.emplace_back(planes);
    step.interval = interval;
    step.leaf = n.axis == 3;
    step.id = step.leaf ? n.low : node;
    for (size_t i = open_.size() - 1; i > 0 && Later(open_[i], open_[i - 1]); --i)
      std::swap(open_[i], open_[i - 1]);
  }

  const CellTree* tree_;
  std::vector<Step> open_;  // the next one last
};

}  // namespace rayshade::parallel
