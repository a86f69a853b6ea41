// --compare: the same pictures by a sequential program, and both runs side by side. The paper's
// measure: speed-up is sequential tracing time by parallel tracing time, efficiency is speed-up by
// processes [RJ s.6].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parallel/parallel_options.h"
#include "rayshade/render/stats.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/settings.h"

namespace rayshade::parallel {

// Throws std::invalid_argument where the run cannot be repeated: standard input or output.
void CheckComparable(const Options& options);

// The command line without what only prayshade knows, and without --stats.
std::vector<std::string> SequentialArguments(const std::vector<std::string>& arguments);

// One side of the table; no seconds: the program does not tell.
struct SequentialRun {
  double wall_seconds = 0;
  std::optional<RunStats> stats;  // phases and rays only
};

// pictures: what is to be said of them.
std::string ComparisonTable(const SequentialRun& sequential, const RunStats& parallel,
                            const std::string& pictures);

// Runs the program (rayshade beside this one, unless one was named) and prints the table on
// standard output. Returns the exit status: 0 where the program made its pictures.
int Compare(const std::vector<std::string>& arguments, const ParallelOptions& parallel,
            const Settings& settings, const RunStats& stats);

}  // namespace rayshade::parallel
