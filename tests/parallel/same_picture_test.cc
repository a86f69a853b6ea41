// The oracle: for every schedule, process count, budget, cache size and order of messages the
// picture is the sequential one, and so are the rays.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

constexpr Schedule kSchedules[] = {Schedule::kDataParallel, Schedule::kDemandDriven,
                                   Schedule::kHybrid};

void ExpectSame(const std::string& text, const TestPicture& sequential, const RunOptions& options,
                uint64_t seed) {
  SCOPED_TRACE(std::string(Name(options.schedule)) + ", " + std::to_string(options.processes) +
               " processes, seed " + std::to_string(seed));
  TestPicture parallel;
  ASSERT_NO_THROW(parallel = RenderInParallel(text, options, seed));
  EXPECT_TRUE(Identical(sequential.picture, parallel.picture));
  EXPECT_EQ(sequential.counts.primary_rays, parallel.counts.primary_rays);
  EXPECT_EQ(sequential.counts.shadow_rays, parallel.counts.shadow_rays);
  EXPECT_EQ(sequential.counts.reflected_rays, parallel.counts.reflected_rays);
  EXPECT_EQ(sequential.counts.refracted_rays, parallel.counts.refracted_rays);
  EXPECT_EQ(sequential.counts.hits, parallel.counts.hits);
}

// Small cells, so that small scenes have many.
RunOptions SmallCells(Schedule schedule, int processes) {
  RunOptions options;
  options.schedule = schedule;
  options.processes = static_cast<uint16_t>(processes);
  options.cell_bytes = 2000;
  options.pyramid = 64;
  return options;
}

class EverySchedule : public testing::TestWithParam<Schedule> {};

TEST_P(EverySchedule, AnyNumberOfProcessesMakesTheSequentialPictureOfTheBalls) {
  const std::string text = Balls(3, 48);
  const TestPicture sequential = RenderSequentially(text);
  for (int processes : {1, 2, 3, 4, 7, 8, 16, 24, 32}) {
    ExpectSame(text, sequential, SmallCells(GetParam(), processes), processes);
  }
}

TEST(ShadowsThatTravel, MakeTheSequentialPicture) {
  for (const std::string& text : {Balls(3, 40), GlassScene()}) {
    const TestPicture sequential = RenderSequentially(text);
    for (const Schedule schedule : {Schedule::kDataParallel, Schedule::kHybrid}) {
      for (int processes : {1, 2, 5, 8}) {
        RunOptions options = SmallCells(schedule, processes);
        options.shadows = Shadows::kTravel;
        ExpectSame(text, sequential, options, processes);
      }
    }
  }
}

TEST(ShadowsThatTravel, AreAnsweredOnceEachAndNoCellIsFetched) {
  RunOptions options = SmallCells(Schedule::kDataParallel, 8);
  options.shadows = Shadows::kTravel;
  const TestPicture run = RenderInParallel(Balls(3, 48), options, 1);
  EXPECT_GT(run.messages[static_cast<int>(Tag::kShadowTask)], 0u);
  EXPECT_GT(run.messages[static_cast<int>(Tag::kShadowResults)], 0u);
  EXPECT_EQ(run.messages[static_cast<int>(Tag::kCellRequest)], 0u);
}

TEST_P(EverySchedule, AnyResidentSetAndCacheMakesTheSequentialPicture) {
  const std::string text = Balls(3, 32);
  const TestPicture sequential = RenderSequentially(text);
  for (uint64_t resident : {0, 6000, 10000000}) {
    for (uint64_t cache : {1, 20000, 0}) {
      RunOptions options = SmallCells(GetParam(), 5);
      options.resident = resident;
      options.cache = cache;
      ExpectSame(text, sequential, options, resident + cache);
    }
  }
}

TEST_P(EverySchedule, AnyPyramidMakesTheSequentialPicture) {
  const std::string text = Balls(2, 40);
  const TestPicture sequential = RenderSequentially(text);
  for (uint32_t pyramid : {1, 64, 1024}) {
    RunOptions options = SmallCells(GetParam(), 4);
    options.pyramid = pyramid;
    ExpectSame(text, sequential, options, pyramid);
  }
}

