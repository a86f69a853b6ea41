// The processes of one simulated run, with their meters.
#pragma once

#include <memory>
#include <vector>

#include "parallel/host_process.h"
#include "parallel/shared_objects.h"
#include "parallel/sim/simulator.h"
#include "parallel/trace_process.h"

namespace rayshade::parallel {

struct RunProcesses {
  // As HostProcess.
  RunProcesses(const RunOptions& options, ObjectSpool* spool, int frame)
      : host(options, spool, frame), meters(options.processes + size_t{1}) {
    all.push_back(&host);
    for (size_t i = 1; i < meters.size(); ++i) {
      trace.push_back(std::make_unique<TraceProcess>(&meters[i], &shared));
      all.push_back(trace.back().get());
    }
    for (SimulatedMeter& meter : meters) all_meters.push_back(&meter);
  }

  HostProcess host;
  SharedObjects shared;
  std::vector<SimulatedMeter> meters;                // by process
  std::vector<std::unique_ptr<TraceProcess>> trace;  // [0] is process 1
  std::vector<Process*> all;                         // by process
  std::vector<SimulatedMeter*> all_meters;
};

}  // namespace rayshade::parallel
