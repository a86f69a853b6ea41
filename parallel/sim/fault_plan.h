// What is put in the way of a run: a pure function of a seed. How the work is spread, with small
// credits, caches, resident sets, pyramids and cells; and how long everything takes: some processes
// slow, some links slow, processes that stall, messages late, so that events come in every order
// that PVM allows (any, but for that of the messages from one process to another).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "parallel/run_options.h"
#include "parallel/sim/timing.h"

namespace rayshade::parallel {

struct FaultPlan {
  uint64_t seed = 0;
  RunOptions options;
  bool tight_memory = false;  // options.memory: about the least that the scene allows

  // Times, in steps of a quick process.
  double slow_processes = 0;  // share of the processes, up to slowness_max times as slow
  double slowness_max = 1;    //
  double lateness = 0;        // mean delay of a message
  double slow_links = 0;      // share of the links, on which messages are 100 times as late
  double stalls = 0;          // share of the steps that take 100 times as long
  double works_first = 0.5;   // share of the steps that are work although messages are there

  // For people: "hybrid, 5 processes, 3 rays in flight, …".
  std::string Text() const;
};

FaultPlan PlanFaults(uint64_t seed);

class FaultTiming : public Timing {
 public:
  // processes: the host and the trace processes.
  FaultTiming(const FaultPlan& plan, size_t processes);

  double StepSeconds(ProcessId process, const WorkDone& work) override;
  double SendSeconds(size_t) override { return 0; }
  double ReceiveSeconds(size_t) override { return 0; }
  double ArrivalTime(ProcessId from, ProcessId to, size_t bytes, double now) override;
  bool WorksFirst(ProcessId) override { return Draw() < plan_.works_first; }

 private:
  double Draw();  // in [0, 1)

  FaultPlan plan_;
  uint64_t random_;
  std::vector<double> slowness_;  // by process
  uint64_t link_key_;             // which links are slow
};

}  // namespace rayshade::parallel
