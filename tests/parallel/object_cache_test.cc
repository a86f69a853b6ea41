// Fetched cells under a budget.
#include "parallel/object_cache.h"

#include <gtest/gtest.h>

namespace rayshade::parallel {
namespace {

class ObjectCacheTest : public testing::Test {
 protected:
  ObjectCacheTest() : scene_(SceneSpec{}, 0) {
    Placement placement;
    placement.levels.resize(1);
    placement.Finish();
    scene_.spec.placements = {placement};
  }
  std::unique_ptr<ObjectSet> Spheres(int n) {
    auto set = std::make_unique<ObjectSet>(&scene_);
    for (int i = 0; i < n; ++i) set->Add(SphereSpec{1, {3.0 * i, 0, 0}}, 0, i + 1);
    set->Build();
    return set;
  }
  Scene scene_;
};

TEST_F(ObjectCacheTest, TheCellUsedLongestAgoGoesFirst) {
  const uint64_t one = Spheres(50)->bytes();
  ObjectCache cache(3 * one);
  for (CellId c : {10u, 11u, 12u}) cache.Put(c, Spheres(50));
  EXPECT_EQ(cache.bytes(), 3 * one);
  EXPECT_NE(cache.Find(10), nullptr);  // a use
  cache.Put(13, Spheres(50));
  EXPECT_TRUE(cache.Holds(10));
  EXPECT_FALSE(cache.Holds(11));
  EXPECT_EQ(cache.Find(11), nullptr);
  EXPECT_TRUE(cache.Holds(12));
  EXPECT_TRUE(cache.Holds(13));
  EXPECT_EQ(cache.bytes(), 3 * one);
}

TEST_F(ObjectCacheTest, TheCellPutInLastIsKeptHoweverLarge) {
  ObjectCache cache(1);
  cache.Put(1, Spheres(5));
  EXPECT_TRUE(cache.Holds(1));
  cache.Put(2, Spheres(9));
  EXPECT_FALSE(cache.Holds(1));
  EXPECT_TRUE(cache.Holds(2));
  EXPECT_EQ(cache.bytes(), Spheres(9)->bytes());
}

TEST_F(ObjectCacheTest, WithoutALimitNothingGoes) {
  ObjectCache cache(0);
  for (CellId c = 0; c < 40; ++c) cache.Put(c, Spheres(3));
  for (CellId c = 0; c < 40; ++c) EXPECT_TRUE(cache.Holds(c));
  EXPECT_EQ(cache.bytes(), 40 * Spheres(3)->bytes());
}

}  // namespace
}  // namespace rayshade::parallel
