// See timeline.h.
#include "parallel/timeline.h"

#include <cinttypes>
#include <cstdio>

#include "rayshade/image/output_file.h"

namespace rayshade::parallel {

void WriteTimeline(const std::string& file, const RunOptions& options, const HostProcess& host,
                   double trace_begin_seconds, double trace_end_seconds) {
  OutputFile output(file);
  std::FILE* f = output.stream();
  std::fprintf(f, "run,%s,%d,%.9g,%.9g\n", Name(options.schedule), options.processes,
               trace_begin_seconds, trace_end_seconds);
  const std::vector<Statistics>& processes = host.statistics();
  for (size_t i = 0; i < processes.size(); ++i) {
    const Statistics& s = processes[i];
    std::fprintf(f, "process,%zu,%" PRIu64 ",%" PRIu64 ",%" PRIu64 ",%.9g\n", i + 1, s.demand_rays,
                 s.data_rays, s.forwarded_rays, s.busy_seconds);
  }
  for (size_t i = 0; i < processes.size(); ++i) {
    const double width = processes[i].interval_seconds;
    for (size_t k = 0; k < processes[i].busy_by_interval.size(); ++k) {
      if (processes[i].busy_by_interval[k] <= 0) continue;
      std::fprintf(f, "busy,%zu,%.9g,%.9g,%.9g\n", i + 1, width * static_cast<double>(k),
                   width * static_cast<double>(k + 1), processes[i].busy_by_interval[k]);
    }
  }
  output.Commit();
}

}  // namespace rayshade::parallel
