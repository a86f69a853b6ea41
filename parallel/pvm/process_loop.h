// Drives a Process over PVM, as process.h asks: takes in what has arrived, works, and waits only
// when there is nothing to do. Measures on the way, for the statistics.
#pragma once

#include <chrono>
#include <string>

#include "parallel/process.h"
#include "parallel/pvm/pvm_transport.h"

namespace rayshade::parallel {

// What happens beside the catalogue's messages.
class LoopListener {
 public:
  virtual ~LoopListener() = default;
  // Anything but a message of the catalogue.
  virtual void OnArrival(const Arrival& arrival) = 0;
  // A message of the catalogue has come from there; before the process gets it.
  virtual void OnHeard(ProcessId) {}
  // Between two steps, some ten times a second at least. False: the loop is to end.
  virtual bool Tick() = 0;
};

class ProcessLoop : public Meter {
 public:
  // outbox: where the process sends, by default the transport.
  explicit ProcessLoop(PvmTransport* transport, Outbox* outbox = nullptr);

  // Until the process has finished (true) or the listener ends it (false). Lets through what the
  // process throws.
  bool Run(Process* process, LoopListener* listener);
  // Waits for one arrival that is no message of the catalogue, and gives it to the listener; late
  // messages are dropped. False: none came in that time.
  bool Await(double seconds, LoopListener* listener);

  // Since Run began.
  double busy_seconds() const override { return busy_.total_seconds(); }
  const BusyTimeline* timeline() const override { return &busy_; }
  uint64_t peak_bytes() const override;
  const char* machine() const override { return machine_.c_str(); }

 private:
  using Clock = std::chrono::steady_clock;

  // Gives everything that is there to the process; waits at most so long for the first.
  void TakeIn(double seconds, Process* process, LoopListener* listener);

  void Deliver(Process* process);
  void NoteBusy(Clock::time_point begin);

  PvmTransport* transport_;
  Outbox* outbox_;
  Arrival arrival_;
  BusyTimeline busy_;
  Clock::time_point run_begin_;
  std::string machine_;
};

}  // namespace rayshade::parallel
