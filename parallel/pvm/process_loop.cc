// The loop around a process; see process_loop.h.
#include "parallel/pvm/process_loop.h"

#include <unistd.h>

#include "rayshade/render/stats.h"

namespace rayshade::parallel {

namespace {

// Work goes on so long before the next look at what has arrived: a direct route blocks its sender
// meanwhile.
constexpr double kWorkSeconds = 300e-6;
// So long is waited before the listener has its turn.
constexpr double kIdleSeconds = 0.1;
// And so long messages are taken in without a step of work.
constexpr double kTakeInSeconds = 0.2;

double Seconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

ProcessLoop::ProcessLoop(PvmTransport* transport, Outbox* outbox)
    : transport_(transport), outbox_(outbox ? outbox : transport) {
  char name[256] = "";
  gethostname(name, sizeof name - 1);
  machine_ = name;
}

uint64_t ProcessLoop::peak_bytes() const { return PeakBytes(); }

bool ProcessLoop::Run(Process* process, LoopListener* listener) {
  busy_ = {};
  run_begin_ = Clock::now();
  bool more = true;
  while (!process->finished()) {
    if (!listener->Tick()) return false;
    TakeIn(more ? 0 : kIdleSeconds, process, listener);

    const Clock::time_point begin = Clock::now();
    double spent = 0;
    do {
      more = !process->finished() && process->Work(outbox_);
      spent = Seconds(Clock::now() - begin);
    } while (more && spent < kWorkSeconds);
    NoteBusy(begin);
  }
  return true;
}

void ProcessLoop::TakeIn(double seconds, Process* process, LoopListener* listener) {
  const Clock::time_point first = Clock::now();
  do {
    transport_->Receive(seconds, &arrival_);
    seconds = 0;
    if (arrival_.kind == Arrival::Kind::kNone) return;
    if (arrival_.kind != Arrival::Kind::kMessage) {
      listener->OnArrival(arrival_);
      continue;
    }
    listener->OnHeard(arrival_.from);
    const Clock::time_point begin = Clock::now();
    Deliver(process);
    NoteBusy(begin);
  } while (!process->finished() && Seconds(Clock::now() - first) < kTakeInSeconds);
}

void ProcessLoop::NoteBusy(Clock::time_point begin) {
  busy_.Add(Seconds(begin - run_begin_), Seconds(Clock::now() - run_begin_));
}

void ProcessLoop::Deliver(Process* process) {
  try {
    process->Receive(arrival_.from, arrival_.bytes, outbox_);
  } catch (const WireError& e) {
    throw WireError("a malformed message from process " + std::to_string(arrival_.from) + ": " +
                    e.what());
  }
}

bool ProcessLoop::Await(double seconds, LoopListener* listener) {
  const Clock::time_point begin = Clock::now();
  for (double left = seconds; left > 0; left = seconds - Seconds(Clock::now() - begin)) {
    transport_->Receive(left, &arrival_);
    if (arrival_.kind == Arrival::Kind::kNone) break;
    if (arrival_.kind == Arrival::Kind::kMessage) continue;
    listener->OnArrival(arrival_);
    return true;
  }
  return false;
}

}  // namespace rayshade::parallel
