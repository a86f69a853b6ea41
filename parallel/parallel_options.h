// The long options that prayshade and prayshade-sim have beside Rayshade's letters: how the work is
// spread, under which budgets, compared with what.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "parallel/run_options.h"
#include "rayshade/scene/options.h"

namespace rayshade::parallel {

// What was said; what was not said is left to DefaultsFor.
struct ParallelOptions {
  Schedule schedule = Schedule::kHybrid;
  Distribution distribution = Distribution::kBalanced;
  Shadows shadows = Shadows::kLocal;
  std::optional<uint16_t> processes;
  std::optional<uint64_t> memory, resident, cache;  // bytes
  uint32_t pyramid = 1024;                          // primary rays
  bool compare = false;
  std::string timeline_file;
  std::string compare_program;  // "": rayshade beside the program that runs
};

// The machines that the run is spread over.
struct Machines {
  int count = 1;
  int processors = 1;         // of one machine
  uint64_t memory_bytes = 0;  // of one machine
};

// For ParseOptions; a program may add its own behind them.
std::vector<LongOption> ParallelLongOptions();

// Reads them out of options.extra; names that are not among them are left alone. Throws
// std::invalid_argument naming option and value.
ParallelOptions ParseParallelOptions(const Options& options);

// Fills in what was not said: one trace process for each processor; half of the machines' memory,
// divided by the processes on one machine; a quarter of that for the resident set and for the cache
// each.
RunOptions DefaultsFor(const ParallelOptions& options, const Machines& machines);

// "4096", "64K", "12M", "2G": bytes, in powers of 1024. None: not a size.
std::optional<uint64_t> ParseSize(const std::string& text);

}  // namespace rayshade::parallel
