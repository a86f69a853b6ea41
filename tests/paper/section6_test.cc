// What [RJ s.6-7] says of the schedules, on the simulated machine of the paper: small pictures, the
// tolerance of each claim beside it. doc/paper.md tells where our runs differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "parallel/sim/sim_run.h"
#include "tests/support/parallel_run.h"

namespace rayshade::parallel {
namespace {

struct SimulatedRun {
  double seconds = 0;
  std::vector<Statistics> processes;
  double begin = 0, end = 0;
};

// With the paper's equal voxels.
SimulatedRun Simulate(const std::string& file, int pixels, Schedule schedule, int processes) {
  Options options;
  options.program = "test";
  options.input = file;
  options.resolution = {pixels, pixels};
  ObjectSpool spool;
  ParseInto(options, &spool);
  spool.Place(0);
  const Machine machine = FindMachine("powerxplorer");
  ParallelOptions parallel;
  parallel.schedule = schedule;
  parallel.distribution = Distribution::kGrid;
  parallel.processes = static_cast<uint16_t>(processes);
  SimulatedFrame frame(machine,
                       DefaultsFor(parallel, {processes, 1, static_cast<uint64_t>(machine.memory)}),
                       1, &spool, 0);
  frame.Run();
  return {frame.trace_seconds(), frame.host().statistics(), frame.trace_begin_seconds(),
          frame.trace_end_seconds()};
}

// Pearson's correlation of two figures of each process.
double Correlation(const SimulatedRun& run, auto a, auto b) {
  const double n = static_cast<double>(run.processes.size());
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (const Statistics& s : run.processes) {
    const double x = static_cast<double>(a(s)), y = static_cast<double>(b(s));
    sa += x, sb += y, saa += x * x, sbb += y * y, sab += x * y;
  }
  return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

// Seconds that a process is busy between two moments of tracing, given as shares of it.
double Busy(const SimulatedRun& run, const Statistics& s, double from, double to) {
  const double begin = run.begin + from * (run.end - run.begin);
  const double end = run.begin + to * (run.end - run.begin);
  double busy = 0;
  for (size_t k = 0; k < s.busy_by_interval.size(); ++k) {
    const double at = s.interval_seconds * (static_cast<double>(k) + .5);
    if (at >= begin && at < end) busy += s.busy_by_interval[k];
  }
  return busy;
}

double ShareBusy(const SimulatedRun& run, double from, double to) {
  double busy = 0;
  for (const Statistics& s : run.processes) busy += Busy(run, s, from, to);
  return busy / ((to - from) * (run.end - run.begin) * static_cast<double>(run.processes.size()));
}

constexpr char kBalls[] = "scenes/balls5.ray";

// "The figures show that data parallel rendering alone is not scalable and performs rather poorly."
// Tolerance: eight times as many processes are not even three times as fast.
TEST(PaperSection6, DataParallelRenderingAloneIsNotScalable) {
  const SimulatedRun two = Simulate(kBalls, 128, Schedule::kDataParallel, 2);
  const SimulatedRun sixteen = Simulate(kBalls, 128, Schedule::kDataParallel, 16);
  EXPECT_GT(3 * sixteen.seconds, two.seconds);
}

// "The hybrid scheduling algorithm performs (slightly) better": from 8 processes on, by a tenth at
// least.
TEST(PaperSection6, HybridBeatsDataParallelFromEightProcessesOn) {
  for (int processes : {8, 16, 32}) {
    const SimulatedRun data = Simulate(kBalls, 128, Schedule::kDataParallel, processes);
    const SimulatedRun hybrid = Simulate(kBalls, 128, Schedule::kHybrid, processes);
    EXPECT_LT(hybrid.seconds, 0.9 * data.seconds) << processes;
  }
}

// "The processors that have only a few data parallel tasks, receive a large number of demand driven
// rays and vice versa." Figure 7. Tolerance: a correlation below -0.5.
TEST(PaperSection6, DemandDrivenRaysComplementTheDataParallelOnes) {
  const SimulatedRun run = Simulate(kBalls, 256, Schedule::kHybrid, 16);
  EXPECT_LT(Correlation(
                run, [](const Statistics& s) { return s.data_rays + s.counts.hits; },
                [](const Statistics& s) { return s.demand_rays; }),
            -0.5);
}

// "Adding more light sources therefore adds to the data parallel load (unbalance)" [RJ s.7]. The
// work per process is farther from even with 30 lights than with 8.
TEST(PaperSection6, MoreLightsAddToTheImbalance) {
  double imbalance[2];
  for (int i = 0; i < 2; ++i) {
    const SimulatedRun run =
        Simulate(i == 0 ? "scenes/room8.ray" : "scenes/room30.ray", 64, Schedule::kHybrid, 16);
    double sum = 0, most = 0;
    for (const Statistics& s : run.processes) {
      const double busy = Busy(run, s, 0, 1);
      sum += busy;
      most = std::max(most, busy);
    }
    imbalance[i] = 16 * most / sum;
  }
  EXPECT_GT(imbalance[1], imbalance[0]);
}

// "The unbalance does not follow the distribution of objects over processes and -even worse- is not
// constant over time" [RJ s.7]. Tolerance: objects and busy seconds correlate by less than 0.8, and
// the busiest of the first third is another one than the busiest of the last.
TEST(PaperSection6, ImbalanceDoesNotFollowTheObjectsAndMovesWithTime) {
  const SimulatedRun run = Simulate(kBalls, 128, Schedule::kDataParallel, 16);
  EXPECT_LT(Correlation(
                run, [](const Statistics& s) { return s.objects; },
                [&](const Statistics& s) { return Busy(run, s, 0, 1); }),
            0.8);
  const auto busiest = [&](double from, double to) {
    return std::max_element(run.processes.begin(), run.processes.end(),
                            [&](const Statistics& a, const Statistics& b) {
                              return Busy(run, a, from, to) < Busy(run, b, from, to);
                            }) -
           run.processes.begin();
  };
  EXPECT_NE(busiest(0, 1. / 3), busiest(2. / 3, 1));
}

// "The first half of the computation is very efficient, after which there is a sudden drop in
// efficiency. At this point the demand driven tasks are all finished." Figure 8. Tolerance: the
// first half is half as busy again as the last tenth.
TEST(PaperSection6, EfficiencyDropsWhenTheDemandDrivenTasksAreFinished) {
  const SimulatedRun run = Simulate(kBalls, 128, Schedule::kHybrid, 16);
  EXPECT_GT(ShareBusy(run, 0, .5), 1.5 * ShareBusy(run, .9, 1));
}

}  // namespace
}  // namespace rayshade::parallel
