// The parallel program after parsing: a virtual machine, trace processes, and each frame built,
// distributed, traced and written. The counterpart of render/render_picture.h.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "parallel/host_process.h"
#include "parallel/object_spool.h"
#include "parallel/parallel_options.h"
#include "parallel/pvm/interrupts.h"
#include "parallel/pvm/lease.h"
#include "parallel/pvm/process_loop.h"
#include "parallel/pvm/pvm_transport.h"
#include "parallel/pvm/virtual_machine.h"
#include "parallel/run_report.h"
#include "rayshade/common/diagnostics.h"
#include "rayshade/render/progress.h"
#include "rayshade/render/render_picture.h"
#include "rayshade/render/report.h"
#include "rayshade/render/stats.h"

namespace rayshade::parallel {

class HostRun : public LoopListener {
 public:
  // stopwatch: started when the program was. Nothing is owned.
  HostRun(const Options& options, const ParallelOptions& parallel, ObjectSpool* spool,
          Diagnostics* diagnostics, const Stopwatch& stopwatch);
  ~HostRun() override;

  // The exit status: 0, that of the diagnostics, or 128 and the signal that ended the run. Throws
  // std::exception where the run fails. Either way nothing is left running, and no part of a
  // picture written.
  int Run();

  // Filled when Run has returned 0.
  const RunStats& statistics() const { return report_data_.stats; }

  void OnArrival(const Arrival& arrival) override;
  void OnHeard(ProcessId from) override;
  bool Tick() override;

 private:
  bool CheckBeforehand();
  bool OpenReport();
  bool RenderFrame(int frame);
  // Where -c was said: whether the frame needs no rendering, or the run cannot go on.
  enum class Kept { kRender, kComplete, kStop };
  Kept LookForKept(const std::string& file);
  void Restore(const std::string& file, int frame, HostProcess* host);
  void ReportScene(const HostProcess& host, int frame);
  void StartMachine();
  void SpawnProcesses();
  std::vector<std::string> MachineNames() const;
  bool Trace(HostProcess* host);
  void NotePhase(HostProcess::Phase phase);
  void Show(double now);
  void KeepPartial(const HostProcess& host, const std::string& file, int frame);
  void EndProcesses();
  RunStats& stats() { return report_data_.stats; }

  // Seconds since the last phase ended.
  double EndPhase();
  bool reports() const { return !settings_.quiet; }
  std::FILE* report() const { return report_ ? report_.get() : stderr; }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  const Options& options_;
  const ParallelOptions& parallel_;
  ObjectSpool* spool_;
  Diagnostics* diagnostics_;
  const Stopwatch& stopwatch_;
  const Settings settings_;
  std::unique_ptr<std::FILE, Close> report_;  // null: standard error

  Interrupts interrupts_;
  std::unique_ptr<VirtualMachine> machine_;
  RunOptions run_;
  std::vector<Spawned> spawned_;  // [0] is process 1
  std::vector<bool> gone_;
  std::unique_ptr<PvmTransport> transport_;
  std::unique_ptr<ProcessLoop> loop_;
  Lease lease_;

  // Of the frame being rendered.
  HostProcess* host_ = nullptr;
  HostProcess::Phase phase_ = HostProcess::Phase::kSetUp;
  Progress* progress_ = nullptr;
  LineReport* lines_ = nullptr;
  double frame_begin_seconds_ = 0, trace_begin_seconds_ = 0, trace_end_seconds_ = 0;
  double shown_seconds_ = 0;

  double phase_end_seconds_ = 0;
  RunReport report_data_;
  int status_ = 0;
};

}  // namespace rayshade::parallel
