// What the invariants of a run object to.
#include "parallel/sim/invariants.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "parallel/object_spool.h"
#include "parallel/sim/fault_plan.h"
#include "parallel/work_queue.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

class InvariantsOfARun : public testing::Test {
 protected:
  void SetUp() override {
    ParseText(FacingMirrors(), &spool_);
    spool_.Place(0);
    options_.processes = 3;
    processes_ = std::make_unique<RunProcesses>(options_, &spool_, 0);
    timing_ = std::make_unique<FaultTiming>(PlanFaults(1), processes_->all.size());
    simulator_ = std::make_unique<Simulator>(processes_->all, timing_.get());
    invariants_ = std::make_unique<Invariants>(options_, processes_.get(), simulator_.get());
  }

  template <class Message>
  void Send(ProcessId from, ProcessId to, const Message& message) {
    invariants_->OnSend({from, to, Encode(message)});
  }
  template <class Message>
  void Take(ProcessId from, ProcessId to, const Message& message) {
    invariants_->OnTake({from, to, Encode(message)});
  }
  template <class Message>
  void ExpectBroken(ProcessId from, ProcessId to, const Message& message, const std::string& what) {
    try {
      Send(from, to, message);
      ADD_FAILURE() << "nothing was objected to; expected: " << what;
    } catch (const BrokenInvariant& e) {
      EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
    }
  }

  static RayTask Primary(uint64_t token) {
    RayTask task;
    PrimaryTravel travel;
    travel.token = token;
    task.primary.push_back(travel);
    return task;
  }
  static RayTask Secondary(ProcessId spawner, uint64_t token) {
    RayTask task;
    task.bundle.rays.emplace_back().kind = RayKind::kReflected;
    task.travel.emplace_back().back = {spawner, token};
    return task;
  }
  static ShadowTask Shadow(ProcessId spawner, uint64_t token) {
    ShadowTask task;
    task.rays.emplace_back().back = {spawner, token};
    return task;
  }
  static ShadowResults Arrives(uint64_t token) {
    ShadowResults results;
    results.results.push_back({token, true, {}});
    return results;
  }
  static PixelResults Void(uint64_t token) {
    PixelResults results;
    results.voids.Add(token);
    return results;
  }

  ObjectSpool spool_;
  RunOptions options_;
  std::unique_ptr<RunProcesses> processes_;
  std::unique_ptr<FaultTiming> timing_;
  std::unique_ptr<Simulator> simulator_;
  std::unique_ptr<Invariants> invariants_;
};

TEST_F(InvariantsOfARun, APrimaryRayHasOneResult) {
  Send(kHost, 1, Primary(5));
  Take(kHost, 1, Primary(5));
  Send(1, kHost, Void(5));
  ExpectBroken(1, kHost, Void(5), "primary ray 5 is answered twice");
}

TEST_F(InvariantsOfARun, ARayIsHandedOutOnce) {
  Send(kHost, 1, Primary(5));
  ExpectBroken(kHost, 2, Primary(5), "primary ray 5 is there twice");
}

TEST_F(InvariantsOfARun, ARayIsHandedOnOnlyByWhoHasIt) {
  Send(1, 2, Secondary(1, 8));
  ExpectBroken(2, 3, Secondary(1, 8), "is not with its sender");  // not taken in yet
  Take(1, 2, Secondary(1, 8));
  ExpectBroken(3, 2, Secondary(1, 8), "is not with its sender");
  Send(2, 3, Secondary(1, 8));
  Take(2, 3, Secondary(1, 8));
  Send(3, 1, Secondary(1, 8));
  Take(3, 1, Secondary(1, 8));  // at home: its slot may be used again
  Send(1, 2, Secondary(1, 8));
}

TEST_F(InvariantsOfARun, ASlotHasOneAnswer) {
  RayResults results;
  results.results.emplace_back().token = 8;
  ExpectBroken(2, 1, results, "is answered twice or by a stranger");
  Send(1, 2, Secondary(1, 8));
  Take(1, 2, Secondary(1, 8));
  Send(2, 1, results);
  ExpectBroken(2, 1, results, "is answered twice or by a stranger");
}

TEST_F(InvariantsOfARun, AShadowRayThatTravelsHasOneAnswer) {
  ExpectBroken(2, 1, Arrives(8), "is answered twice or by a stranger");
  Send(1, 2, Shadow(1, 8));
  ExpectBroken(1, 3, Shadow(1, 8), "is not with its sender");
  ExpectBroken(2, 1, Arrives(8), "is answered twice or by a stranger");  // not taken in yet
  Take(1, 2, Shadow(1, 8));
  Send(2, 1, Shadow(1, 8));  // by way of its spawner
  Take(2, 1, Shadow(1, 8));
  Send(1, 3, Shadow(1, 8));
  Take(1, 3, Shadow(1, 8));
  EXPECT_THROW(invariants_->AtEnd(), BrokenInvariant);
  Send(3, 1, Arrives(8));
  ExpectBroken(3, 1, Arrives(8), "is answered twice or by a stranger");
}

TEST_F(InvariantsOfARun, RequestsAreFewAndAnsweredOnce) {
  ExpectBroken(kHost, 1, PrimaryRays(), "which has not asked");
  ExpectBroken(2, 1, CellReply(), "a cell that was not asked for");
  Send(1, 2, CellRequest{0});
  ExpectBroken(1, 2, CellRequest{0}, "a cell is asked for twice");
  for (int i = 0; i < kRequestsAhead; ++i) Send(3, kHost, WorkRequest());
  ExpectBroken(3, kHost, WorkRequest(), "asks for more work than it may");
}

TEST_F(InvariantsOfARun, WhoHasStoppedIsSilentAndLeftAlone) {
  Send(1, kHost, Statistics());
  ExpectBroken(1, 2, Secondary(1, 8), "which had stopped");
  ExpectBroken(2, 1, Secondary(2, 8), "which has stopped");
}

TEST_F(InvariantsOfARun, PrimaryRaysInFlightAreSomewhere) {
  Send(1, 2, Secondary(1, 8));  // a ray that no primary ray accounts for
  EXPECT_THROW(invariants_->OnStep(kHost, 0, 0, 0), BrokenInvariant);
}

TEST_F(InvariantsOfARun, NobodyIsIdleWithWork) {
  EXPECT_THROW(invariants_->OnEvent(), BrokenInvariant);  // nobody has been let work yet
}

}  // namespace
}  // namespace rayshade::parallel
