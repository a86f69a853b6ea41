// Rays in rows of 64, looked at against boxes by the vector kernels: what Intersect tells is asked
// of few of them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "parallel/cell_tree.h"
#include "rayshade/accel/trace_view.h"

namespace rayshade::parallel {

class RayRows {
 public:
  static constexpr uint32_t kRow = 64;

  // Makes room for so many rays; there are none yet.
  void Clear(size_t rays) {
    used_ = (rays + kRow - 1) / kRow;
    if (rows_.size() < used_) rows_.resize(used_);
    for (size_t r = 0; r < used_; ++r) std::fill_n(rows_[r].limit, kRow, -1.0);
  }
  void Set(size_t ray, const Vector& origin, const Vector& direction, double limit) {
    Row& row = rows_[ray / kRow];
    const size_t i = ray % kRow;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = direction[axis];
      row.origin[axis][i] = origin[axis];
      row.inverse[axis][i] = 1 / (std::abs(d) < kAlongPlanes ? kAlongPlanes : d);
    }
    row.limit[i] = limit;
  }
  // Below 0: there is no such ray any more.
  void SetLimit(size_t ray, double limit) { rows_[ray / kRow].limit[ray % kRow] = limit; }

  // Calls visit(ray) for those that, by Intersect(box, ray), meet the box between 0 and their
  // limit, in order; maybe for some beside: intervals are widened by more than what inverses are
  // off by.
  template <class Visit>
  void ForEachMeeting(const Bounds& box, Visit visit) const {
    for (size_t r = 0; r < used_; ++r) {
      const Row& row = rows_[r];
      for (uint64_t meet = kernels_->meet_box({{row.origin[0], row.origin[1], row.origin[2]},
                                               {row.inverse[0], row.inverse[1], row.inverse[2]},
                                               row.limit,
                                               kRow,
                                               {box.low.x, box.low.y, box.low.z},
                                               {box.high.x, box.high.y, box.high.z}});
           meet != 0; meet &= meet - 1) {
        visit(r * kRow + static_cast<size_t>(std::countr_zero(meet)));
      }
    }
  }

 private:
  struct alignas(64) Row {
    double origin[3][kRow], inverse[3][kRow];
    double limit[kRow];
  };

  const Kernels* kernels_ = &ChooseKernels();
  std::vector<Row> rows_;  // never fewer than before: new ones would be cleared each time
  size_t used_ = 0;
};

}  // namespace rayshade::parallel
