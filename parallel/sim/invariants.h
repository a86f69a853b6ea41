// What must be true after every event of a run, whatever the order of events. Looks at messages, by
// decoding them, and at what processes say of themselves; the first thing that is not true is
// thrown.
//
//   1. Every ray is at exactly one place: a process handles or answers no ray that is not with it.
//   2. Rays created = answered + in flight: a primary ray has, from its hand-out to its result,
//   exactly one ray, hit or result on its way, in a process or in a message.
//   3. One answer per slot, one result per primary ray, one per shadow ray that travels.
//   4. Budgets are kept: primary rays in flight, bytes held, requests for work and for cells. Each
//   request is answered once.
//   5. Nobody is idle while its inbox holds a message.
//   6. After the end there is silence: no message to a process that has finished, but for requests
//   for work that were under way; nothing is left anywhere.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "parallel/sim/run_processes.h"
#include "parallel/sim/simulator.h"

namespace rayshade::parallel {

class BrokenInvariant : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Invariants : public SimulatorListener {
 public:
  // Nothing is owned.
  Invariants(const RunOptions& options, const RunProcesses* processes, const Simulator* simulator);

  void OnTake(const SimulatedMessage& message) override;
  void OnSend(const SimulatedMessage& message) override;
  void OnStep(ProcessId process, double begin, double end, size_t bytes) override;
  void OnEvent() override;
  // After Simulator::Drain, where the run has not failed.
  void AtEnd() const;

 private:
  struct Place {
    ProcessId process;
    bool under_way;
  };
  using Rays = std::map<std::pair<ProcessId, uint64_t>, Place>;  // by return address

  void Leave(const ReturnAddress& back, const SimulatedMessage& message);
  void Come(const ReturnAddress& back, const SimulatedMessage& message);
  void Answer(const ReturnAddress& back, const SimulatedMessage& message);
  void ShadowLeaves(const ReturnAddress& back, const SimulatedMessage& message);
  void ShadowComes(const ReturnAddress& back, const SimulatedMessage& message);
  void ShadowIsAnswered(const ReturnAddress& back, const SimulatedMessage& message);
  void CheckSilence(const SimulatedMessage& message) const;

  const RunOptions& options_;
  const RunProcesses* processes_;
  const Simulator* simulator_;
  Rays rays_;               // that are away from where they were spawned
  Rays shadows_;            // shadow rays that travel, from their first task to their answer
  size_t in_messages_ = 0;  // rays, hits and results in messages
  std::vector<size_t> in_processes_;  // by process
  size_t in_all_processes_ = 0;
  std::vector<int> work_requests_;  // by process: not answered
  std::set<std::tuple<ProcessId, ProcessId, CellId>> cell_requests_;
  std::vector<int> cells_;     // by process: requested, not arrived
  std::vector<bool> stopped_;  // by process: has said its last word
};

}  // namespace rayshade::parallel
