// A run in one address space: the very same processes as over PVM, every message encoded and
// decoded, under a queue of events ordered by (time, sequence). No clock, no thread: one timing,
// one seed, one run.
//
//   1. Links keep their order pairwise, as PVM does; nothing else is promised.
//   2. A process is busy for as long as its step costs; what it sends leaves when it is done with
//   it.
//   3. Nobody is idle while its inbox holds a message or its last step said that there is more to
//   do.
//   4. A process that has finished takes in nothing more.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
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

// A message under way.
struct SimulatedMessage {
  ProcessId from = kHost, to = kHost;
  std::vector<uint8_t> bytes;
};

// Looks on; the calls of an event come in this order.
class SimulatorListener {
 public:
  virtual ~SimulatorListener() = default;
  // A process is about to take in a message.
  virtual void OnTake(const SimulatedMessage&) {}
  // A process has put a message into its outbox.
  virtual void OnSend(const SimulatedMessage&) {}
  // A step of a process has been made: it took in a message of this many bytes (0: it worked).
  virtual void OnStep(ProcessId, double /*begin*/, double /*end*/, size_t /*bytes*/) {}
  // A message leaves its sender, who has paid for it, and will be with its receiver.
  virtual void OnDepart(const SimulatedMessage&, double /*departs*/, double /*arrives*/) {}
  virtual void OnEvent() {}
};

class Simulator {
 public:
  // processes[0] is the host, processes[i] trace process i. meters: one for each, or empty. Nothing
  // is owned.
  Simulator(std::vector<Process*> processes, Timing* timing,
            std::vector<SimulatedMeter*> meters = {});
  ~Simulator();

  void AddListener(SimulatorListener* listener) { listeners_.push_back(listener); }
  // A run of more events than these is an error: it goes round in circles.
  void set_events_max(uint64_t events) { events_max_ = events; }

  // Until the host has finished. Throws std::runtime_error where no process has work and no message
  // is under way before that (the run hangs), and lets through what processes throw.
  void Run();
  // After Run: what is under way arrives, and who has not finished works on.
  void Drain();

  double seconds() const { return now_; }
  uint64_t events() const { return events_made_; }
  // By a process and in its inbox.
  uint64_t bytes_held(ProcessId process) const;
  // Whether a process does nothing although it has something to take in or to do.
  bool idles(ProcessId process) const;
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
  uint32_t NewParcel(SimulatedMessage message);
  void MakeEvent();
  template <class Call>
  void Tell(const Call& call) const {
    for (SimulatorListener* listener : listeners_) call(listener);
  }

  Timing* timing_;
  std::vector<SimulatedMeter*> meters_;
  std::vector<SimulatorListener*> listeners_;
  std::vector<State> states_;
  std::vector<SimulatedMessage> parcels_;
  std::vector<uint32_t> free_parcels_;
  std::vector<uint32_t> outgoing_;                     // of the step being made
  std::vector<double> departures_;                     // of these
  std::unordered_map<uint32_t, double> last_arrival_;  // by link; looked up only
  std::priority_queue<Event, std::vector<Event>, std::greater<Event>> events_;
  uint64_t sequence_ = 0;
  uint64_t events_made_ = 0, events_max_ = ~uint64_t{0};
  double now_ = 0;
};

}  // namespace rayshade::parallel
