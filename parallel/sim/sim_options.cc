// See sim_options.h.
#include "parallel/sim/sim_options.h"

#include <charconv>
#include <cstring>
#include <stdexcept>

namespace rayshade::parallel {

std::vector<LongOption> SimLongOptions() {
  std::vector<LongOption> options = ParallelLongOptions();
  std::erase_if(options, [](const LongOption& o) { return std::strcmp(o.name, "compare") == 0; });
  options.push_back({"machine", "NAME|FILE",
                     "powerxplorer (default), cluster-1g, cluster-100g, or a description."});
  options.push_back({"schedule-seed", "N", "Seed of the order of events (default 1)."});
  return options;
}

SimOptions ParseSimOptions(const Options& options) {
  SimOptions parsed;
  parsed.parallel = ParseParallelOptions(options);
  for (const auto& [name, value] : options.extra) {
    if (name == "machine") parsed.machine = value;
    if (name != "schedule-seed") continue;
    const char* end = value.data() + value.size();
    const auto [stop, error] = std::from_chars(value.data(), end, parsed.schedule_seed);
    if (error != std::errc() || stop != end)
      throw std::invalid_argument("--schedule-seed " + value + ": must be a number");
  }
  return parsed;
}

}  // namespace rayshade::parallel
