// A trace process among messages that make no sense: each is an error, and none does harm.
#include "parallel/trace_process.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/hand_driven_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

RunOptions Options(Schedule schedule) {
  RunOptions options;
  options.schedule = schedule;
  options.processes = 3;
  options.cell_bytes = 2000;
  options.pyramid = 16;
  return options;
}

// Carries the messages of a whole run; before each one its receiver gets what mangle makes of it.
template <class Mangle>
Picture RunWith(const std::string& text, Schedule schedule, Mangle mangle) {
  HandDrivenRun run(text, Options(schedule));
  std::deque<SentMessage> under_way;
  size_t number = 0;
  while (!run.host->finished()) {
    for (ProcessId p = 0; p <= 3; ++p) {
      for (SentMessage& s : run.Work(p)) under_way.push_back(std::move(s));
    }
    if (under_way.empty()) {
      ADD_FAILURE() << "the run hangs";
      break;
    }
    while (!under_way.empty()) {
      const SentMessage s = std::move(under_way.front());
      under_way.pop_front();
      const std::vector<uint8_t> bad = mangle(number++, s.bytes);
      EXPECT_THROW(run.Tell(s.from, s.to, std::span<const uint8_t>(bad)), WireError)
          << NameOf(s.tag);
      for (SentMessage& answer : run.Tell(s)) under_way.push_back(std::move(answer));
    }
  }
  return run.host->sampling().picture();
}

TEST(TraceProcess, TruncatedMessagesLeaveItUnharmed) {
  const std::string text = Balls(1, 12);
  const TestPicture sequential = RenderSequentially(text);
  for (Schedule schedule : {Schedule::kDataParallel, Schedule::kDemandDriven, Schedule::kHybrid}) {
    const Picture picture =
        RunWith(text, schedule, [](size_t n, const std::vector<uint8_t>& bytes) {
          return std::vector<uint8_t>(bytes.begin(), bytes.begin() + n * 7919 % bytes.size());
        });
    EXPECT_TRUE(Identical(picture, sequential.picture)) << Name(schedule);
  }
}

TEST(TraceProcess, MessagesThatAreTooLongLeaveItUnharmed) {
  const std::string text = GlassScene();
  const Picture picture =
      RunWith(text, Schedule::kHybrid, [](size_t, const std::vector<uint8_t>& bytes) {
        std::vector<uint8_t> longer = bytes;
        longer.push_back(7);
        return longer;
      });
  EXPECT_TRUE(Identical(picture, RenderSequentially(text).picture));
}

class RunningProcess : public testing::Test {
 protected:
  RunningProcess() : run_(Balls(2, 8), Options(Schedule::kHybrid)) { run_.SetUpAll(); }
  template <class Message>
  void ExpectRefused(const Message& message, const char* why) {
    EXPECT_THROW(run_.Tell(2, 1, message), WireError) << why;
  }
  CellId CellOf(ProcessId owner) const {
    const CellTree& tree = run_.host->tree();
    for (CellId c = 0; c < tree.size(); ++c) {
      if (tree.cell(c).owner == owner && tree.cell(c).objects > 0) return c;
    }
    return kNoCell;
  }
  HandDrivenRun run_;
};

TEST_F(RunningProcess, TracesFirstWhatCameFirst) {
  // Corners that see nothing, more than a step of each.
  const std::vector<uint64_t> corners = {TokenOf({0, 0, 0, false}), TokenOf({7, 0, 0, false})};
  std::vector<uint64_t> told, voids;
  for (const uint64_t corner : corners) {
    PrimaryRays pyramid;
    for (int i = 0; i < 1000; ++i) pyramid.samples.Add(corner);
    run_.Tell(kHost, 1, pyramid);
    told.insert(told.end(), 1000, corner);
  }
  for (const SentMessage& s : run_.Work(1)) {
    if (s.tag != Tag::kPixelResults) continue;
    const auto some = Decode<PixelResults>(s.bytes).voids.tokens();
    voids.insert(voids.end(), some.begin(), some.end());
  }
  EXPECT_EQ(voids, told);
}

