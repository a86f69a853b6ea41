// Processes that share what they were sent say and do what they would by themselves.
#include "parallel/shared_objects.h"

#include <gtest/gtest.h>

#include "parallel/sim/fault_plan.h"
#include "parallel/sim/run_processes.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

Objects OneSphere(Rank rank) {
  Objects message;
  WireObject& object = message.parcel.objects.emplace_back();
  object.rank = rank;
  object.geom = SphereSpec();
  return message;
}

TEST(SharedObjects, TheSameBytesAreTheSameParcel) {
  SharedObjects shared;
  const SharedObjects::Parcel first = shared.Keep(Encode(OneSphere(1)));
  EXPECT_EQ(first.objects, 1u);
  EXPECT_NE(shared.Keep(Encode(OneSphere(2))).number, first.number);
  EXPECT_EQ(shared.Keep(Encode(OneSphere(1))).number, first.number);
  EXPECT_EQ(shared.At(first.number).parcel.objects.at(0).rank, 1u);
}

TEST(SharedObjects, AMalformedParcelIsAnErrorAndIsNotKept) {
  SharedObjects shared;
  std::vector<uint8_t> bytes = Encode(OneSphere(1));
  bytes.pop_back();
  EXPECT_THROW(shared.Keep(bytes), WireError);
  EXPECT_THROW(shared.Keep(bytes), WireError);
}

// Resident sets of everything, of a part, and of nothing: all, some and no processes hold the same.
TEST(SharedObjects, ChangeNeitherPictureNorCountsNorBytes) {
  for (const std::string& text : {Balls(2, 16), InstanceScene(), GlassScene()}) {
    for (const uint64_t resident : {uint64_t{1} << 30, uint64_t{20000}, uint64_t{0}}) {
      RunOptions options;
      options.processes = 5;
      options.cell_bytes = 2000;
      options.resident = resident;
      const uint64_t seed = 3;
      const TestPicture alone = RenderInParallel(text, options, seed);

      ObjectSpool spool;
      ParseText(text, &spool);
      spool.Place(0);
      RunProcesses processes(options, &spool, 0);
      FaultTiming timing(PlanFaults(seed), processes.all.size());
      Simulator(processes.all, &timing).Run();
      EXPECT_TRUE(Identical(processes.host.sampling().picture(), alone.picture));
      for (int p = 0; p < options.processes; ++p) {
        Statistics said = processes.host.statistics()[p];
        said.interval_seconds = alone.processes[p].interval_seconds;  // the meter's
        EXPECT_TRUE(Encode(said) == Encode(alone.processes[p])) << "process " << p + 1;
      }
    }
  }
}

}  // namespace
}  // namespace rayshade::parallel
