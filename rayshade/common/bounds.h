// An axis-aligned box. A box whose low x lies above its high x is the empty box; Rayshade writes
// "unbounded" the same way [rayshade4/2 s.2.2], so unboundedness is said by the owner
// (Geom::bounded), never by a box.
#pragma once

#include <algorithm>

#include "rayshade/common/vector.h"

namespace rayshade {

struct Bounds {
  Vector low{kFar, kFar, kFar};
  Vector high{-kFar, -kFar, -kFar};

  bool empty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
  bool operator==(const Bounds&) const = default;

  void Include(const Vector& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void Include(const Bounds& b) {
    low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
    high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
  }
  void Grow(double by) {
    low = low - Vector{by, by, by};
    high = high + Vector{by, by, by};
  }
  // Closed boxes: boxes that touch overlap.
  bool Overlaps(const Bounds& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y &&
           low.z <= b.high.z && b.low.z <= high.z;
  }
  bool Contains(const Vector& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z &&
           p.z <= high.z;
  }
  double area() const {
    const Vector d = high - low;
    return 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
  }
};

}  // namespace rayshade