TEST_F(RunningProcess, RefusesWhatMakesNoSense) {
  ExpectRefused(CellRequest{CellOf(2)}, "not its own cell");
  ExpectRefused(CellRequest{999999}, "no cell");
  ExpectRefused(CellReply{CellOf(2), {}}, "a cell that was not asked for");
  ExpectRefused(RayResults{{{4, {}, 1}}}, "a result for no intersection");
  ExpectRefused(PrimaryRays{{TokenOf({1, 1, 9, false})}},
                "a sample that the picture does not have");
  ExpectRefused(Distributed{}, "distributed twice");
  ExpectRefused(Objects{}, "objects after the distribution");
  ExpectRefused(WorkRequest{}, "not for a trace process");

  RayTask task;
  task.bundle.rays.resize(1);
  task.bundle.rays[0].direction = {0, 0, 1};
  task.bundle.rays[0].kind = RayKind::kReflected;
  task.travel.resize(1);
  task.travel[0].back = {77, 0};
  ExpectRefused(task, "a ray of no process");
  task.travel[0].back = {2, 0};
  task.travel[0].resume = 999999;
  ExpectRefused(task, "a ray that goes on in no cell");
  task.travel[0].resume = kNoCell;
  task.bundle.media.resize(1);
  ExpectRefused(task, "a medium of no ray");

  ShadowTask shadows;
  shadows.rays.resize(1);
  shadows.rays[0].ray.kind = RayKind::kShadow;
  shadows.rays[0].back = {77, 0};
  ExpectRefused(shadows, "a shadow ray of no process");
  shadows.rays[0].back = {2, 0};
  shadows.rays[0].resume = 999999;
  ExpectRefused(shadows, "a shadow ray that goes on in no cell");
  shadows.rays[0].resume = 0;
  shadows.rays[0].crossings.resize(1);
  shadows.rays[0].crossings[0].distance = std::nan("");
  ExpectRefused(shadows, "a shadow ray that crosses nowhere");
  ExpectRefused(ShadowResults{{{7, true, {}}}}, "a result for no shadow ray");

  IntersectionTask hit;
  hit.bundle.rays.resize(1);
  hit.bundle.rays[0].origin = {1e6, 0, 0};
  hit.travel.resize(1);
  hit.travel[0].best_distance = 1;
  ExpectRefused(hit, "a hit outside of its voxel");

  EXPECT_EQ(run_.Tell(2, 1, CellRequest{CellOf(1)}).size(), 1u) << "it answers as before";
}

// What the cost model multiplies: rays that the host or another has sent or that are spawned here,
// and once more those that are handed on.
TEST(TraceProcess, CountsRaysThatItTakesUpSpawnsAndHandsOn) {
  HandDrivenRun run(Balls(2, 16), Options(Schedule::kDataParallel));
  uint64_t from_host = 0, handed_on = 0, spawned = 0, handled = 0;
  std::deque<SentMessage> under_way;
  const auto carry = [&](const std::vector<SentMessage>& messages) {
    under_way.insert(under_way.end(), messages.begin(), messages.end());
  };
  const auto rays_of = [](const TravellingRays& rays) {
    return rays.primary.size() + rays.bundle.size();
  };
  while (!run.host->finished()) {
    for (ProcessId p = 0; p <= 3; ++p) carry(run.Work(p));
    ASSERT_FALSE(under_way.empty()) << "the run hangs";
    while (!under_way.empty()) {
      const SentMessage s = std::move(under_way.front());
      under_way.pop_front();
      if (s.tag == Tag::kRayTask) {
        (s.from == kHost ? from_host : handed_on) += rays_of(Decode<RayTask>(s.bytes));
      }
      carry(run.Tell(s));
    }
  }
  for (const auto& trace : run.trace) {
    spawned += trace->work_done().counts.reflected_rays;
    handled += trace->work_done().rays_handled;
  }
  EXPECT_GT(handed_on, 0u);
  EXPECT_EQ(handled, from_host + spawned + 2 * handed_on);
}

TEST(TraceProcess, KnowsNothingBeforeItsSetUp) {
  HandDrivenRun run(Balls(1, 8), Options(Schedule::kHybrid));
  EXPECT_THROW(run.Tell(0, 1, Objects{}), WireError);
  EXPECT_THROW(run.Tell(2, 1, CellRequest{0}), WireError);
  EXPECT_FALSE(run.trace[0]->finished());
  EXPECT_EQ(run.Tell(0, 1, Stop{}).size(), 1u) << "but it can be stopped";
  EXPECT_TRUE(run.trace[0]->finished());
}

TEST_F(RunningProcess, ASetUpThatMakesNoSenseLeavesTheEarlierOne) {
  parallel::SetUp set_up;
  set_up.options = Options(Schedule::kHybrid);
  set_up.tree.cell(0).owner = 9;
  ExpectRefused(set_up, "a cell without an owner");
  EXPECT_EQ(run_.Tell(2, 1, CellRequest{CellOf(1)}).size(), 1u);
}

}  // namespace
}  // namespace rayshade::parallel
