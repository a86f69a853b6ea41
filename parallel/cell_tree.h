// The spatial subdivision: a bintree over the scene's bounds. Its leaves, the cells, are the unit
// in which objects are owned, made resident, cached and fetched [RJ s.3: "only the spatial
// subdivision structure is duplicated with each process"].
//
//   1. An object belongs to every cell that its world bounds, grown by margin(), touch; cells are
//   closed.
//   2. Along a ray, cells are ordered by (entry distance, cell id). Entry distances are rounded
//   down and exits up, so
//      that a hit on a border is found from either side.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "parallel/process_id.h"
#include "parallel/scene_codec.h"
#include "rayshade/common/bounds.h"

namespace rayshade::parallel {

using CellId = uint32_t;
inline constexpr CellId kNoCell = ~CellId{0};

struct Cell {
  ProcessId owner = 1;
  bool resident = false;  // held by every process
  uint32_t objects = 0;
  uint64_t bytes = 0;  // that its objects occupy in a process that holds it, estimated

  template <class A>
  void Fields(A& a) {
    a("owner", owner);
    a("resident", resident);
    a("objects", objects);
    a("bytes", bytes);
  }
};

// Axis 0, 1, 2: cut by a plane, below it the child `low`, above it `high`. Axis 3: the cell `low`.
struct CellNode {
  uint8_t axis = 3;
  double plane = 0;
  uint32_t low = 0, high = 0;

  template <class A>
  void Fields(A& a) {
    a("axis", axis);
    a("plane", plane);
    a("low", low);
    a("high", high);
  }
};

// Distances along a ray, rounded outwards; empty where entry > exit.
struct RayInterval {
  double entry = 0, exit = 0;
  bool empty() const { return entry > exit; }
};
RayInterval Intersect(const Bounds& box, const Vector& origin, const Vector& direction);
// What Intersect makes of its distances: widened relatively, far above the rounding of a hit's
// distance, far below what matters to speed.
inline RayInterval RoundedOutwards(double entry, double exit) {
  constexpr double kOutwards = 1e-9;
  return {entry - kOutwards * std::abs(entry), exit + kOutwards * std::abs(exit)};
}
// A direction component below this moves a ray by nothing within any distance.
inline constexpr double kAlongPlanes = 1e-200;

class CellTree {
 public:
  CellTree() : CellTree(Bounds{}) {}
  // One cell for everything.
  explicit CellTree(const Bounds& bounds);

  // Cuts a cell in two. The low part keeps its id, the high part gets the returned one; both have
  // the owner.
  CellId Cut(CellId cell, int axis, double plane);

  const Bounds& bounds() const { return bounds_; }
  // By which the bounds of objects are grown, against rounding far from the origin.
  double margin() const { return margin_; }
  const std::vector<CellNode>& nodes() const { return nodes_; }
  size_t size() const { return cells_.size(); }
  Cell& cell(CellId id) { return cells_[id]; }
  const Cell& cell(CellId id) const { return cells_[id]; }
  std::vector<Bounds> Boxes() const;  // of all cells

  // The cell that a point lies in (the upper one on a border); kNoCell outside of the bounds.
  CellId At(const Vector& point) const;
  // Calls visit(cell) for the cells that an object with these world bounds belongs to.
  template <class Visit>
  void ForEachOver(const Bounds& object, Visit visit) const {
    Bounds grown = object;
    grown.Grow(margin());
    VisitOver(0, grown, visit);
  }
  size_t bytes() const { return nodes_.size() * sizeof(CellNode) + cells_.size() * sizeof(Cell); }

  template <class A>
  void Fields(A& a) {
    a("bounds", bounds_);
    a("nodes", nodes_);
    a("cells", cells_);
    if constexpr (A::kReading) {
      margin_ = MarginOf(bounds_);
      FindLeaves();
    }
  }

 private:
  static double MarginOf(const Bounds& bounds);
  // After reading from a message: what does not form a tree of cells is a WireError.
  void FindLeaves();

  template <class Visit>
  void VisitOver(uint32_t node, const Bounds& object, Visit& visit) const {
    const CellNode& n = nodes_[node];
    if (n.axis == 3) {
      visit(CellId{n.low});
      return;
    }
    if (object.low[n.axis] <= n.plane) VisitOver(n.low, object, visit);
    if (object.high[n.axis] >= n.plane) VisitOver(n.high, object, visit);
  }

  Bounds bounds_;
  double margin_;
  std::vector<CellNode> nodes_;
  std::vector<Cell> cells_;
  std::vector<uint32_t> leaves_;  // node of each cell
};

}  // namespace rayshade::parallel
