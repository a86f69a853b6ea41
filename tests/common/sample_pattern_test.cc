// Low-discrepancy patterns: what their header promises of all samples of a pixel together.
#include "rayshade/common/sample_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace rayshade {
namespace {

// The samples of one pixel, in [0, 1) x [0, 1).
std::vector<std::pair<double, double>> Pattern(int n, uint64_t key) {
  std::vector<std::pair<double, double>> places;
  for (int b = 0; b < n; ++b) {
    for (int a = 0; a < n; ++a) {
      const PlaceInCell in_cell = LowDiscrepancyPlace(n, a, b, key);
      EXPECT_GT(in_cell.x, 0);
      EXPECT_LT(in_cell.x, 1);
      EXPECT_GT(in_cell.y, 0);
      EXPECT_LT(in_cell.y, 1);
      places.emplace_back((a + in_cell.x) / n, (b + in_cell.y) / n);
    }
  }
  return places;
}

// How many boxes of a grid of columns x rows have a sample.
size_t BoxesMet(const std::vector<std::pair<double, double>>& places, int columns, int rows) {
  std::set<std::pair<int, int>> met;
  for (const auto& [x, y] : places) {
    met.emplace(static_cast<int>(x * columns), static_cast<int>(y * rows));
  }
  return met.size();
}

TEST(SamplePattern, HasASampleInEachRowAndEachColumn) {
  for (int n = 1; n <= 8; ++n) {
    for (uint64_t key = 0; key < 50; ++key) {
      const auto places = Pattern(n, MixBits(key));
      EXPECT_EQ(BoxesMet(places, n * n, 1), size_t(n * n)) << n;
      EXPECT_EQ(BoxesMet(places, 1, n * n), size_t(n * n)) << n;
    }
  }
}

TEST(SamplePattern, IsANetWhereNIsAPowerOfTwo) {
  for (const int n : {2, 4, 8}) {
    for (uint64_t key = 0; key < 50; ++key) {
      const auto places = Pattern(n, MixBits(key));
      for (int columns = 1; columns <= n * n; columns *= 2) {
        EXPECT_EQ(BoxesMet(places, columns, n * n / columns), size_t(n * n)) << n << " " << columns;
      }
    }
  }
}

TEST(SamplePattern, OfOneSampleIsTheMiddle) {
  EXPECT_EQ(LowDiscrepancyPlace(1, 0, 0, 99).x, .5);
  EXPECT_EQ(LowDiscrepancyPlace(1, 0, 0, 99).y, .5);
}

TEST(SamplePattern, ShiftsAreTheSameForAPixelAndOthersElsewhere) {
  std::set<uint64_t> keys;
  for (uint64_t pixel = 0; pixel < 100; ++pixel) {
    const uint64_t pixel_key = MixBits(pixel);
    const uint64_t key = PatternKey(WithShift(0, pixel_key), RandomUse::kGloss, 3);
    keys.insert(key);
    for (uint32_t number = 0; number < 64; ++number) {
      const uint32_t sample_number = WithShift(number, pixel_key);
      EXPECT_EQ(NumberOf(sample_number), number);
      EXPECT_TRUE(IsLowDiscrepancy(sample_number));
      EXPECT_EQ(PatternKey(sample_number, RandomUse::kGloss, 3), key);
    }
    EXPECT_NE(PatternKey(WithShift(0, pixel_key), RandomUse::kGloss, 4), key);
    EXPECT_NE(PatternKey(WithShift(0, pixel_key), RandomUse::kLensX, 3), key);
  }
  EXPECT_EQ(keys.size(), 100u);
  for (uint32_t number = 0; number <= 64; ++number) EXPECT_FALSE(IsLowDiscrepancy(number));
}

}  // namespace
}  // namespace rayshade
