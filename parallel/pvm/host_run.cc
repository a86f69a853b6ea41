// A parallel run over PVM; see host_run.h.
#include "parallel/pvm/host_run.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "parallel/timeline.h"
#include "rayshade/image/png.h"
#include "rayshade/render/partial_picture.h"

namespace rayshade::parallel {

namespace {

constexpr double kShowEverySeconds = 0.05;
constexpr double kLeaveSeconds = 5;  // for the trace processes to end by themselves

CpuTime CpuTimeUsed() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {seconds(usage.ru_utime), seconds(usage.ru_stime)};
}

// The machines of the virtual machine, each taken to be like this one.
Machines MachinesLikeThis(int count) {
  return {count, static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN)),
          static_cast<uint64_t>(sysconf(_SC_PHYS_PAGES)) *
              static_cast<uint64_t>(sysconf(_SC_PAGESIZE))};
}

AlphaChannel AlphaOf(const Settings& settings) {
  if (settings.sample_map) return AlphaChannel::kSampleMap;
  return settings.alpha ? AlphaChannel::kCoverage : AlphaChannel::kNone;
}

}  // namespace

HostRun::HostRun(const Options& options, const ParallelOptions& parallel, ObjectSpool* spool,
                 Diagnostics* diagnostics, const Stopwatch& stopwatch)
    : options_(options),
      parallel_(parallel),
      spool_(spool),
      diagnostics_(diagnostics),
      stopwatch_(stopwatch),
      settings_(spool->settings()) {}

HostRun::~HostRun() = default;

double HostRun::EndPhase() {
  const double now = stopwatch_.seconds(), spent = now - phase_end_seconds_;
  phase_end_seconds_ = now;
  return spent;
}

int HostRun::Run() {
  stats().read_seconds = EndPhase();
  if (!CheckBeforehand() || !OpenReport()) return diagnostics_->exit_status();

  const int frames = std::max(settings_.frames, 1);
  for (int i = 0; i < frames; ++i) {
    const int frame = settings_.first_frame + i;
    if (!RenderFrame(frame)) return status_ ? status_ : diagnostics_->exit_status();
    if (reports() && i + 1 < frames) ReportFrame(frame, CpuTimeUsed(), PeakBytes(), report());
  }
  if (transport_) EndProcesses();
  stats().distribute_seconds += EndPhase();

  report_data_.Finish(run_);
  if (reports()) {
    ReportStatistics(stats().operations, spool_->kinds_read(), CpuTimeUsed(), PeakBytes(),
                     report());
  }
  if (!options_.stats_file.empty()) WriteStats(stats(), options_.stats_file);
  return 0;
}

bool HostRun::CheckBeforehand() {
  const std::string problem = CheckView(settings_);
  if (!problem.empty()) {
    diagnostics_->Report(Severity::kFatal, {}, problem);
    return false;
  }
  CheckWritable(FrameFile(settings_, settings_.first_frame));
  for (const std::string& file : {options_.stats_file, parallel_.timeline_file})
    if (!file.empty()) CheckWritable(file);
  return true;
}

bool HostRun::OpenReport() {
  if (settings_.report_file.empty()) return true;
  // The file of -V was begun while the scene was read.
  report_.reset(
      std::fopen(settings_.report_file.c_str(), options_.report_file.empty() ? "w" : "a"));
  if (report_) return true;
  diagnostics_->Report(Severity::kFatal, {},
                       "Cannot open stats file " + settings_.report_file + ".");
  return false;
}

