// Parts of polygons against the winding number: at any point, a polygon winds as often as parts
// cover it.
#include "rayshade/accel/polygon_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rayshade {
namespace {

// Times that the closed path turns to the left around the point.
int Winding(std::span<const Vector> path, double x, double y) {
  int winding = 0;
  for (size_t i = 0; i < path.size(); ++i) {
    const Vector &a = path[i], &b = path[(i + 1) % path.size()];
    if ((a.y > y) == (b.y > y)) continue;
    const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    if (b.y > a.y && side > 0) ++winding;
    if (b.y < a.y && side < 0) --winding;
  }
  return winding;
}

// Returns how many parts there are.
size_t Check(const std::vector<Vector>& points) {
  const std::vector<PolygonPart> parts = CutIntoParts(points, {0, 0, 1});
  std::mt19937_64 bits(3);
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2);
  for (int i = 0; !parts.empty() && i < 2000; ++i) {
    const double x = coordinate(bits), y = coordinate(bits);
    int covered = 0;
    for (const PolygonPart& part : parts) {
      std::vector<Vector> corners;
      for (uint32_t k = 0; k < part.count; ++k) corners.push_back(points[part.corner[k]]);
      const int winding = Winding(corners, x, y);
      EXPECT_LE(std::abs(winding), 1);
      covered += winding;
    }
    EXPECT_EQ(covered, Winding(points, x, y)) << x << " " << y;
  }
  return parts.size();
}

TEST(PolygonParts, CoverEveryPointAsOftenAsThePolygonWinds) {
  std::mt19937_64 bits(11);
  std::uniform_real_distribution<double> radius(0.1, 1.1);
  for (int points = 4; points <= 40; ++points) {
    std::vector<Vector> star, back;
    for (int i = 0; i < points; ++i) {
      const double r = radius(bits), angle = 2 * 3.141592653589793 * i / points;
      star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
      back.insert(back.begin(), star.back());
    }
    EXPECT_GT(Check(star), 0u) << points;
    EXPECT_GT(Check(back), 0u) << points;
  }
}

TEST(PolygonParts, OfAHoleWithASeamAndOfPointsInARow) {
  const std::vector<Vector> frame = {{-1, -1, 0},  {1, -1, 0},    {1, 1, 0},    {-1, 1, 0},
                                     {-1, -1, 0},  {-.5, -.5, 0}, {-.5, .5, 0}, {.5, .5, 0},
                                     {.5, -.5, 0}, {-.5, -.5, 0}};
  EXPECT_GT(Check(frame), 0u);
  EXPECT_GT(Check({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {.3, 1, 0}, {0, 1, 0}}), 0u);
}

TEST(PolygonParts, OfARoundTableOfAHundredPoints) {
  std::vector<Vector> table;
  for (int i = 0; i < 100; ++i) {
    const double angle = 2 * 3.141592653589793 * i / 100;
    table.push_back({std::cos(angle), .4 * std::sin(angle), 0});
  }
  EXPECT_GT(Check(table), 0u);
}

TEST(PolygonParts, WhatWindsBothWaysOrHasTooManyPointsHasNone) {
  EXPECT_EQ(Check({{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, .9, 0}}), 0u);
  std::vector<Vector> circle;
  for (int i = 0; i < 200; ++i) circle.push_back({std::cos(.01 * i), std::sin(.01 * i), 0});
  EXPECT_EQ(Check(circle), 0u);
}

}  // namespace
}  // namespace rayshade
