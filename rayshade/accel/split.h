// One division of a set of boxes in two by the surface area heuristic: exactly, by sweeping over
// the sorted boxes, where there are few; by binning [Wal07] where there are many.
#pragma once

#include <cstdint>

#include "rayshade/accel/box.h"

namespace rayshade {

inline constexpr int kBinsMax = 64;

struct Bin {
  Box box;
  uint32_t count;
};

// The best border between two of the bins along an axis, if it is better than *best.
struct Border {
  float cost = std::numeric_limits<float>::infinity();  // sum of half area × count
  int axis = -1;                                        // -1: none was found
  int last_left = 0;                                    // bin
};
void FindBorder(const Bin* bins, int bin_count, int axis, uint32_t total, Border* best);

struct Split {
  // Sum of half area × count over both sides; infinity: no division was found.
  float cost = std::numeric_limits<float>::infinity();
  Box left, right;
  uint32_t left_count = 0;

  bool found() const { return left_count != 0; }
};

// Divides from[0, count) and writes the boxes to to[0, count), those on the left first; nothing is
// written where no division was found. Boxes must be finite.
Split Divide(const Box* from, uint32_t count, Box* to);

}  // namespace rayshade
