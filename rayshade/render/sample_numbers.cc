// The tables of [rayshade4/1 s.8.5], rows of sub-cells from top to bottom.
#include "rayshade/render/sample_numbers.h"

#include <cstdint>

#include "rayshade/common/check.h"

namespace rayshade {
namespace {

// clang-format off
constexpr uint8_t kOne[] = {
    0};
constexpr uint8_t kTwo[] = {
    0, 2,
    3, 1};
constexpr uint8_t kThree[] = {
    0, 2, 7,
    6, 5, 1,
    3, 8, 4};
constexpr uint8_t kFour[] = {
    0, 8, 2, 10,
    12, 4, 14, 6,
    3, 11, 1, 9,
    15, 7, 13, 5};
constexpr uint8_t kFive[] = {
    0, 8, 23, 17, 2,
    19, 12, 4, 20, 15,
    3, 21, 16, 9, 6,
    14, 10, 24, 1, 13,
    22, 7, 18, 11, 5};
constexpr uint8_t kSix[] = {
    6, 32, 3, 34, 35, 1,
    7, 11, 27, 28, 8, 30,
    24, 14, 16, 15, 23, 19,
    13, 20, 22, 21, 17, 18,
    25, 29, 10, 9, 26, 12,
    36, 5, 33, 4, 2, 31};
constexpr uint8_t kSeven[] = {
    22, 47, 16, 41, 10, 35, 4,
    5, 23, 48, 17, 42, 11, 29,
    30, 6, 24, 49, 18, 36, 12,
    13, 31, 7, 25, 43, 19, 37,
    38, 14, 32, 1, 26, 44, 20,
    21, 39, 8, 33, 2, 27, 45,
    46, 15, 40, 9, 34, 3, 28};
constexpr uint8_t kEight[] = {
    8, 58, 59, 5, 4, 62, 63, 1,
    49, 15, 14, 52, 53, 11, 10, 56,
    41, 23, 22, 44, 45, 19, 18, 48,
    32, 34, 35, 29, 28, 38, 39, 25,
    40, 26, 27, 37, 36, 30, 31, 33,
    17, 47, 46, 20, 21, 43, 42, 24,
    9, 55, 54, 12, 13, 51, 50, 16,
    64, 2, 3, 61, 60, 6, 7, 57};
// clang-format on
constexpr const uint8_t* kTables[] = {kOne, kTwo, kThree, kFour, kFive, kSix, kSeven, kEight};

}  // namespace

int SampleNumber(int n, int sub_cell) {
  CHECK(n >= 1 && n <= 8 && sub_cell >= 0 && sub_cell < n * n);
  return kTables[n - 1][sub_cell];
}

}  // namespace rayshade
