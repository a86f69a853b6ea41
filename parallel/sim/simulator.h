// A run in one address space: the very same processes as over PVM, every message encoded and
// decoded, under a queue of events ordered by (time, sequence). No clock, no thread: one timing,
// one seed, one run.
//
//   1. Links keep their order pairwise, as PVM does; nothing else is promised.
//   2. A process is busy for as long as its step costs; what it sends leaves when it is done with
//   it.
//   3. Nobody is idle while its inbox holds a message or its last step said that there is more to
//   do.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <queue>
#include <unordered_map>
#include <vector>

#include "parallel/busy_timeline.h"
#include "parallel/message.h"
#include "parallel/process.h"
#include "parallel/sim/timing.h"

namespace rayshade::parallel {

// What a trace process is told of itself at the end of a run: simulated figures.
class SimulatedMeter : public Meter {
 public:
  double busy_seconds() const override { return busy.total_seconds(); }
  uint64_t peak_bytes() const override { return bytes_max; }
  const BusyTimeline* timeline() const override { return &busy; }

  BusyTimeline busy;
  uint64_t bytes_max = 0;  // held by the process and in its inbox
};

// Looks on.
class SimulatorListener {
 public:
  virtual ~SimulatorListener() = default;
  // A step of a process has been made: it took in a message of this many bytes (0: it worked).
  virtual void OnStep(ProcessId, double /*begin*/, double /*end*/, size_t /*bytes*/) {}
  virtual void OnSend(ProcessId /*from*/, ProcessId /*to*/, std::span<const uint8_t> /*bytes*/,
                      double /*at*/) {}
};

class Simulator {
 public:
  // processes[0] is the host, processes[i] trace process i. meters: one for each, or empty. Nothing
  // is owned.
  Simulator(std::vector<Process*> processes, Timing* timing,
            std::vector<SimulatedMeter*> meters = {}, SimulatorListener* listener = nullptr);
  // With random times.
  Simulator(std::vector<Process*> processes, uint64_t seed);
  ~Simulator();

  // Until the host has finished. Throws std::runtime_error where no process has work and no message
  // is under way before that (the run hangs), and lets through what processes throw.
  void Run();

  double seconds() const { return now_; }
  uint64_t events() const { return sequence_; }
  // Sent and not taken in, once the run is over.
  size_t under_way() const { return parcels_.size() - free_parcels_.size(); }
  // By all processes together.
  uint64_t messages(Tag tag) const;
  uint64_t bytes(Tag tag) const;
  uint64_t messages() const;
  // By one, by tag.
  const std::array<KindCount, kTags>& sent(ProcessId process) const;

 private:
  class SimulatedOutbox;
  enum class Kind : uint8_t { kDepart, kArrive, kFree };
  struct Event {
    double at;
    uint64_t sequence;
    Kind kind;
    uint32_t which;  // parcel, or process that is free again

    bool operator>(const Event& o) const { return at != o.at ? at > o.at : sequence > o.sequence; }
  };
  struct Parcel {
    ProcessId from = 0, to = 0;
    std::vector<uint8_t> bytes;
  };
  struct State {
    Process* process = nullptr;
    std::deque<uint32_t> inbox;  // parcels
    size_t inbox_bytes = 0;
    bool busy = false;
    bool may_work = true;
    WorkDone done;
    std::array<KindCount, kTags> sent;
  };

  void Push(double at, Kind kind, uint32_t which);
  void Depart(uint32_t parcel);
  void Arrive(uint32_t parcel);
  void Step(ProcessId id);
  size_t TakeIn(ProcessId id);
  uint32_t NewParcel(ProcessId from, ProcessId to, std::vector<uint8_t> bytes);

  std::unique_ptr<Timing> own_timing_;
  Timing* timing_;
  std::vector<SimulatedMeter*> meters_;
  SimulatorListener* listener_;
  std::vector<State> states_;
  std::vector<Parcel> parcels_;
  std::vector<uint32_t> free_parcels_;
  std::vector<uint32_t> outgoing_;                     // of the step being made
  std::unordered_map<uint32_t, double> last_arrival_;  // by link; looked up only
  std::priority_queue<Event, std::vector<Event>, std::greater<Event>> events_;
  uint64_t sequence_ = 0;
  double now_ = 0;
};

}  // namespace rayshade::parallel
