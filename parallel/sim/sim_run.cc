// See sim_run.h.
#include "parallel/sim/sim_run.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "parallel/sim/sequential_base.h"
#include "parallel/timeline.h"
#include "rayshade/image/output_file.h"
#include "rayshade/image/png.h"
#include "rayshade/render/camera.h"
#include "rayshade/render/render_picture.h"

namespace rayshade::parallel {

namespace {

AlphaChannel AlphaOf(const Settings& settings) {
  if (settings.sample_map) return AlphaChannel::kSampleMap;
  return settings.alpha ? AlphaChannel::kCoverage : AlphaChannel::kNone;
}

std::string Number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

// For so many processes: the machine has as many nodes as that takes.
RunOptions OptionsFor(const ParallelOptions& parallel, const Machine& machine) {
  Machines machines;
  machines.processors = static_cast<int>(machine.processors);
  machines.memory_bytes = static_cast<uint64_t>(machine.memory);
  machines.count = static_cast<int>(machine.nodes);
  if (parallel.processes) machines.count = (*parallel.processes - 1) / machines.processors + 1;
  return DefaultsFor(parallel, machines);
}

bool IsOutOfMemory(const std::runtime_error& e) {
  return std::string_view(e.what()).starts_with("out of memory");
}

}  // namespace

void WriteFrame(const Picture& picture, const Settings& settings, int frame) {
  WritePng(picture, FrameFile(settings, frame), settings.gamma, AlphaOf(settings));
}

SimulatedFrame::SimulatedFrame(const Machine& machine, const RunOptions& options, uint64_t seed,
                               ObjectSpool* spool, int frame)
    : machine_(machine),
      processes_(options, spool, frame),
      timing_(machine, processes_.all.size(), seed),
      simulator_(processes_.all, &timing_, processes_.all_meters),
      process_bytes_(processes_.all.size()),
      node_bytes_(processes_.all.size()) {
  simulator_.AddListener(this);
}

void SimulatedFrame::Run() {
  simulator_.Run();
  if (!host().failure().empty()) throw std::runtime_error(host().failure());
}

// What the trace processes of a node hold, against the node's memory.
void SimulatedFrame::CheckMemory(ProcessId process) {
  const size_t node = static_cast<size_t>((process - 1) / machine_.processors);
  const uint64_t bytes = simulator_.bytes_held(process);
  node_bytes_[node] += bytes - process_bytes_[process];
  process_bytes_[process] = bytes;
  const auto allowed = static_cast<uint64_t>(machine_.process_bytes() * machine_.processors);
  if (node_bytes_[node] <= allowed) return;
  throw std::runtime_error("out of memory: the trace processes of node " + std::to_string(node) +
                           " hold " + std::to_string(node_bytes_[node]) + " bytes, it has " +
                           std::to_string(allowed));
}

void SimulatedFrame::OnStep(ProcessId process, double, double end, size_t) {
  if (process != kHost) return CheckMemory(process);
  const HostProcess::Phase phase = host().phase();
  if (phase == phase_) return;
  if (phase == HostProcess::Phase::kTrace) trace_begin_seconds_ = end;
  if (phase == HostProcess::Phase::kStop) trace_end_seconds_ = end;
  end_seconds_ = end;
  phase_ = phase;
}

SimRun::SimRun(const Options& options, const SimOptions& sim, ObjectSpool* spool,
               Diagnostics* diagnostics)
    : options_(options),
      sim_(sim),
      spool_(spool),
      diagnostics_(diagnostics),
      settings_(spool->settings()),
      machine_(FindMachine(sim.machine)),
      run_(OptionsFor(sim.parallel, machine_)),
      transcript_(sim.transcript_file) {}

int SimRun::Run() {
  const std::string problem = CheckView(settings_);
  if (!problem.empty()) {
    diagnostics_->Report(Severity::kFatal, {}, problem);
    return diagnostics_->exit_status();
  }
  CheckWritable(FrameFile(settings_, settings_.first_frame));
  for (const std::string& file : {options_.stats_file, sim_.parallel.timeline_file})
    if (!file.empty()) CheckWritable(file);

  for (int i = 0; i < std::max(settings_.frames, 1); ++i)
    if (!RenderFrame(settings_.first_frame + i)) return diagnostics_->exit_status();
  Finish();
  return 0;
}

bool SimRun::RenderFrame(int frame) {
  spool_->Place(frame);
  if (spool_->size() == 0) {
    diagnostics_->Report(Severity::kFatal, {}, "Nothing to be rendered.");
    return false;
  }
  SimulatedFrame run(machine_, run_, sim_.schedule_seed, spool_, frame);
  if (Transcript* transcript = transcript_.get()) {
    transcript->Headline("frame " + std::to_string(frame) + ", " + sim_.machine + ", seed " +
                         std::to_string(sim_.schedule_seed) + ": " + Name(run_.schedule) + ", " +
                         std::to_string(run_.processes) + " processes");
    run.AddListener(transcript);
  }
  run.Run();

  std::vector<std::string> nodes;
  for (int p = 0; p < run_.processes; ++p)
    nodes.push_back("node " + std::to_string(p / static_cast<int>(machine_.processors)));
  report_.AddFrame(run.host(), nodes, run.simulator().sent(kHost));
  report_.stats.objects = spool_->size();
  report_.stats.distribute_seconds += run.end_seconds() - run.trace_seconds();
  report_.stats.trace_seconds += run.trace_seconds();
  if (!sim_.parallel.timeline_file.empty()) {
    WriteTimeline(sim_.parallel.timeline_file, run_, run.host(), run.trace_begin_seconds(),
                  run.trace_end_seconds());
  }
  WriteFrame(run.host().sampling().picture(), settings_, frame);

  sequential_seconds_ += CostOf(machine_, SequentialWork(spool_, frame));
  smallest_seconds_ += SmallestSeconds(frame);
  return true;
}

RunOptions SimRun::OptionsForFewer(int processes) const {
  ParallelOptions fewer = sim_.parallel;
  fewer.processes = static_cast<uint16_t>(processes);
  return OptionsFor(fewer, machine_);
}

// Whether the host would begin a run of so many processes.
bool SimRun::MayFit(int processes, int frame) const {
  try {
    HostProcess(OptionsForFewer(processes), spool_, frame);
    return true;
  } catch (const std::runtime_error& e) {
    if (!IsOutOfMemory(e)) throw;
    return false;
  }
}

// The least number from `least` on that may fit, by doubling and halving: what does not fit one
// number of processes does not fit fewer. The run's own number is taken to fit.
int SimRun::LeastThatMayFit(int least, int frame) const {
  int below = least - 1, fits = least;
  while (fits < run_.processes && !MayFit(fits, frame)) {
    below = fits;
    fits = std::min<int>(2 * fits, run_.processes);
  }
  while (fits - below > 1) {
    const int middle = below + (fits - below) / 2;
    (MayFit(middle, frame) ? fits : below) = middle;
  }
  return fits;
}

// Tracing by the least number of processes that the machine's memory allows.
double SimRun::SmallestSeconds(int frame) {
  for (int n = LeastThatMayFit(std::max(smallest_, 1), frame); n < run_.processes; ++n) {
    try {
      SimulatedFrame run(machine_, OptionsForFewer(n), sim_.schedule_seed, spool_, frame);
      run.Run();
      smallest_ = n;
      return run.trace_seconds();
    } catch (const std::runtime_error& e) {
      if (!IsOutOfMemory(e)) throw;  // else: one more process
    }
  }
  smallest_ = run_.processes;
  return report_.stats.trace_seconds - smallest_seconds_;
}

void SimRun::Finish() {
  RunStats& stats = report_.stats;
  report_.Finish(run_);
  stats.peak_bytes = 0;  // of the simulated processes, not of this program
  for (const ProcessStats& process : stats.processes)
    stats.peak_bytes = std::max(stats.peak_bytes, process.peak_bytes);
  const double spent = stats.trace_seconds * run_.processes;
  const double of_sequential = spent > 0 ? sequential_seconds_ / spent : 0;
  const double of_smallest = spent > 0 ? smallest_seconds_ * smallest_ / spent : 0;
  stats.extra.emplace_back("machine", JsonString(sim_.machine));
  stats.extra.emplace_back("schedule_seed", std::to_string(sim_.schedule_seed));
  stats.extra.emplace_back("simulated_seconds", Number(stats.trace_seconds));
  stats.extra.emplace_back("sequential_seconds", Number(sequential_seconds_));
  stats.extra.emplace_back("efficiency_sequential", Number(of_sequential));
  stats.extra.emplace_back("smallest_processes", std::to_string(smallest_));
  stats.extra.emplace_back("smallest_seconds", Number(smallest_seconds_));
  stats.extra.emplace_back("efficiency_smallest", Number(of_smallest));
  if (!options_.stats_file.empty()) WriteStats(stats, options_.stats_file);
  if (settings_.quiet) return;
  std::fprintf(stderr,
               "%s, %d processes, %s: %.6g s simulated; efficiency %.3f against the sequential "
               "renderer (%.6g s), %.3f against %d process%s (%.6g s).\n",
               sim_.machine.c_str(), run_.processes, Name(run_.schedule), stats.trace_seconds,
               of_sequential, sequential_seconds_, of_smallest, smallest_,
               smallest_ == 1 ? "" : "es", smallest_seconds_);
}

}  // namespace rayshade::parallel
