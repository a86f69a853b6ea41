// The scheduling policy: what goes first, who asks, who forwards.
#include "parallel/work_queue.h"

#include <gtest/gtest.h>

namespace rayshade::parallel {
namespace {

Ray OfDepth(uint16_t depth) {
  Ray ray;
  ray.depth = depth;
  return ray;
}

TEST(WorkQueue, TheDeepestRaysComeFirst) {
  WorkQueue queue;
  for (uint16_t depth : {0, 2, 1, 2, 0}) queue.Push(OfDepth(depth), {}, {});
  EXPECT_EQ(queue.size(), 5u);
  std::vector<size_t> depths;
  for (RayQueue rays; queue.PopAny(&rays); rays.clear()) {
    for (const Ray& ray : rays.bundle.rays) depths.push_back(ray.depth);
  }
  EXPECT_EQ(depths, (std::vector<size_t>{2, 2, 1, 0, 0}));
  EXPECT_EQ(queue.size(), 0u);
}

TEST(WorkQueue, FewDeepRaysWaitForMore) {
  WorkQueue queue;
  queue.Push(OfDepth(3), {}, {});
  for (size_t i = 0; i < kRaysWorthAStep; ++i) queue.Push(OfDepth(1), {}, {});
  RayQueue rays;
  ASSERT_TRUE(queue.PopEnough(&rays));
  EXPECT_EQ(rays.size(), kRaysWorthAStep);
  EXPECT_EQ(rays.bundle.rays[0].depth, 1);
  rays.clear();
  EXPECT_FALSE(queue.PopEnough(&rays));
  EXPECT_TRUE(queue.PopAny(&rays));
  EXPECT_EQ(rays.bundle.rays[0].depth, 3);
}

TEST(WorkQueue, AStepTakesNoMoreThanItsLimit) {
  WorkQueue queue;
  for (size_t i = 0; i < kRaysPerStep + 10; ++i) queue.Push(OfDepth(1), {}, {});
  RayQueue rays;
  EXPECT_TRUE(queue.PopAny(&rays));
  EXPECT_EQ(rays.size(), kRaysPerStep);
  EXPECT_EQ(queue.size(), 10u);
}

TEST(WorkQueue, RaysKeepTheirMedia) {
  WorkQueue queue;
  const Medium media[] = {{1.5, .9}, {1.2, .8}};
  queue.Push(OfDepth(1), media, {});
  queue.Push(OfDepth(1), {}, {});
  queue.Push(OfDepth(1), std::span(media).subspan(1), {});
  RayQueue rays;
  ASSERT_TRUE(queue.PopAny(&rays));
  ASSERT_EQ(rays.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    const auto of_ray = rays.media(i);
    EXPECT_TRUE(of_ray.empty() || of_ray[0] == media[2 - of_ray.size()]);
  }
  EXPECT_EQ(rays.bundle.media.size(), 3u);
}

TEST(WorkQueue, TheSchedulesDifferInWhoAsksAndWhatTravels) {
  EXPECT_FALSE(AsksForWork(Schedule::kDataParallel));
  EXPECT_TRUE(AsksForWork(Schedule::kDemandDriven));
  EXPECT_TRUE(AsksForWork(Schedule::kHybrid));
  EXPECT_TRUE(ForwardsRays(Schedule::kDataParallel) && TransfersHits(Schedule::kDataParallel));
  EXPECT_FALSE(ForwardsRays(Schedule::kDemandDriven) || TransfersHits(Schedule::kDemandDriven));
  EXPECT_TRUE(ForwardsRays(Schedule::kHybrid) && TransfersHits(Schedule::kHybrid));
}

TEST(WorkQueue, AProcessIsShortOfWorkWithLessThanTwoPyramids) {
  EXPECT_TRUE(ShortOfWork(0, 0, 1)) << "also of pyramids of one ray";
  EXPECT_TRUE(ShortOfWork(127, 0, 64));
  EXPECT_FALSE(ShortOfWork(128, 0, 64));
  EXPECT_FALSE(ShortOfWork(0, 128, 64)) << "rays that wait for cells do not pile up";
}

}  // namespace
}  // namespace rayshade::parallel
