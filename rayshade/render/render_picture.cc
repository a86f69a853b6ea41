// The sequential program after parsing; see render_picture.h. The only place of the core that looks
// at a clock or at signals.
#include "rayshade/render/render_picture.h"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "rayshade/image/png.h"
#include "rayshade/render/camera.h"
#include "rayshade/render/partial_picture.h"
#include "rayshade/render/pixel_sampling.h"
#include "rayshade/render/progress.h"
#include "rayshade/render/report.h"
#include "rayshade/render/sequential_tracer.h"
#include "rayshade/render/stats.h"

namespace rayshade {
namespace {

constexpr size_t kBundle = 1024;
constexpr double kKeepEverySeconds = 60;  // of tracing: how often an unfinished picture is saved
constexpr int kInterrupted = 130;         // exit status

CpuTime CpuTimeUsed() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return {seconds(usage.ru_utime), seconds(usage.ru_stime)};
}

// While it lives, SIGINT and SIGTERM wait to be asked for instead of ending the program. Signals
// that the program was started to ignore stay ignored.
class SignalWatch {
 public:
  SignalWatch() {
    sigemptyset(&watched_);
    for (const int signal : {SIGINT, SIGTERM}) {
      struct sigaction action;
      if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) {
        sigaddset(&watched_, signal);
      }
    }
    sigprocmask(SIG_BLOCK, &watched_, &before_);
  }
  ~SignalWatch() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  bool Came() const {
    const timespec at_once = {0, 0};
    return sigtimedwait(&watched_, nullptr, &at_once) > 0;
  }

 private:
  sigset_t watched_, before_;
};

// One run: all frames.
class Renderer {
 public:
  Renderer(const Options& options, SceneBuilder* scene, Diagnostics* diagnostics,
           const Stopwatch& stopwatch)
      : options_(options),
        scene_(scene),
        settings_(scene->settings()),
        diagnostics_(diagnostics),
        stopwatch_(stopwatch) {}

  int Run();

 private:
  enum class Traced { kWhole, kInterrupted };

  bool CheckBeforehand();
  bool OpenReport();
  bool RenderFrame(int frame);
  Traced Trace(const SceneBuilder::Built& built, const Camera& camera, const std::string& file,
               const std::string& fingerprint, PixelSampling* sampling);
  void KeepPartial(const std::string& file, const std::string& fingerprint,
                   const PixelSampling& sampling);
  void CountFrame(const SceneBuilder::Built& built, const PixelSampling& sampling);
  void WriteStatsFile();
  // Seconds since the last phase ended.
  double EndPhase() {
    const double now = stopwatch_.seconds(), spent = now - phase_end_seconds_;
    phase_end_seconds_ = now;
    return spent;
  }
  // A report file is written even where the terminal is to stay silent.
  bool reports() const { return !settings_.quiet || report_; }
  std::FILE* report() const { return report_ ? report_.get() : stderr; }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  const Options& options_;
  SceneBuilder* scene_;
  const Settings settings_;
  Diagnostics* diagnostics_;
  const Stopwatch& stopwatch_;
  std::unique_ptr<std::FILE, Close> report_;  // null: standard error
  double phase_end_seconds_ = 0;
  RunStats stats_;
  int status_ = 0;
};

int Renderer::Run() {
  stats_.read_seconds = EndPhase();
  if (!CheckBeforehand() || !OpenReport()) return diagnostics_->exit_status();

  const int frames = std::max(settings_.frames, 1);
  for (int i = 0; i < frames; ++i) {
    const int frame = settings_.first_frame + i;
    if (!RenderFrame(frame)) return status_ ? status_ : diagnostics_->exit_status();
    if (reports() && i + 1 < frames) ReportFrame(frame, CpuTimeUsed(), PeakBytes(), report());
  }
  if (reports()) {
    ReportStatistics(stats_.operations, scene_->kinds_read(), CpuTimeUsed(), PeakBytes(), report());
  }
  WriteStatsFile();
  return 0;
}

bool Renderer::CheckBeforehand() {
  const std::string problem = CheckView(settings_);
  if (!problem.empty()) {
    diagnostics_->Report(Severity::kFatal, {}, problem);
    return false;
  }
  CheckWritable(FrameFile(settings_, settings_.first_frame));
  if (!options_.stats_file.empty()) CheckWritable(options_.stats_file);
  return true;
}

