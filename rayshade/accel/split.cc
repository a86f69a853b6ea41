// Surface area heuristic; see split.h.
#include "rayshade/accel/split.h"

#include <algorithm>
#include <utility>

namespace rayshade {
namespace {

constexpr uint32_t kSweptMax = 8;
constexpr int kBins = 32;

Split DivideByBins(const Box* from, uint32_t count, Box* to) {
  Box centers = Box::Empty();
  for (uint32_t i = 0; i < count; ++i) centers.Include(from[i].doubled_center());
  const int bin_count = std::min<int>(kBins, 4 + static_cast<int>(count / 4));
  const int counts[3] = {bin_count, bin_count, bin_count};
  const Intervals intervals(centers, counts);
  Bin bins[3][kBins];
  for (auto& of_axis : bins) std::fill_n(of_axis, bin_count, Bin{Box::Empty(), 0});
  for (uint32_t i = 0; i < count; ++i) {
    const I4 at = intervals.Of(from[i]);
#pragma GCC unroll 3  // the places stay in registers
    for (int axis = 0; axis < 3; ++axis) {
      Bin& bin = bins[axis][at[axis]];
      bin.box.Include(from[i]);
      ++bin.count;
    }
  }
  Border best;
  for (int axis = 0; axis < 3; ++axis) {
    if (intervals.scale[axis] != 0) FindBorder(bins[axis], bin_count, axis, count, &best);
  }
  Split split;
  if (best.axis < 0) return split;
  split.cost = best.cost;
  split.left = split.right = Box::Empty();
  for (int i = 0; i < bin_count; ++i) {
    (i <= best.last_left ? split.left : split.right).Include(bins[best.axis][i].box);
  }
  uint32_t left = 0, right = count - 1;
  for (uint32_t i = 0; i < count; ++i) {
    const bool is_left = intervals.Of(from[i], best.axis) <= best.last_left;
    to[is_left ? left : right] = from[i];
    left += is_left;
    right -= !is_left;
  }
  split.left_count = left;
  return split;
}

// order[k]: which box is the k-th along the axis.
void Sort(const Box* boxes, uint32_t count, int axis, uint8_t* order) {
  float center[kSweptMax];
  uint8_t place[kSweptMax] = {};
  for (uint32_t i = 0; i < count; ++i) {
    center[i] = boxes[i].low[axis] + boxes[i].high[axis];
    for (uint32_t j = 0; j < i; ++j) {
      const bool before = center[j] <= center[i];
      place[i] += before;
      place[j] += !before;
    }
  }
  for (uint32_t i = 0; i < count; ++i) order[place[i]] = static_cast<uint8_t>(i);
}

Split DivideBySweep(const Box* from, uint32_t count, Box* to) {
  Split split;
  uint8_t best_order[kSweptMax];
  for (int axis = 0; axis < 3; ++axis) {
    uint8_t order[kSweptMax];
    Sort(from, count, axis, order);
    Box right[kSweptMax];  // of the k-th and all after it
    Box box = Box::Empty();
    for (uint32_t k = count - 1; k > 0; --k) {
      box.Include(from[order[k]]);
      right[k] = box;
    }
    box = Box::Empty();
    for (uint32_t k = 1; k < count; ++k) {
      box.Include(from[order[k - 1]]);
      const float cost = box.HalfArea() * static_cast<float>(k) +
                         right[k].HalfArea() * static_cast<float>(count - k);
      if (!(cost < split.cost)) continue;
      split = {cost, box, right[k], k};
      std::copy_n(order, count, best_order);
    }
  }
  if (!split.found()) return split;
  for (uint32_t k = 0; k < count; ++k) to[k] = from[best_order[k]];
  return split;
}

}  // namespace

void FindBorder(const Bin* bins, int bin_count, int axis, uint32_t total, Border* best) {
  float area_right[kBinsMax];
  Box box = Box::Empty();
  for (int i = bin_count - 1; i > 0; --i) {
    box.Include(bins[i].box);
    area_right[i] = box.HalfArea();
  }
  box = Box::Empty();
  uint32_t left = 0;
  for (int i = 0; i + 1 < bin_count; ++i) {
    box.Include(bins[i].box);
    left += bins[i].count;
    if (left == 0 || left == total) continue;
    const float cost = box.HalfArea() * static_cast<float>(left) +
                       area_right[i + 1] * static_cast<float>(total - left);
    if (cost < best->cost) *best = {cost, axis, i};
  }
}

Split Divide(const Box* from, uint32_t count, Box* to) {
  if (count < 2) return Split();
  return count <= kSweptMax ? DivideBySweep(from, count, to) : DivideByBins(from, count, to);
}

}  // namespace rayshade