// Returns false where the run ends here.
bool HostRun::RenderFrame(int frame) {
  const std::string file = FrameFile(settings_, frame);
  const Kept kept = options_.continue_picture ? LookForKept(file) : Kept::kRender;
  if (kept != Kept::kRender) return kept == Kept::kComplete;

  // Build: what cannot work is found out before anything is started.
  spool_->Place(frame);
  if (spool_->size() == 0) {
    diagnostics_->Report(Severity::kFatal, {}, "Nothing to be rendered.");
    return false;
  }
  stats().build_seconds += EndPhase();
  if (!machine_) StartMachine();
  stats().distribute_seconds += EndPhase();
  HostProcess host(run_, spool_, frame);
  if (options_.continue_picture) Restore(file, frame, &host);
  if (reports() && settings_.verbose) ReportScene(host, frame);
  stats().build_seconds += EndPhase();
  if (reports() && frame == settings_.first_frame) ReportStart(CpuTimeUsed(), report());

  // Distribute, trace.
  if (!transport_) SpawnProcesses();
  if (!Trace(&host)) {
    KeepPartial(host, file, frame);
    return false;
  }
  report_data_.AddFrame(host, MachineNames(), transport_->sent());
  stats().objects = spool_->size();
  if (!parallel_.timeline_file.empty()) {
    WriteTimeline(parallel_.timeline_file, run_, host, trace_begin_seconds_ - frame_begin_seconds_,
                  trace_end_seconds_ - frame_begin_seconds_);
  }

  // Write.
  WritePng(host.sampling().picture(), file, settings_.gamma, AlphaOf(settings_));
  if (file != "-") RemovePartial(file);
  stats().write_seconds += EndPhase();
  return true;
}

HostRun::Kept HostRun::LookForKept(const std::string& file) {
  if (std::filesystem::exists(PartialFile(file))) return Kept::kRender;
  if (std::filesystem::exists(file)) {
    std::fprintf(stderr, "\"%s\" is a complete image.\n", file.c_str());
    return Kept::kComplete;
  }
  if (settings_.frames > 1) return Kept::kRender;
  diagnostics_->Report(Severity::kError, {}, "Cannot open image file " + file + ".");
  return Kept::kStop;
}

void HostRun::Restore(const std::string& file, int frame, HostProcess* host) {
  if (!std::filesystem::exists(PartialFile(file))) return;
  const auto state = ReadPartial(file, PictureFingerprint(settings_, frame, spool_->size()));
  if (!state || !host->Restore(*state))
    throw std::runtime_error(PartialFile(file) + " is damaged.");
  if (!reports()) return;
  std::fprintf(report(), "Continuing \"%s\" at scanline #%d.\n", file.c_str(),
               host->sampling().rows_done() + Camera(settings_, frame).window().miny);
}

void HostRun::ReportScene(const HostProcess& host, int frame) {
  ReportWorld(host.tree().bounds(), spool_->primitives_placed(), report());
  if (frame != settings_.first_frame) return;
  ReportOptions(settings_, Camera(settings_, frame).window(), report());
  std::fprintf(report(), "%d trace processes on %zu PVM hosts, %s.\n", run_.processes,
               machine_->hosts().size(), Name(run_.schedule));
}

void HostRun::StartMachine() {
  machine_ = std::make_unique<VirtualMachine>();
  run_ = DefaultsFor(parallel_, MachinesLikeThis(static_cast<int>(machine_->hosts().size())));
}

void HostRun::SpawnProcesses() {
  spawned_ = machine_->SpawnTraceProcesses(run_.processes);
  std::vector<int> tids;
  std::vector<bool> elsewhere;
  for (const Spawned& s : spawned_) {
    tids.push_back(s.tid);
    elsewhere.push_back(!s.local);
  }
  gone_.assign(spawned_.size(), false);
  transport_ = std::make_unique<PvmTransport>(tids, machine_->one_format());
  loop_ = std::make_unique<ProcessLoop>(transport_.get());
  lease_.Begin(elsewhere, stopwatch_.seconds());
}

std::vector<std::string> HostRun::MachineNames() const {
  std::vector<std::string> names;
  for (const Spawned& s : spawned_) names.push_back(s.machine);
  return names;
}

