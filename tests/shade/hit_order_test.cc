// The order of hits in rows.
#include "rayshade/shade/hit_order.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <set>
#include <vector>

#include "tests/support/random.h"

namespace rayshade {
namespace {

std::vector<SurfaceHit> HitsAt(const std::vector<Vector>& points) {
  std::vector<SurfaceHit> hits(points.size());
  for (size_t i = 0; i < points.size(); ++i) hits[i].point = points[i];
  return hits;
}

void ExpectPermutation(const HitOrder& order, size_t count) {
  std::set<size_t> seen;
  for (size_t row = 0; row < count; ++row) {
    ASSERT_LT(order.hit(row), count);
    EXPECT_EQ(order.row(order.hit(row)), row);
    seen.insert(order.hit(row));
  }
  EXPECT_EQ(seen.size(), count);
}

TEST(HitOrder, HoldsEachHitOnce) {
  test::Random random(5);
  for (size_t count = 0; count <= HitOrder::kMost; count += count < 70 ? 1 : 17) {
    std::vector<Vector> points;
    for (size_t i = 0; i < count; ++i) {
      const Vector p = test::RandomPoint(&random, 1);
      points.push_back({p.x, 5 * p.y, p.z});
    }
    const auto order = std::make_unique<HitOrder>();
    order->Set(HitsAt(points), true);
    ExpectPermutation(*order, count);
  }
}

TEST(HitOrder, BearsPointsThatAreTheSameOrNoNumbers) {
  const double odd[] = {0, 1e300, -1e300, std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()};
  std::vector<Vector> points(64, Vector{1, 2, 3});
  for (const double x : odd) {
    for (const double y : odd) points.push_back({x, y, 1});
  }
  const auto order = std::make_unique<HitOrder>();
  order->Set(HitsAt(points), true);
  ExpectPermutation(*order, points.size());
}

TEST(HitOrder, LeavesHitsAsTheyComeWhereItIsTold) {
  const auto order = std::make_unique<HitOrder>();
  std::vector<Vector> points;
  for (int i = 0; i < 100; ++i) points.push_back({i % 7 * 1.0, i % 3 * 1.0, 0});
  order->Set(HitsAt(points), false);
  for (size_t i = 0; i < points.size(); ++i) EXPECT_EQ(order->hit(i), i);
}

// Two walls that alternate in the picture: a group with hits on both makes a wide pyramid.
TEST(HitOrder, KeepsWhatLiesApartOutOfOneGroup) {
  std::vector<Vector> points;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 32; ++x) points.push_back({0.1 * x, 0.1 * y, x % 3 == 0 ? 10.0 : 0.0});
  }
  const auto order = std::make_unique<HitOrder>();
  order->Set(HitsAt(points), true);
  int mixed = 0;
  for (size_t row = 0; row < points.size(); row += 8) {
    std::set<double> walls;
    for (size_t i = row; i < row + 8; ++i) walls.insert(points[order->hit(i)].z);
    mixed += walls.size() > 1;
  }
  EXPECT_LE(mixed, 2);
}

}  // namespace
}  // namespace rayshade
