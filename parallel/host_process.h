// The host of figure 5, left: sets the trace processes up, distributes the objects, hands out
// primary rays, gathers the pixels. It holds no objects: they stream from the spool [RJ s.4: "this
// would require a complete copy of the data base to be stored at the host"].
//
// Invariants:
//   1. At most in_flight_limit() primary rays are out: this bounds the memory of all processes
//   (doc/architecture.md).
//   2. Every sample handed out comes back exactly once; the picture is complete when PixelSampling
//   says so.
//   3. Every WorkRequest is answered once, or the run ends.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "parallel/expected_owners.h"
#include "parallel/image_table.h"
#include "parallel/message.h"
#include "parallel/object_spool.h"
#include "parallel/process.h"
#include "parallel/run_options.h"
#include "rayshade/render/camera.h"
#include "rayshade/render/pixel_sampling.h"

namespace rayshade::parallel {

// One frame of one run.
class HostProcess : public Process {
 public:
  enum class Phase { kSetUp, kDistribute, kBuild, kTrace, kStop, kDone, kFailed };

  // spool: the parsed scene (not owned, must outlive the process). Builds the subdivision (reads
  // the spool several times); throws std::runtime_error where a process could not hold its part:
  // the paper's "o.m." [RJ table 1].
  HostProcess(const RunOptions& options, ObjectSpool* spool, int frame);
  ~HostProcess() override;

  void Receive(ProcessId from, std::span<const uint8_t> message, Outbox* outbox) override;
  bool Work(Outbox* outbox) override;
  bool finished() const override { return phase_ == Phase::kDone || phase_ == Phase::kFailed; }
  WorkDone work_done() const override;

  // Before anything else: the picture goes on from what PixelSampling::Save gave. False where the
  // bytes are no such state.
  bool Restore(const std::string& state) { return sampling_->Restore(state); }

  // The runner has lost a trace process: the run fails with this text.
  void OnLost(ProcessId process, const std::string& why);

  Phase phase() const { return phase_; }
  const std::string& failure() const { return failure_; }  // "" unless phase() is kFailed
  const PixelSampling& sampling() const { return *sampling_; }
  const CellTree& tree() const { return tree_; }
  uint64_t in_flight() const { return in_flight_; }  // primary rays, unsent ones counted
  size_t unsent() const;
  uint32_t in_flight_limit() const { return in_flight_limit_; }
  uint64_t samples_done() const { return samples_done_; }
  // One for each trace process; filled when phase() is kDone. [0] is process 1.
  const std::vector<Statistics>& statistics() const { return statistics_; }
  const std::vector<std::string>& machines() const { return machines_; }
  // Lines from trace processes for the user, taken out.
  std::vector<std::string> TakeTexts();

 private:
  struct Receiver;

  void On(ProcessId from, const ObjectsTaken& message, Outbox* outbox);
  void On(ProcessId from, const Ready& message, Outbox* outbox);
  void On(ProcessId from, const WorkRequest& message, Outbox* outbox);
  void On(ProcessId from, const PixelResults& message, Outbox* outbox);
  void On(ProcessId from, const Statistics& message, Outbox* outbox);
  void On(ProcessId from, const Text& message, Outbox* outbox);
  void On(ProcessId from, const Failure& message, Outbox* outbox);
  void Put(std::span<const PixelItem> items, double distance, bool hit);

  std::optional<std::pair<ProcessId, uint64_t>> Balance();
  std::pair<ProcessId, uint64_t> FullestProcess() const;
  uint64_t SpareBytes() const;
  void PlanMemory(std::optional<std::pair<ProcessId, uint64_t>> fullest);
  void SendSetUp(Outbox* outbox);
  bool Distribute(Outbox* outbox);
  bool HandOut(Outbox* outbox);
  void SendParcel(ProcessId to, Outbox* outbox);
  void AddImage(uint32_t number, Receiver* receiver);
  void Fail(const std::string& text);

  RunOptions options_;
  ObjectSpool* spool_;
  int frame_;
  CellTree tree_;
  std::unique_ptr<Camera> camera_;
  std::unique_ptr<PixelSampling> sampling_;
  ExpectedOwners expected_owners_;
  std::unique_ptr<class PrimaryFeed> feed_;
  Phase phase_ = Phase::kSetUp;
  std::string failure_;

  ImageTable images_;
  std::vector<Receiver> receivers_;  // of objects; one for each trace process
  uint32_t in_flight_limit_ = 0;
  uint64_t in_flight_ = 0;
  uint64_t samples_done_ = 0;
  int untaken_ = 0;  // messages Objects sent and not yet reported as stored
  int ready_ = 0, reported_ = 0;
  std::vector<uint64_t> probes_;
  std::vector<Statistics> statistics_;
  std::vector<std::string> machines_;
  std::vector<std::string> texts_;
};

}  // namespace rayshade::parallel
