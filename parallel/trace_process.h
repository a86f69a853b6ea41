// A trace process of figure 5, right: traces rays through what it holds, hands them on, spawns and
// shades the hits on its own objects, carries out PyraClip tasks. One handler per message, one Work
// step.
//
// Invariants:
//   1. Nothing waits for one particular message: a ray that needs a cell is put aside, and every
//   message can be
//      taken in at any time.
//   2. What it holds is bounded by the host's limit on primary rays in flight: per primary ray at
//   most one ray is on its
//      way and one intersection per level is pending (transmitted rays are finished before
//      reflected ones start).
//   3. Rays of greater depth are traced first: they free memory.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "parallel/message.h"
#include "parallel/process.h"

namespace rayshade::parallel {

class SharedObjects;

class TraceProcess : public Process {
 public:
  // meter: what only the runner knows, for the statistics. shared: of the processes of the run that
  // are in this address space; may be null. Not owned.
  explicit TraceProcess(const Meter* meter, SharedObjects* shared = nullptr);
  ~TraceProcess() override;

  void Receive(ProcessId from, std::span<const uint8_t> message, Outbox* outbox) override;
  bool Work(Outbox* outbox) override;
  bool finished() const override;
  WorkDone work_done() const override;
  uint64_t bytes_held() const override;
  // Rays not finished, hits not shaded and results not sent: one for each primary ray that is here.
  // Pending intersections do not count: their rays do. Nor do shadow rays: their hits do.
  size_t rays_in_work() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayshade::parallel
