// The parallel programs' long options; see parallel_options.h.
#include "parallel/parallel_options.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>

#include "parallel/work_queue.h"

namespace rayshade::parallel {

namespace {

[[noreturn]] void Refuse(const std::string& name, const std::string& value,
                         const std::string& wanted) {
  throw std::invalid_argument("--" + name + " " + value + ": must be " + wanted);
}

// The whole of the text as a number.
template <class Number>
std::optional<Number> ParseNumber(const std::string& text) {
  Number number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

template <class Number>
Number NumberOf(const std::string& name, const std::string& value, Number least, Number most) {
  const std::optional<Number> number = ParseNumber<Number>(value);
  if (!number || *number < least || *number > most)
    Refuse(name, value, "a number from " + std::to_string(least) + " to " + std::to_string(most));
  return *number;
}

uint64_t SizeOf(const std::string& name, const std::string& value) {
  const std::optional<uint64_t> size = ParseSize(value);
  if (!size) Refuse(name, value, "a size: bytes, or a number with K, M or G behind it");
  return *size;
}

Schedule ScheduleOf(const std::string& name, const std::string& value) {
  for (const Schedule s : {Schedule::kDataParallel, Schedule::kDemandDriven, Schedule::kHybrid})
    if (value == Name(s)) return s;
  Refuse(name, value, "data-parallel, demand-driven or hybrid");
}

Shadows ShadowsOf(const std::string& name, const std::string& value) {
  for (const Shadows s : {Shadows::kLocal, Shadows::kTravel})
    if (value == Name(s)) return s;
  Refuse(name, value, "local or travel");
}

Distribution DistributionOf(const std::string& name, const std::string& value) {
  if (value == "grid") return Distribution::kGrid;
  if (value == "balanced") return Distribution::kBalanced;
  Refuse(name, value, "grid or balanced");
}

void Read(const std::string& name, const std::string& value, ParallelOptions* options) {
  if (name == "processes") {
    options->processes = NumberOf<uint16_t>(name, value, 1, 4096);
  } else if (name == "schedule") {
    options->schedule = ScheduleOf(name, value);
  } else if (name == "distribution") {
    options->distribution = DistributionOf(name, value);
  } else if (name == "shadows") {
    options->shadows = ShadowsOf(name, value);
  } else if (name == "memory") {
    options->memory = SizeOf(name, value);
  } else if (name == "resident") {
    options->resident = SizeOf(name, value);
  } else if (name == "cache") {
    options->cache = SizeOf(name, value);
  } else if (name == "pyramid") {
    options->pyramid = NumberOf<uint32_t>(name, value, 1, 1024);
  } else if (name == "timeline") {
    options->timeline_file = value;
  } else if (name == "compare") {
    options->compare = true;
    options->compare_program = value;
  }
}

}  // namespace

std::vector<LongOption> ParallelLongOptions() {
  return {
      {"processes", "N", "trace processes  [one for each processor]"},
      {"schedule", "NAME", "data-parallel, demand-driven, hybrid  [hybrid]"},
      {"distribution", "NAME",
       "who owns what: balanced, by predicted work; grid, equal voxels  [balanced]"},
      {"shadows", "WHERE",
       "shadow rays: local, objects are fetched; travel, to the objects  [local]"},
      {"memory", "SIZE", "budget of one trace process: 4096, 64K, 12M, 2G; 0: no limit"},
      {"resident", "SIZE", "objects near the eye that every process holds"},
      {"cache", "SIZE", "fetched objects that a process keeps"},
      {"pyramid", "PIXELS", "primary rays handed out at once  [1024]"},
      {"timeline", "FILE", "write what each process did, and when it was busy"},
      {"compare", "PROGRAM?", "render by rayshade (or PROGRAM) as well, and compare"},
  };
}

ParallelOptions ParseParallelOptions(const Options& options) {
  ParallelOptions parsed;
  for (const auto& [name, value] : options.extra) Read(name, value, &parsed);
  if (parsed.shadows == Shadows::kTravel && !ForwardsRays(parsed.schedule))
    throw std::invalid_argument("--shadows travel: no ray travels by --schedule demand-driven");
  return parsed;
}

RunOptions DefaultsFor(const ParallelOptions& options, const Machines& machines) {
  RunOptions run;
  run.schedule = options.schedule;
  run.distribution = options.distribution;
  run.shadows = options.shadows;
  run.pyramid = options.pyramid;
  run.processes = options.processes.value_or(static_cast<uint16_t>(
      std::clamp(int64_t{machines.count} * machines.processors, int64_t{1}, int64_t{4096})));

  const int on_one_machine = (run.processes + machines.count - 1) / machines.count;
  run.memory = options.memory.value_or(machines.memory_bytes / 2 / on_one_machine);
  run.resident = options.resident.value_or(run.memory / 4);
  run.cache = options.cache.value_or(run.memory / 4);
  return run;
}

std::optional<uint64_t> ParseSize(const std::string& text) {
  if (text.empty()) return std::nullopt;
  int shift = 0;
  switch (text.back()) {
    case 'k':
    case 'K':
      shift = 10;
      break;
    case 'm':
    case 'M':
      shift = 20;
      break;
    case 'g':
    case 'G':
      shift = 30;
      break;
    default:
      break;
  }
  const std::optional<uint64_t> number =
      ParseNumber<uint64_t>(shift ? text.substr(0, text.size() - 1) : text);
  if (!number || *number > std::numeric_limits<uint64_t>::max() >> shift) return std::nullopt;
  return *number << shift;
}

}  // namespace rayshade::parallel
