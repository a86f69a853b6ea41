// Boxes as the builder of the hierarchy handles them: four floats at a time, of which the last is
// free. For the heuristic only: nothing here is rounded outwards.
#pragma once

#include <cstdint>
#include <limits>

namespace rayshade {

using F4 = float __attribute__((vector_size(16)));
using I4 = int32_t __attribute__((vector_size(16)));

inline F4 Min(F4 a, F4 b) { return a < b ? a : b; }
inline F4 Max(F4 a, F4 b) { return a > b ? a : b; }
inline F4 AllOf(float x) { return F4{x, x, x, x}; }

struct Box {
  F4 low, high;

  static Box Empty() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    return {AllOf(kInfinity), AllOf(-kInfinity)};
  }
  void Include(const Box& b) {
    low = Min(low, b.low);
    high = Max(high, b.high);
  }
  void Include(F4 p) {
    low = Min(low, p);
    high = Max(high, p);
  }
  // 0 for an empty box.
  float HalfArea() const {
    const F4 d = high - low;
    const F4 next = __builtin_shuffle(d, I4{1, 2, 0, 3});
    const F4 faces = d * next;
    return d[0] < 0 ? 0 : faces[0] + faces[1] + faces[2];
  }
  F4 doubled_center() const { return low + high; }
};

// Boxes sorted by their centers into equal intervals along each axis, 0 … count[axis] - 1.
struct Intervals {
  F4 base, scale;  // of doubled centers

  // centers: the box around the doubled centers.
  Intervals(const Box& centers, const int counts[3]) : base(centers.low), scale(AllOf(0)) {
    const F4 extent = centers.high - centers.low;
    for (int axis = 0; axis < 3; ++axis) {
      // Slightly less than counts / extent: the last interval is not left. Where there is no extent
      // to speak of, all are in the first.
      const float s = static_cast<float>(counts[axis]) * 0.9999f / extent[axis];
      if (extent[axis] > 0 && s <= std::numeric_limits<float>::max()) scale[axis] = s;
    }
    base[3] = 0;
  }
  I4 Of(const Box& box) const {
    const F4 at = (box.doubled_center() - base) * scale;
    return __builtin_convertvector(scale == 0 ? AllOf(0) : at,
                                   I4);  // infinity times 0 is no number
  }
  // Along one axis, which has an extent.
  int32_t Of(const Box& box, int axis) const {
    const float at = (box.low[axis] + box.high[axis] - base[axis]) * scale[axis];
    return static_cast<int32_t>(at);
  }
};

}  // namespace rayshade
