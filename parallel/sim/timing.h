// How long things take in a simulated run: by a machine's cost model here, at random in
// fault_plan.h. No clock: times follow from counts, sizes and a seed.
#pragma once

#include <cstdint>
#include <vector>

#include "parallel/process.h"
#include "parallel/sim/machine.h"

namespace rayshade::parallel {

class Timing {
 public:
  virtual ~Timing() = default;

  // Seconds of a step, without its messages.
  virtual double StepSeconds(ProcessId process, const WorkDone& before, const WorkDone& after) = 0;
  // What a message costs its sender and its receiver, who do nothing else meanwhile.
  virtual double SendSeconds(size_t bytes) = 0;
  virtual double ReceiveSeconds(size_t bytes) = 0;
  // A message leaves its sender now, bytes long: when it is there. Called in order of `now`.
  virtual double ArrivalTime(ProcessId from, ProcessId to, size_t bytes, double now) = 0;
  // Whether the process works once more before it takes in what has arrived.
  virtual bool WorksFirst(ProcessId) { return false; }
};

// LogGP with contention [AISS95]: overhead at both ends, gap per byte at the ports of both nodes
// and in what all nodes share, latency between them.
class MachineTiming : public Timing {
 public:
  // processes: the host and the trace processes. seed: of the jitter.
  MachineTiming(const Machine& machine, size_t processes, uint64_t seed);

  double StepSeconds(ProcessId process, const WorkDone& before, const WorkDone& after) override;
  double SendSeconds(size_t bytes) override;
  double ReceiveSeconds(size_t bytes) override;
  double ArrivalTime(ProcessId from, ProcessId to, size_t bytes, double now) override;

  size_t NodeOf(ProcessId process) const;

 private:
  Machine machine_;
  uint64_t random_;
  std::vector<double> out_free_, in_free_;  // ports, by node: free from then on
  double shared_free_ = 0;
};

// Seconds that the counted work costs on the machine.
double CostOf(const Machine& machine, const WorkDone& work);

}  // namespace rayshade::parallel
