// See sim_options.h.
#include "parallel/sim/sim_options.h"

#include <charconv>
#include <cstring>
#include <stdexcept>

namespace rayshade::parallel {

namespace {

uint64_t SeedOf(const std::string& name, const std::string& value) {
  uint64_t seed = 0;
  const char* end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, seed);
  if (error != std::errc() || stop != end)
    throw std::invalid_argument("--" + name + " " + value + ": must be a number");
  return seed;
}

}  // namespace

std::vector<LongOption> SimLongOptions() {
  std::vector<LongOption> options = ParallelLongOptions();
  std::erase_if(options, [](const LongOption& o) { return std::strcmp(o.name, "compare") == 0; });
  options.push_back({"machine", "NAME|FILE",
                     "powerxplorer, cluster-1g, cluster-100g, or a description  [powerxplorer]"});
  options.push_back({"schedule-seed", "N", "seed of the order of events  [1]"});
  options.push_back({"transcript", "FILE", "write a line for each message; - is standard output"});
  options.push_back({"fault-seed", "N",
                     "instead of a machine: a run that N makes difficult, with every invariant "
                     "checked"});
  return options;
}

SimOptions ParseSimOptions(const Options& options) {
  SimOptions parsed;
  parsed.parallel = ParseParallelOptions(options);
  for (const auto& [name, value] : options.extra) {
    if (name == "machine") {
      parsed.machine = value;
    } else if (name == "schedule-seed") {
      parsed.schedule_seed = SeedOf(name, value);
    } else if (name == "fault-seed") {
      parsed.fault_seed = SeedOf(name, value);
    } else if (name == "transcript") {
      parsed.transcript_file = value;
    }
  }
  return parsed;
}

}  // namespace rayshade::parallel
