// The bintree; see cell_tree.h.
#include "parallel/cell_tree.h"

#include <algorithm>
#include <cmath>

#include "rayshade/common/check.h"

namespace rayshade::parallel {

RayInterval Intersect(const Bounds& box, const Vector& origin, const Vector& direction) {
  double entry = -HUGE_VAL, exit = HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction[axis], o = origin[axis];
    if (std::abs(d) < kAlongPlanes) {
      if (o < box.low[axis] || o > box.high[axis]) return {1, 0};
      continue;
    }
    const double a = (box.low[axis] - o) / d, b = (box.high[axis] - o) / d;
    entry = std::max(entry, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  return RoundedOutwards(entry, exit);
}

CellTree::CellTree(const Bounds& bounds)
    : bounds_(bounds), margin_(MarginOf(bounds)), nodes_(1), cells_(1), leaves_{0} {}

double CellTree::MarginOf(const Bounds& bounds) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max({largest, std::abs(bounds.low[axis]), std::abs(bounds.high[axis])});
  }
  return bounds.empty() ? 0 : 1e-10 * largest;
}

CellId CellTree::Cut(CellId cell, int axis, double plane) {
  const CellId high = static_cast<CellId>(cells_.size());
  const uint32_t child = static_cast<uint32_t>(nodes_.size());
  nodes_[leaves_[cell]] = {static_cast<uint8_t>(axis), plane, child, child + 1};
  leaves_[cell] = child;
  leaves_.push_back(child + 1);
  nodes_.push_back({3, 0, cell, 0});
  nodes_.push_back({3, 0, high, 0});
  cells_.push_back(cells_[cell]);
  return high;
}

std::vector<Bounds> CellTree::Boxes() const {
  std::vector<Bounds> of_node(nodes_.size(), bounds_), of_cell(cells_.size());
  for (size_t i = 0; i < nodes_.size(); ++i) {  // parents come before their children
    const CellNode& n = nodes_[i];
    if (n.axis == 3) {
      of_cell[n.low] = of_node[i];
      continue;
    }
    of_node[n.low] = of_node[n.high] = of_node[i];
    of_node[n.low].high[n.axis] = n.plane;
    of_node[n.high].low[n.axis] = n.plane;
  }
  return of_cell;
}

CellId CellTree::At(const Vector& point) const {
  if (!bounds_.Contains(point)) return kNoCell;
  uint32_t node = 0;
  while (nodes_[node].axis != 3) {
    const CellNode& n = nodes_[node];
    node = point[n.axis] < n.plane ? n.low : n.high;
  }
  return nodes_[node].low;
}

void CellTree::FindLeaves() {
  if (nodes_.empty() || cells_.empty()) throw WireError("a subdivision without cells");
  constexpr uint32_t kNone = ~uint32_t{0};
  leaves_.assign(cells_.size(), kNone);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const CellNode& n = nodes_[i];
    if (n.axis > 3) throw WireError("a subdivision with a fourth axis");
    if (n.axis == 3) {
      if (n.low >= cells_.size() || leaves_[n.low] != kNone) {
        throw WireError("a cell that is not one leaf");
      }
      leaves_[n.low] = static_cast<uint32_t>(i);
    } else if (n.low <= i || n.high <= i || n.low >= nodes_.size() || n.high >= nodes_.size()) {
      throw WireError("a subdivision that is no tree");
    }
  }
  if (std::count(leaves_.begin(), leaves_.end(), kNone) != 0) {
    throw WireError("a cell without a leaf");
  }
}

}  // namespace rayshade::parallel