bool Renderer::OpenReport() {
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
bool Renderer::RenderFrame(int frame) {
  const std::string file = FrameFile(settings_, frame);
  const bool kept = std::filesystem::exists(PartialFile(file));
  if (options_.continue_picture && !kept) {
    if (std::filesystem::exists(file)) {
      std::fprintf(stderr, "\"%s\" is a complete image.\n", file.c_str());
      return true;
    }
    if (settings_.frames <= 1) {
      diagnostics_->Report(Severity::kError, {}, "Cannot open image file " + file + ".");
      return false;
    }
  }

  // Build.
  const SceneBuilder::Built built = scene_->Build(frame);
  if (built.objects->size() == 0) {
    diagnostics_->Report(Severity::kFatal, {}, "Nothing to be rendered.");
    return false;
  }
  const Camera camera(settings_, frame);
  if (reports() && settings_.verbose) {
    Bounds world = built.objects->bounds();
    if (!world.empty()) world.Grow(2 * kEpsilon);  // as the original's list of everything
    ReportWorld(world, scene_->primitives_placed(), report());
    if (frame == settings_.first_frame) ReportOptions(settings_, camera.window(), report());
  }
  PixelSampling sampling(settings_, camera, false);
  stats_.build_seconds += EndPhase();
  if (reports() && frame == settings_.first_frame) ReportStart(CpuTimeUsed(), report());

  // Trace.
  const std::string fingerprint = PictureFingerprint(settings_, frame, built.objects->size());
  if (options_.continue_picture && kept) {
    const auto state = ReadPartial(file, fingerprint);
    if (!state || !sampling.Restore(*state)) {
      throw std::runtime_error(PartialFile(file) + " is damaged.");
    }
    if (reports()) {
      std::fprintf(report(), "Continuing \"%s\" at scanline #%d.\n", file.c_str(),
                   sampling.rows_done() + camera.window().miny);
    }
  }
  const Traced traced = Trace(built, camera, file, fingerprint, &sampling);
  CountFrame(built, sampling);
  stats_.trace_seconds += EndPhase();
  if (traced == Traced::kInterrupted) {
    KeepPartial(file, fingerprint, sampling);
    std::fprintf(stderr, "%s: Interrupted after %d of %d rows; %s keeps them, -c goes on.\n",
                 options_.program.c_str(), sampling.rows_done(), camera.window().height(),
                 PartialFile(file).c_str());
    status_ = kInterrupted;
    return false;
  }

  // Write.
  const AlphaChannel alpha = settings_.sample_map ? AlphaChannel::kSampleMap
                             : settings_.alpha    ? AlphaChannel::kCoverage
                                                  : AlphaChannel::kNone;
  WritePng(sampling.picture(), file, settings_.gamma, alpha);
  if (file != "-") RemovePartial(file);
  stats_.write_seconds += EndPhase();
  return true;
}

Renderer::Traced Renderer::Trace(const SceneBuilder::Built& built, const Camera& camera,
                                 const std::string& file, const std::string& fingerprint,
                                 PixelSampling* sampling) {
  const SignalWatch signals;
  const bool bar = !settings_.quiet && isatty(STDERR_FILENO);
  Progress progress(bar ? stderr : nullptr);
  LineReport lines(settings_, camera.window(), report());
  const double begin = stopwatch_.seconds();
  double kept_at = begin;
  SequentialTracer tracer(built.scene.get(), built.objects.get());
  RayBundle bundle;
  std::vector<RayResult> results;
  while (!sampling->done()) {
    const std::vector<Sample> samples = sampling->Next(kBundle);
    if (samples.empty() && !sampling->done()) {
      throw std::runtime_error(PartialFile(file) + " is damaged.");  // the only way to get here
    }
    bundle.clear();
    camera.AppendPrimaryRays(samples, &bundle.rays);
    results.resize(samples.size());
    tracer.Trace(bundle, results, &stats_.operations);
    sampling->Put(samples, results);

    const double now = stopwatch_.seconds();
    const OpCounts& counts = stats_.operations;
    progress.Update(now - begin, sampling->fraction_done(), counts.total_rays());
    if (reports() && (!bar || report_) && sampling->rows_done() > lines.rows_reported()) {
      lines.Update(sampling->rows_done(), counts.primary_rays, CpuTimeUsed());
    }
    if (signals.Came()) return Traced::kInterrupted;
    if (now - kept_at > kKeepEverySeconds) {
      KeepPartial(file, fingerprint, *sampling);
      kept_at = now;
    }
  }
  return Traced::kWhole;
}

void Renderer::KeepPartial(const std::string& file, const std::string& fingerprint,
                           const PixelSampling& sampling) {
  if (file != "-") WritePartial(file, fingerprint, sampling.Save());
}

void Renderer::CountFrame(const SceneBuilder::Built& built, const PixelSampling& sampling) {
  stats_.operations.supersampled_pixels += sampling.supersampled_pixels();
  stats_.objects = built.objects->size();
  stats_.object_bytes = built.objects->bytes();
}

void Renderer::WriteStatsFile() {
  if (options_.stats_file.empty()) return;
  stats_.write_seconds += EndPhase();
  stats_.peak_bytes = PeakBytes();
  char host[256] = "";
  gethostname(host, sizeof host - 1);
  ProcessStats process;
  process.host = host;
  process.operations = stats_.operations;
  process.busy_seconds = process.trace_busy_seconds = stats_.trace_seconds;
  process.bytes_held_max = stats_.object_bytes;
  process.peak_bytes = stats_.peak_bytes;
  stats_.processes.push_back(process);
  WriteStats(stats_, options_.stats_file);
}

}  // namespace

std::string FrameFile(const Settings& settings, int frame) {
  const std::string& name = settings.output;
  if (settings.frames <= 1 || name == "-") return name;
  char number[20];
  std::snprintf(number, sizeof number, ".%04d", frame);
  const bool png = name.size() >= 4 && name.compare(name.size() - 4, 4, ".png") == 0;
  return png ? name.substr(0, name.size() - 4) + number + ".png" : name + number;
}

int RenderPictures(const Options& options, SceneBuilder* scene, Diagnostics* diagnostics,
                   const Stopwatch& stopwatch) {
  return Renderer(options, scene, diagnostics, stopwatch).Run();
}

}  // namespace rayshade
