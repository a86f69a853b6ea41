// See fault_run.h.
#include "parallel/sim/fault_run.h"

#include <cstring>
#include <stdexcept>
#include <string>

#include "parallel/sim/invariants.h"

namespace rayshade::parallel {

namespace {

// Tight memory is found by trying: from so many bytes, a quarter more each time.
constexpr uint64_t kLeastMemory = 32 << 10;

bool IsOutOfMemory(const std::string& text) { return text.starts_with("out of memory"); }

}  // namespace

FaultRun::FaultRun(const FaultPlan& plan, ObjectSpool* spool, int frame, Transcript* transcript)
    : plan_(plan), spool_(spool), frame_(frame), transcript_(transcript) {
  if (plan_.tight_memory) plan_.options.memory = kLeastMemory;
}

FaultRun::~FaultRun() = default;

void FaultRun::Run() {
  while (!FitsAndRuns()) plan_.options.memory += plan_.options.memory / 4;
}

// False where memory does not suffice for the objects.
bool FaultRun::FitsAndRuns() {
  const RunOptions& options = plan_.options;
  try {
    processes_ = std::make_unique<RunProcesses>(options, spool_, frame_);
  } catch (const std::runtime_error& e) {
    if (options.memory == 0 || !IsOutOfMemory(e.what())) throw;
    return false;
  }
  FaultTiming timing(plan_, processes_->all.size());
  Simulator simulator(processes_->all, &timing, processes_->all_meters);
  Invariants invariants(options, processes_.get(), &simulator);
  simulator.AddListener(&invariants);
  if (transcript_ != nullptr) {
    transcript_->Headline("seed " + std::to_string(plan_.seed) + ": " + plan_.Text() +
                          (options.memory == 0 ? "" : " of " + std::to_string(options.memory)));
    simulator.AddListener(transcript_);
  }
  simulator.set_events_max(kEventsMax);
  simulator.Run();
  const std::string& failure = processes_->host.failure();
  if (options.memory != 0 && IsOutOfMemory(failure)) return false;
  if (!failure.empty()) throw std::runtime_error(failure);
  simulator.Drain();
  invariants.AtEnd();
  events_ = simulator.events();
  return true;
}

std::optional<std::string> DifferenceOf(const Picture& a, const Picture& b) {
  if (a.width() != b.width() || a.height() != b.height()) return "another size";
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const PixelValue &p = a.at(x, y), &q = b.at(x, y);
      if (std::memcmp(&p.color, &q.color, sizeof p.color) == 0 && p.alpha == q.alpha) continue;
      return "another colour at " + std::to_string(x) + " " + std::to_string(y);
    }
  }
  return std::nullopt;
}

}  // namespace rayshade::parallel
