// A process without its transport: it takes messages and returns messages; sockets, PVM and clocks
// are the runner's. The same two classes (HostProcess, TraceProcess) run over PVM (parallel/pvm)
// and in one address space (parallel/sim).
//
// A runner, for each process:
//   - calls Receive for each message, in the order in which one sender sent them (no other order is
//   promised);
//   - calls Work while it returns true, taking in what has arrived between two calls;
//   - stops when finished() is true and the outbox is empty.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parallel/busy_timeline.h"
#include "parallel/process_id.h"
#include "rayshade/common/op_counts.h"

namespace rayshade::parallel {

class Outbox {
 public:
  virtual ~Outbox() = default;
  // bytes: a whole encoded message (parallel/message.h).
  virtual void Send(ProcessId to, std::vector<uint8_t> bytes) = 0;
};

// What a process has done since it was made, exact and repeatable: what the simulator's cost model
// multiplies.
struct WorkDone {
  OpCounts counts;
  uint64_t objects_taken = 0;    // own and resident ones, with the hierarchy over them
  uint64_t objects_fetched = 0;  // while tracing, with a hierarchy over each cell's
  uint64_t objects_lent = 0;     // looked up and encoded for processes that fetch them
  uint64_t rays_handled = 0;     // in data parallel: spawned or taken up, and again if handed on
  uint64_t samples = 0;          // handed out, and put into the picture

  // o: work that is part of this, from before.
  WorkDone& operator-=(const WorkDone& o) {
    counts -= o.counts;
    objects_taken -= o.objects_taken;
    objects_fetched -= o.objects_fetched;
    objects_lent -= o.objects_lent;
    rays_handled -= o.rays_handled;
    samples -= o.samples;
    return *this;
  }
  WorkDone& operator+=(const WorkDone& o) {
    counts += o.counts;
    objects_taken += o.objects_taken;
    objects_fetched += o.objects_fetched;
    objects_lent += o.objects_lent;
    rays_handled += o.rays_handled;
    samples += o.samples;
    return *this;
  }
};

class Process {
 public:
  virtual ~Process() = default;

  // Takes in one message. A malformed one is a WireError; the process is unharmed.
  virtual void Receive(ProcessId from, std::span<const uint8_t> message, Outbox* outbox) = 0;
  // One bounded step of work (well below a millisecond where the scene allows). False: nothing to
  // do until a message arrives.
  virtual bool Work(Outbox* outbox) = 0;
  virtual bool finished() const = 0;

  virtual WorkDone work_done() const { return {}; }
  // Of objects, cache and rays in work, after the last step.
  virtual uint64_t bytes_held() const { return 0; }
};

// What only the runner knows of its process; zeros where it does not.
class Meter {
 public:
  virtual ~Meter() = default;
  virtual double busy_seconds() const { return 0; }
  virtual uint64_t peak_bytes() const { return 0; }
  virtual const char* machine() const { return ""; }
  virtual const BusyTimeline* timeline() const { return nullptr; }
};

}  // namespace rayshade::parallel
