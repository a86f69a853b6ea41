// See compare.h.
#include "parallel/pvm/compare.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "rayshade/render/render_picture.h"

namespace rayshade::parallel {

namespace {

// A folder that goes away.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const char* parent = std::getenv("TMPDIR");
    path_ = std::string(parent && *parent ? parent : "/tmp") + "/prayshade-compare.XXXXXX";
    if (!mkdtemp(path_.data())) throw std::runtime_error("no folder can be made as " + path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string ReadAll(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The number behind the first such key; our own JSON has no blank there.
double NumberIn(const std::string& json, const std::string& key) {
  const size_t at = json.find('"' + key + "\":");
  return at == std::string::npos ? 0 : std::atof(json.c_str() + at + key.size() + 3);
}

std::optional<RunStats> StatsOf(const std::string& json) {
  if (json.empty()) return std::nullopt;
  RunStats stats;
  stats.read_seconds = NumberIn(json, "read_seconds");
  stats.build_seconds = NumberIn(json, "build_seconds");
  stats.distribute_seconds = NumberIn(json, "distribute_seconds");
  stats.trace_seconds = NumberIn(json, "trace_seconds");
  stats.write_seconds = NumberIn(json, "write_seconds");
  stats.operations.primary_rays = static_cast<uint64_t>(NumberIn(json, "primary"));
  stats.operations.shadow_rays = static_cast<uint64_t>(NumberIn(json, "shadow"));
  stats.operations.reflected_rays = static_cast<uint64_t>(NumberIn(json, "reflected"));
  stats.operations.refracted_rays = static_cast<uint64_t>(NumberIn(json, "refracted"));
  return stats;
}

// Runs a program, searched as a shell would; its standard output is dropped. Returns whether it
// ended with status 0.
bool Execute(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork(" + program + ") fails");
  if (child == 0) {
    const int null = open("/dev/null", O_WRONLY);
    if (null >= 0) dup2(null, STDOUT_FILENO);
    execvp(program.c_str(), words.data());
    std::perror(program.c_str());
    _exit(127);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string SequentialProgram(const ParallelOptions& parallel) {
  if (!parallel.compare_program.empty()) return parallel.compare_program;
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "rayshade";
}

// Our own programs write statistics; another one is asked again without.
SequentialRun RunSequential(const std::string& program, std::vector<std::string> arguments,
                            const std::string& folder, bool ours) {
  arguments.insert(arguments.end(), {"-q", "-O", folder + "/picture.png"});
  std::vector<std::string> with_stats = arguments;
  with_stats.insert(with_stats.end(), {"--stats", folder + "/stats.json"});
  SequentialRun run;
  Stopwatch stopwatch;
  bool good = Execute(program, with_stats);
  if (!good && !ours) {
    stopwatch = Stopwatch();
    good = Execute(program, arguments);
  }
  if (!good) throw std::runtime_error("the sequential program " + program + " fails");
  run.wall_seconds = stopwatch.seconds();
  run.stats = StatsOf(ReadAll(folder + "/stats.json"));
  return run;
}

std::string ComparePictures(const Settings& ours, const std::string& folder) {
  Settings theirs = ours;
  theirs.output = folder + "/picture.png";
  for (int i = 0; i < std::max(ours.frames, 1); ++i) {
    const int frame = ours.first_frame + i;
    const std::string picture = ReadAll(FrameFile(theirs, frame));
    if (!picture.starts_with("\x89PNG")) return "not compared: the other program makes no PNG";
    if (picture != ReadAll(FrameFile(ours, frame)))
      return ours.frames > 1 ? "not identical, frame " + std::to_string(frame) : "not identical";
  }
  return "identical";
}

std::string Row(const char* name, const std::string& left, const std::string& right) {
  char line[160];
  std::snprintf(line, sizeof line, "%-22s %14s %14s\n", name, left.c_str(), right.c_str());
  return line;
}

std::string Decimals(const char* format, double number) {
  char text[40];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

std::string SecondsRow(const char* name, const std::optional<RunStats>& left, const RunStats& right,
                       double RunStats::*phase) {
  return Row(name, left ? Decimals("%.3f", (*left).*phase) : "-", Decimals("%.3f", right.*phase));
}

}  // namespace

void CheckComparable(const Options& options) {
  if (options.input.empty() || options.input == "-")
    throw std::invalid_argument("--compare needs the scene as a file, not on standard input");
  if (options.output == "-")
    throw std::invalid_argument("--compare needs the picture in a file, not on standard output");
}

std::vector<std::string> SequentialArguments(const std::vector<std::string>& arguments) {
  std::vector<LongOption> dropped = ParallelLongOptions();
  dropped.push_back({"stats", "FILE", ""});
  std::vector<std::string> kept;
  for (size_t i = 1; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    const auto option = std::find_if(dropped.begin(), dropped.end(), [&word](const LongOption& o) {
      const std::string dashed = std::string("--") + o.name;
      return word == dashed || word.starts_with(dashed + "=");
    });
    if (option == dropped.end()) {
      kept.push_back(word);
    } else if (word.find('=') == std::string::npos &&
               !std::string(option->argument).ends_with('?')) {
      ++i;  // its value
    }
  }
  return kept;
}

std::string ComparisonTable(const SequentialRun& sequential, const RunStats& parallel,
                            const std::string& pictures) {
  const std::optional<RunStats>& left = sequential.stats;
  std::string table = Row("", "sequential", "parallel");
  table += Row("processes", "1", std::to_string(parallel.processes.size()));
  table += SecondsRow("read, s", left, parallel, &RunStats::read_seconds);
  table += SecondsRow("build, s", left, parallel, &RunStats::build_seconds);
  table += SecondsRow("distribute, s", left, parallel, &RunStats::distribute_seconds);
  table += SecondsRow("trace, s", left, parallel, &RunStats::trace_seconds);
  table += SecondsRow("write, s", left, parallel, &RunStats::write_seconds);
  table += Row("all, s", Decimals("%.3f", sequential.wall_seconds),
               Decimals("%.3f", parallel.total_seconds()));
  table += Row("rays", left ? std::to_string(left->operations.total_rays()) : "-",
               std::to_string(parallel.operations.total_rays()));
  table += Row("messages", "-", std::to_string(parallel.messages));

  // Tracing alone where both tell it, as the paper times it; else everything.
  const double before = left ? left->trace_seconds : sequential.wall_seconds;
  const double after = left ? parallel.trace_seconds : parallel.total_seconds();
  const double speed_up = after > 0 ? before / after : 0;
  table += Row(left ? "speed-up (trace)" : "speed-up (all)", "", Decimals("%.2f", speed_up));
  table += Row("efficiency", "",
               Decimals("%.2f", speed_up / std::max<size_t>(parallel.processes.size(), 1)));
  return table + "pictures: " + pictures + "\n";
}

int Compare(const std::vector<std::string>& arguments, const ParallelOptions& parallel,
            const Settings& settings, const RunStats& stats) {
  const TemporaryFolder folder;
  const SequentialRun run =
      RunSequential(SequentialProgram(parallel), SequentialArguments(arguments), folder.path(),
                    parallel.compare_program.empty());
  const std::string table = ComparisonTable(run, stats, ComparePictures(settings, folder.path()));
  std::fputs(table.c_str(), stdout);
  return std::fflush(stdout) == 0 ? 0 : 1;
}

}  // namespace rayshade::parallel
