// The life of one trace process over PVM: frame after frame, until its host says that the run is
// over, or is gone itself.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <vector>

#include "parallel/pvm/interrupts.h"
#include "parallel/pvm/process_loop.h"
#include "parallel/pvm/pvm_transport.h"

namespace rayshade::parallel {

// The way out of a trace process: adds to its Statistics what only the transport has counted.
class CountingOutbox : public Outbox {
 public:
  explicit CountingOutbox(PvmTransport* transport) : transport_(transport) {}
  void Send(ProcessId to, std::vector<uint8_t> bytes) override;

 private:
  PvmTransport* transport_;
};

class TraceSession : public LoopListener {
 public:
  // Makes the process of one frame.
  using Factory = std::function<std::unique_ptr<Process>(const Meter*)>;

  TraceSession(int host_tid, Factory factory);

  // The exit status. What goes wrong is told to the host, as a Failure.
  int Run();

  void OnArrival(const Arrival& arrival) override;
  bool Tick() override;

 private:
  void RunFrames();

  PvmTransport transport_;
  CountingOutbox outbox_;
  ProcessLoop loop_;
  Factory factory_;
  Interrupts interrupts_;  // PVM ends a task by SIGTERM
  bool started_ = false;   // a frame, that is not being run yet
  bool over_ = false;
  std::chrono::steady_clock::time_point last_pulse_;
};

}  // namespace rayshade::parallel