// False: a signal came first. Throws what makes the run fail.
bool HostRun::Trace(HostProcess* host) {
  const bool bar = reports() && isatty(STDERR_FILENO);
  Progress progress(bar ? stderr : nullptr);
  LineReport lines(settings_, Camera(settings_, settings_.first_frame).window(), report());
  progress_ = &progress;
  lines_ = reports() && (!bar || report_) ? &lines : nullptr;
  host_ = host;
  phase_ = HostProcess::Phase::kSetUp;
  transport_->StartFrame();
  frame_begin_seconds_ = stopwatch_.seconds();
  const bool finished = loop_->Run(host, this);
  NotePhase(host->phase());
  host_ = nullptr;
  progress_ = nullptr;
  lines_ = nullptr;
  progress.Clear();
  if (!host->failure().empty()) throw std::runtime_error(host->failure());
  return finished;
}

bool HostRun::Tick() {
  const double now = stopwatch_.seconds();
  NotePhase(host_->phase());
  const ProcessId silent = lease_.Silent(now);
  if (silent != kHost) {
    host_->OnLost(silent, "nothing was heard from " + spawned_[silent - 1].machine + " for " +
                              std::to_string(static_cast<int>(Lease::kSeconds)) + " s");
  }
  if (now - shown_seconds_ > kShowEverySeconds) {
    shown_seconds_ = now;
    Show(now);
  }
  if (Interrupts::Came() != 0) status_ = 128 + Interrupts::Came();
  return status_ == 0;
}

// Books the time that has passed since the last step of the run.
void HostRun::NotePhase(HostProcess::Phase phase) {
  using Phase = HostProcess::Phase;
  if (phase == phase_ || phase == Phase::kFailed) return;
  const bool was_tracing = phase_ == Phase::kTrace;
  phase_ = phase;
  (was_tracing ? stats().trace_seconds : stats().distribute_seconds) += EndPhase();
  if (phase == Phase::kTrace) trace_begin_seconds_ = phase_end_seconds_;
  if (was_tracing) trace_end_seconds_ = phase_end_seconds_;
}

void HostRun::Show(double now) {
  const std::vector<std::string> texts = host_->TakeTexts();
  if (!texts.empty()) progress_->Clear();
  for (const std::string& text : texts)
    std::fprintf(stderr, "%s: %s\n", options_.program.c_str(), text.c_str());
  if (phase_ != HostProcess::Phase::kTrace || !reports()) return;
  const PixelSampling& sampling = host_->sampling();
  progress_->Update(now - trace_begin_seconds_, sampling.fraction_done(), host_->samples_done());
  if (lines_) lines_->Update(sampling.rows_done(), host_->samples_done(), CpuTimeUsed());
}

void HostRun::OnHeard(ProcessId from) { lease_.Heard(from, stopwatch_.seconds()); }

void HostRun::OnArrival(const Arrival& arrival) {
  if (arrival.kind == Arrival::Kind::kPulse) OnHeard(arrival.from);
  if (arrival.kind != Arrival::Kind::kGone || arrival.from == kHost) return;
  const Spawned& lost = spawned_[arrival.from - 1];
  gone_[arrival.from - 1] = true;
  machine_->Forget(lost.tid);
  if (host_) host_->OnLost(arrival.from, "it has ended on " + lost.machine);
}

// A signal has ended the run: the finished rows are kept.
void HostRun::KeepPartial(const HostProcess& host, const std::string& file, int frame) {
  if (file == "-" || host.sampling().rows_done() == 0) {
    std::fprintf(stderr, "%s: Interrupted; nothing is kept.\n", options_.program.c_str());
    return;
  }
  WritePartial(file, PictureFingerprint(settings_, frame, spool_->size()), host.sampling().Save());
  std::fprintf(stderr, "%s: Interrupted after %d of %d rows; %s keeps them, -c goes on.\n",
               options_.program.c_str(), host.sampling().rows_done(),
               host.sampling().picture().height(), PartialFile(file).c_str());
}

void HostRun::EndProcesses() {
  transport_->SendLeave();
  const double limit = stopwatch_.seconds() + kLeaveSeconds;
  while (std::count(gone_.begin(), gone_.end(), false) > 0 && stopwatch_.seconds() < limit)
    loop_->Await(limit - stopwatch_.seconds(), this);
  machine_.reset();
}

}  // namespace rayshade::parallel
