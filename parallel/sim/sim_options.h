// The long options of prayshade-sim.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "parallel/parallel_options.h"

namespace rayshade::parallel {

struct SimOptions {
  ParallelOptions parallel;
  std::string machine = "powerxplorer";
  uint64_t schedule_seed = 1;
  std::optional<uint64_t> fault_seed;
  std::string transcript_file;  // "": none; "-": standard output
};

// Those of prayshade but --compare, and its own.
std::vector<LongOption> SimLongOptions();
// Throws std::invalid_argument naming option and value.
SimOptions ParseSimOptions(const Options& options);

}  // namespace rayshade::parallel
