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

  // Seconds of a step that did this work, without its messages.
  virtual double StepSeconds(ProcessId process, const WorkDone& work) = 0;
  // What a message costs its sender and its receiver, who do nothing else meanwhile.
  virtual double SendSeconds(size_t bytes) = 0;
  virtual double ReceiveSeconds(size_t bytes) = 0;
  // A message leaves its sender now, bytes long: when it is there. Called in order of `now`.
  virtual double ArrivalTime(ProcessId from, ProcessId to, size_t bytes, double now) = 0;
  // A process is busy from now on for so many seconds of a processor's: until when.
  virtual double FreeAt(ProcessId, double seconds, double now) { return now + seconds; }
  // Whether the process works once more before it takes in what has arrived.
  virtual bool WorksFirst(ProcessId) { return false; }
};

// LogGP with contention [AISS95]: overhead at both ends, gap per byte at the ports of both nodes
// and in what all nodes share, latency between them.
class MachineTiming : public Timing {
 public:
  // processes: the host and the trace processes. seed: of the jitter.
  MachineTiming(const Machine& machine, size_t processes, uint64_t seed);

  double StepSeconds(ProcessId process, const WorkDone& work) override;
  double SendSeconds(size_t bytes) override;
  double ReceiveSeconds(size_t bytes) override;
  double ArrivalTime(ProcessId from, ProcessId to, size_t bytes, double now) override;
  // Where more processes of a node are busy than it has processors (the host beside its trace
  // processes), they share them: a step takes longer by as much as there are too many when it
  // begins. Busy processors of a node slow each other by the machine's contention.
  double FreeAt(ProcessId process, double seconds, double now) override;

  size_t NodeOf(ProcessId process) const;

 private:
  Machine machine_;
  uint64_t random_;
  std::vector<double> out_free_, in_free_;  // ports, by node: free from then on
  double shared_free_ = 0;
  std::vector<double> busy_until_;                      // by process
  std::vector<std::vector<ProcessId>> node_processes_;  // by node
};

// Seconds that the counted work costs on the machine.
double CostOf(const Machine& machine, const WorkDone& work);

}  // namespace rayshade::parallel
