// One frame rendered under a fault plan, with every invariant watched.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "parallel/object_spool.h"
#include "parallel/sim/fault_plan.h"
#include "parallel/sim/run_processes.h"
#include "parallel/sim/transcript.h"
#include "rayshade/image/picture.h"

namespace rayshade::parallel {

class FaultRun {
 public:
  // More events than any small scene takes: the run does not end.
  static constexpr uint64_t kEventsMax = 20'000'000;

  // spool: placed for the frame; not owned. transcript: may be null; not owned.
  FaultRun(const FaultPlan& plan, ObjectSpool* spool, int frame, Transcript* transcript = nullptr);
  ~FaultRun();

  // Throws BrokenInvariant, and std::runtime_error where the run fails, hangs or does not end.
  void Run();

  const Picture& picture() const { return processes_->host.sampling().picture(); }
  uint64_t events() const { return events_; }
  uint64_t memory() const { return plan_.options.memory; }  // budget of a process; 0: no limit

 private:
  bool FitsAndRuns();

  FaultPlan plan_;
  ObjectSpool* spool_;
  int frame_;
  Transcript* transcript_;
  std::unique_ptr<RunProcesses> processes_;
  uint64_t events_ = 0;
};

// Where two pictures differ, for people: "at 3 4: …"; none where they are the same to the bit.
std::optional<std::string> DifferenceOf(const Picture& a, const Picture& b);

}  // namespace rayshade::parallel
