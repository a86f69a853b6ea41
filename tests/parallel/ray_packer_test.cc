// Rays and results travel packed.
#include "parallel/ray_packer.h"

#include <gtest/gtest.h>

#include "tests/support/recorded_run.h"

namespace rayshade::parallel {
namespace {

class RayPackerTest : public testing::Test {
 protected:
  std::vector<SentMessage> sent_;
  RecordingOutbox outbox_{1, &sent_};
  RayPacker packer_{3};
};

Ray Secondary(double x) {
  Ray ray;
  ray.kind = RayKind::kReflected;
  ray.depth = 1;
  ray.origin = {x, 0, 0};
  return ray;
}

TEST_F(RayPackerTest, NothingIsSentBeforeAPackIsFullOrFlushed) {
  packer_.AddRay(2, Secondary(1), {}, {}, &outbox_);
  packer_.AddRay(3, Secondary(2), {}, {}, &outbox_);
  packer_.AddResult(2, {5, {1, 0, 0}, 2}, &outbox_);
  packer_.AddVoid(9, &outbox_);
  packer_.AddPixel({8, {0, 1, 0}}, true, &outbox_);
  EXPECT_TRUE(sent_.empty());
  packer_.Flush(&outbox_);
  ASSERT_EQ(sent_.size(), 4u);
  std::map<ProcessId, size_t> rays;
  for (const SentMessage& s : sent_) {
    if (s.tag == Tag::kRayTask) rays[s.to] += Decode<RayTask>(s.bytes).travel.size();
    EXPECT_TRUE(s.tag != Tag::kRayResults || s.to == 2);
    if (s.tag == Tag::kPixelResults) {
      EXPECT_EQ(s.to, kHost);
      EXPECT_EQ(RecordedRun::Pixels(s).size(), 2u);
    }
  }
  EXPECT_EQ(rays, (std::map<ProcessId, size_t>{{2, 1}, {3, 1}}));
  sent_.clear();
  packer_.Flush(&outbox_);
  EXPECT_TRUE(sent_.empty());
}

TEST_F(RayPackerTest, PixelsStayWhenTheRestIsFlushed) {
  packer_.AddRay(2, Secondary(1), {}, {}, &outbox_);
  packer_.AddVoid(9, &outbox_);
  packer_.FlushRays(&outbox_);
  ASSERT_EQ(sent_.size(), 1u);
  EXPECT_EQ(sent_[0].tag, Tag::kRayTask);
  EXPECT_EQ(packer_.size(), 1u);
}

TEST_F(RayPackerTest, APackIsFullAtSomeKilobytes) {
  for (int i = 0; i < 1000; ++i) packer_.AddRay(2, Secondary(i), {}, {}, &outbox_);
  ASSERT_GT(sent_.size(), 3u);
  EXPECT_LT(sent_.size(), 100u);
  packer_.Flush(&outbox_);
  double next = 0;
  for (const SentMessage& s : sent_) {
    EXPECT_LT(s.bytes.size(), 20000u);
    for (const Ray& ray : Decode<RayTask>(s.bytes).bundle.rays) EXPECT_EQ(ray.origin.x, next++);
  }
  EXPECT_EQ(next, 1000);
}

TEST_F(RayPackerTest, PrimaryRaysTravelAsTheirSamples) {
  Ray primary;
  Travel travel;
  travel.back = {kHost, TokenOf({7, 8, 0, true})};
  travel.resume = 4;
  travel.best_distance = 2.5;
  travel.best_rank = 11;
  packer_.AddIntersection(2, primary, {}, travel, &outbox_);
  packer_.Flush(&outbox_);
  ASSERT_EQ(sent_.size(), 1u);
  const IntersectionTask task = Decode<IntersectionTask>(sent_[0].bytes);
  EXPECT_TRUE(task.bundle.empty());
  ASSERT_EQ(task.primary.size(), 1u);
  EXPECT_EQ(SampleOf(task.primary[0].token), (Sample{7, 8, 0, true}));
  EXPECT_EQ(task.primary[0].resume, 4u);
  EXPECT_EQ(task.primary[0].best_distance, 2.5);
  EXPECT_EQ(task.primary[0].best_rank, 11u);
}

TEST_F(RayPackerTest, RaysKeepTheirMedia) {
  const Medium glass[] = {{1.5, .9}};
  packer_.AddRay(2, Secondary(0), {}, {}, &outbox_);
  Ray inside = Secondary(1);
  inside.media_count = 1;
  packer_.AddRay(2, inside, glass, {}, &outbox_);
  packer_.Flush(&outbox_);
  const RayTask task = Decode<RayTask>(sent_.at(0).bytes);
  EXPECT_EQ(task.bundle.rays[0].media_count, 0);
  ASSERT_EQ(task.bundle.rays[1].media_count, 1);
  EXPECT_EQ(task.bundle.media[task.bundle.rays[1].media_begin], glass[0]);
}

}  // namespace
}  // namespace rayshade::parallel
