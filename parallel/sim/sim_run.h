// A whole run on a machine that is not there: each frame distributed, traced and written, the
// figures of --stats simulated. The counterpart of pvm/host_run.h.
#pragma once

#include <string>
#include <vector>

#include "parallel/object_spool.h"
#include "parallel/run_report.h"
#include "parallel/sim/machine.h"
#include "parallel/sim/run_processes.h"
#include "parallel/sim/sim_options.h"
#include "parallel/sim/simulator.h"
#include "parallel/sim/transcript_file.h"
#include "rayshade/common/diagnostics.h"

namespace rayshade::parallel {

// One frame by so many processes.
class SimulatedFrame : public SimulatorListener {
 public:
  // spool: placed for the frame; not owned. Throws std::runtime_error where memory does not
  // suffice.
  SimulatedFrame(const Machine& machine, const RunOptions& options, uint64_t seed,
                 ObjectSpool* spool, int frame);

  void AddListener(SimulatorListener* listener) { simulator_.AddListener(listener); }
  // Throws what makes the run fail: the machine's memory, a malformed message, a hang.
  void Run();

  const HostProcess& host() const { return processes_.host; }
  const Simulator& simulator() const { return simulator_; }
  double trace_begin_seconds() const { return trace_begin_seconds_; }
  double trace_end_seconds() const { return trace_end_seconds_; }
  double trace_seconds() const { return trace_end_seconds_ - trace_begin_seconds_; }
  double end_seconds() const { return end_seconds_; }

  void OnStep(ProcessId process, double begin, double end, size_t bytes) override;

 private:
  void CheckMemory(ProcessId process);

  const Machine machine_;
  RunProcesses processes_;
  MachineTiming timing_;
  Simulator simulator_;
  std::vector<uint64_t> process_bytes_, node_bytes_;  // held now, by process and by node
  HostProcess::Phase phase_ = HostProcess::Phase::kSetUp;
  double trace_begin_seconds_ = 0, trace_end_seconds_ = 0, end_seconds_ = 0;
};

// The file that the options name, for a frame.
void WriteFrame(const Picture& picture, const Settings& settings, int frame);

class SimRun {
 public:
  // Nothing is owned.
  SimRun(const Options& options, const SimOptions& sim, ObjectSpool* spool,
         Diagnostics* diagnostics);

  // The exit status.
  int Run();

 private:
  bool RenderFrame(int frame);
  RunOptions OptionsForFewer(int processes) const;
  bool MayFit(int processes, int frame) const;
  int LeastThatMayFit(int least, int frame) const;
  double SmallestSeconds(int frame);
  void Finish();

  const Options& options_;
  const SimOptions& sim_;
  ObjectSpool* spool_;
  Diagnostics* diagnostics_;
  const Settings settings_;
  Machine machine_;
  RunOptions run_;
  TranscriptFile transcript_;
  RunReport report_;
  double sequential_seconds_ = 0;  // of all frames
  double smallest_seconds_ = 0;    // tracing by `smallest_` processes
  int smallest_ = 0;  // the least number of processes that hold the scene; 0: not known
};

}  // namespace rayshade::parallel
