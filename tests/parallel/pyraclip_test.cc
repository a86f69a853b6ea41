// PyraClip against testing every ray against every cell, and the order of cells along a ray.
#include "parallel/pyraclip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "parallel/cell_walk.h"
#include "rayshade/common/keyed_random.h"

namespace rayshade::parallel {
namespace {

struct Random {
  uint64_t key;
  uint32_t n = 0;
  double operator()(double low, double high) {
    return low + (high - low) * KeyedRandom(key, RandomUse::kTime, n++);
  }
  int Below(int limit) { return static_cast<int>((*this)(0, limit)); }
};

CellTree RandomTree(Random& random, int cells) {
  CellTree tree({{-3, -2, -1}, {4, 5, 6}});
  for (int i = 1; i < cells; ++i) {
    const CellId cell = static_cast<CellId>(random.Below(static_cast<int>(tree.size())));
    const int axis = random.Below(3);
    const Bounds box = tree.Boxes()[cell];
    tree.Cut(cell, axis, box.low[axis] + random(0.2, 0.8) * (box.high[axis] - box.low[axis]));
  }
  return tree;
}

std::vector<Ray> RandomBundle(Random& random) {
  const Vector eye{random(-6, 6), random(-6, 6), random(-6, 6)};
  const Vector aim{random(-3, 4), random(-2, 5), random(-1, 6)};
  const double spread = random(0, 1.5), lens = random(0, 1) < 0.5 ? 0 : 0.5;
  std::vector<Ray> rays(20);
  for (Ray& ray : rays) {
    ray.origin = eye + lens * Vector{random(-1, 1), random(-1, 1), random(-1, 1)};
    ray.direction =
        Normalized(aim + spread * Vector{random(-1, 1), random(-1, 1), random(-1, 1)} - ray.origin);
    if (random(0, 1) < 0.1) ray.direction = {0, 1, 0};
  }
  return rays;
}

TEST(PyraClip, MissesNoCellThatARayOfTheBundleMeets) {
  size_t met = 0;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Random random{seed};
    const CellTree tree = RandomTree(random, 60);
    const auto boxes = tree.Boxes();
    const std::vector<Ray> rays = RandomBundle(random);
    const auto list = PyraClip(tree, Pyramid::Around(rays), kFar, [](uint32_t) { return false; });
    for (CellId c = 0; c < tree.size(); ++c) {
      const auto clipped =
          std::find_if(list.begin(), list.end(), [c](const ClippedCell& l) { return l.cell == c; });
      for (const Ray& ray : rays) {
        const RayInterval interval = Intersect(boxes[c], ray.origin, ray.direction);
        if (interval.empty() || interval.exit < 0) continue;
        ++met;
        ASSERT_NE(clipped, list.end()) << "seed " << seed << " cell " << c;
        EXPECT_LE(clipped->entry, interval.entry);
      }
    }
  }
  EXPECT_GT(met, 10000u);
}

TEST(PyraClip, ListsCellsInDepthOrder) {
  Random random{5};
  const CellTree tree = RandomTree(random, 100);
  const std::vector<Ray> rays = RandomBundle(random);
  const auto list = PyraClip(tree, Pyramid::Around(rays), kFar, [](uint32_t) { return false; });
  ASSERT_GT(list.size(), 5u);
  EXPECT_TRUE(std::is_sorted(list.begin(), list.end(),
                             [](const auto& a, const auto& b) { return a.entry < b.entry; }));
}

TEST(PyraClip, LeavesOutCellsFarFromANarrowPyramid) {
  Random random{7};
  const CellTree tree = RandomTree(random, 400);
  std::vector<Ray> rays(2);
  for (Ray& ray : rays) ray.origin = {-6, 1, 2};
  rays[0].direction = Normalized({1, .01, 0});
  rays[1].direction = Normalized({1, 0, .01});
  EXPECT_LT(PyraClip(tree, Pyramid::Around(rays), kFar, [](uint32_t) { return false; }).size(),
            tree.size() / 5);
}

TEST(CellWalk, VisitsEveryCellOfTheRayOnceInOrderOfEntryAndId) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    Random random{seed};
    const CellTree tree = RandomTree(random, 80);
    const auto boxes = tree.Boxes();
    Ray ray = RandomBundle(random)[0];
    if (seed % 3 == 0) {  // along planes of the subdivision
      const CellNode& n = tree.nodes()[0];
      ray.origin[n.axis] = n.plane;
      ray.direction[n.axis] = 0;
      Normalize(&ray.direction);
    }
    std::vector<std::pair<double, CellId>> walked, expected;
    CellWalk walk(&tree);
    walk.Visit(
        ray.origin, ray.direction, kFar, [](uint32_t) { return false; },
        [](CellId, const RayInterval&) { return false; });  // an earlier ray leaves nothing behind
    walk.Visit(
        ray.origin, ray.direction, kFar, [](uint32_t) { return false; },
        [&](CellId cell, const RayInterval& interval) {
          walked.emplace_back(interval.entry, cell);
          return true;
        });
    for (CellId c = 0; c < tree.size(); ++c) {
      const RayInterval interval = Intersect(boxes[c], ray.origin, ray.direction);
      if (!interval.empty() && interval.exit >= 0) expected.emplace_back(interval.entry, c);
    }
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(walked, expected) << "seed " << seed;
  }
}

TEST(CellTree, ObjectsOnABorderBelongToBothSides) {
  CellTree tree({{0, 0, 0}, {2, 2, 2}});
  const CellId high = tree.Cut(0, 0, 1);
  std::set<CellId> cells;
  tree.ForEachOver({{1, .5, .5}, {1.5, 1, 1}}, [&](CellId c) { cells.insert(c); });
  EXPECT_EQ(cells, (std::set<CellId>{0, high}));
}

}  // namespace
}  // namespace rayshade::parallel
