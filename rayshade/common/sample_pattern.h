// Patterns of low discrepancy for the n x n samples of a pixel (--quality). As in Rayshade's own
// jitter [rayshade4/1 s.8.4] each sub-cell of a square has one sample; here the samples of a pixel
// also have, all together, one in each of n*n columns and one in each of n*n rows (multi-jittered
// [CSW94]), and for n a power of two one in every dyadic box of area 1/(n*n): a (0, m, 2)-net in
// base 2 [Nie92]. One pattern serves the place in the pixel, on the lens, on an extended light and
// of gloss, each with a shift of its own.
//
//   1. The pattern of a pixel is a function of its shift, which travels with its rays: in the bits
//   of Ray::sample_number above the number itself. They are 0 in Rayshade's own sampling.
#pragma once

#include <cstdint>

#include "rayshade/common/keyed_random.h"

namespace rayshade {

// number: at most 255. pixel_key: of the pixel, without a sub-cell.
constexpr uint32_t WithShift(uint32_t number, uint64_t pixel_key) {
  return number | static_cast<uint32_t>(pixel_key << 9) | 0x100;
}
constexpr bool IsLowDiscrepancy(uint32_t sample_number) { return sample_number >> 8 != 0; }
constexpr uint32_t NumberOf(uint32_t sample_number) { return sample_number & 0xff; }

// The bits of a shift, as the random numbers of that use and index have a key.
constexpr uint64_t PatternKey(uint32_t sample_number, RandomUse use, uint32_t index = 0) {
  return MixBits((sample_number >> 8) ^ MixBits(static_cast<uint64_t>(use) << 32 | index));
}

struct PlaceInCell {
  double x = 0, y = 0;  // in [0, 1)
};

// The rank of i among 0 … n - 1 in the order of their bits reversed. n: 1 to 8.
constexpr int ReversedRank(int n, int i) {
  const auto reversed = [](int k) { return (k & 1) << 2 | (k & 2) | (k & 4) >> 2; };
  int rank = 0;
  for (int k = 0; k < n; ++k) rank += reversed(k) < reversed(i);
  return rank;
}

// Where the sample of sub-cell (a, b) lies in its sub-cell: in the middle of one of its n x n
// parts.
constexpr PlaceInCell LowDiscrepancyPlace(int n, int a, int b, uint64_t pattern_key) {
  const int shift_x = static_cast<int>(pattern_key % n);
  const int shift_y = static_cast<int>(pattern_key / n % n);
  return {((ReversedRank(n, b) + shift_x) % n + .5) / n,
          ((ReversedRank(n, a) + shift_y) % n + .5) / n};
}

}  // namespace rayshade
