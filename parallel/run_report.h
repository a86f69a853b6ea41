// From what the processes report to RunStats, the numbers of --stats.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "parallel/host_process.h"
#include "parallel/message.h"
#include "parallel/run_options.h"
#include "rayshade/render/stats.h"

namespace rayshade::parallel {

// A Statistics message with what only its transport has counted; it counts itself.
std::vector<uint8_t> WithSent(std::span<const uint8_t> statistics,
                              const std::array<KindCount, kTags>& sent);

class RunReport {
 public:
  // Adds one frame: operations, messages and bytes are summed over frames, memory is the greatest.
  // machines: of the trace processes; host_sent: what the host itself has sent.
  void AddFrame(const HostProcess& host, const std::vector<std::string>& machines,
                const std::array<KindCount, kTags>& host_sent);
  // At the end: what else is worth knowing.
  void Finish(const RunOptions& run);

  // Phases are filled by the caller.
  RunStats stats;

 private:
  void CountSent(const KindCount& count);

  std::map<std::string, MessageCount> sent_by_kind_;  // by all processes, the host among them
  uint64_t demand_rays_ = 0, data_rays_ = 0, forwarded_rays_ = 0;
  size_t cells_ = 0;
  uint32_t in_flight_limit_ = 0;
};

}  // namespace rayshade::parallel