TEST_P(EverySchedule, AnyOrderOfEventsMakesTheSequentialPicture) {
  const std::string text = Balls(2, 24);
  const TestPicture sequential = RenderSequentially(text);
  for (uint64_t seed = 0; seed < 40; ++seed) {
    RunOptions options = SmallCells(GetParam(), 2 + seed % 5);
    options.cell_bytes = 500 + 300 * (seed % 7);
    options.cache = seed % 2 == 0 ? 1 : 0;
    ExpectSame(text, sequential, options, seed);
  }
}

TEST_P(EverySchedule, LargerBallsMakeTheSequentialPicture) {
  for (int size : {4, 5}) {
    const std::string text = Balls(size, 40);
    const TestPicture sequential = RenderSequentially(text);
    RunOptions options = SmallCells(GetParam(), size == 4 ? 8 : 5);
    options.cell_bytes = 64 << 10;
    options.cache = 300000;
    options.resident = 200000;
    ExpectSame(text, sequential, options, size);
  }
}

TEST_P(EverySchedule, TheRoomMakesTheSequentialPicture) {
  const std::string text = Room(32);
  const TestPicture sequential = RenderSequentially(text);
  EXPECT_GT(sequential.counts.reflected_rays, 0u);
  for (int processes : {1, 6}) {
    RunOptions options = SmallCells(GetParam(), processes);
    options.cell_bytes = 64 << 10;
    options.cache = 400000;
    ExpectSame(text, sequential, options, processes);
  }
}

TEST_P(EverySchedule, HardScenesMakeTheSequentialPicture) {
  for (const auto& [name, text] : HardScenes()) {
    SCOPED_TRACE(name);
    const TestPicture sequential = RenderSequentially(text);
    for (int processes : {1, 2, 8, 12}) {
      RunOptions options = SmallCells(GetParam(), processes);
      options.cell_bytes = 300;
      options.cache = 1;
      ExpectSame(text, sequential, options, processes);
    }
  }
}

TEST_P(EverySchedule, MirrorsFacingAcrossABorderFinishWithOneRayInFlight) {
  const std::string text = FacingMirrors();
  const TestPicture sequential = RenderSequentially(text);
  for (uint64_t seed = 0; seed < 5; ++seed) {
    RunOptions options = SmallCells(GetParam(), 2);
    options.cell_bytes = 200;
    options.rays_in_flight = 1;
    options.cache = 1;
    ExpectSame(text, sequential, options, seed);
  }
}

TEST_P(EverySchedule, GlassAndColouredShadowsMakeTheSequentialPicture) {
  const std::string text = GlassScene();
  const TestPicture sequential = RenderSequentially(text);
  for (int processes : {1, 3, 8}) {
    RunOptions options = SmallCells(GetParam(), processes);
    options.cell_bytes = 300;
    ExpectSame(text, sequential, options, processes);
    options.cache = 1;
    ExpectSame(text, sequential, options, processes + 100);
  }
}

TEST_P(EverySchedule, AdaptiveSamplingMakesTheSequentialPicture) {
  std::string text = Balls(1, 24);
  text.replace(text.find("sample 1 nojitter"), 17, "sample 2 jitter");
  text.replace(text.find("contrast 1 1 1"), 14, "contrast .2 .2 .2");
  const TestPicture sequential = RenderSequentially(text);
  const TestPicture parallel = RenderInParallel(text, SmallCells(GetParam(), 3), 1);
  EXPECT_TRUE(Identical(sequential.picture, parallel.picture));
}

TEST(SamePicture, InstancesAreStoredOncePerProcess) {
  const std::string text = InstanceScene();
  const TestPicture sequential = RenderSequentially(text);
  for (Schedule schedule : kSchedules) ExpectSame(text, sequential, SmallCells(schedule, 4), 3);
}

INSTANTIATE_TEST_SUITE_P(Schedules, EverySchedule, testing::ValuesIn(kSchedules),
                         [](const auto& info) {
                           switch (info.param) {
                             case Schedule::kDataParallel:
                               return "DataParallel";
                             case Schedule::kDemandDriven:
                               return "DemandDriven";
                             default:
                               return "Hybrid";
                           }
                         });

}  // namespace
}  // namespace rayshade::parallel
