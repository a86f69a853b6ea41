// See run_report.h.
#include "parallel/run_report.h"

#include <algorithm>

namespace rayshade::parallel {

namespace {

void AddProcess(const Statistics& s, ProcessStats* p) {
  p->operations += s.counts;
  p->busy_seconds += s.busy_seconds;
  p->trace_busy_seconds += s.trace_busy_seconds;
  p->cache_hits += s.cache_hits;
  p->cache_misses += s.cache_misses;
  p->bytes_held_max = std::max(p->bytes_held_max, s.bytes_held_max);
  p->peak_bytes = std::max(p->peak_bytes, s.peak_bytes);
  for (const KindCount& count : s.sent) {
    p->messages_sent += count.messages;
    p->bytes_sent += count.bytes;
    p->sent_by_kind[count.name].messages += count.messages;
    p->sent_by_kind[count.name].bytes += count.bytes;
  }
}

std::string Json(const std::map<std::string, MessageCount>& kinds) {
  std::string text;
  for (const auto& [name, count] : kinds) {
    text += (text.empty() ? "" : ",") + JsonString(name) +
            ":{\"messages\":" + std::to_string(count.messages) +
            ",\"bytes\":" + std::to_string(count.bytes) + "}";
  }
  return "{" + text + "}";
}

}  // namespace

std::vector<uint8_t> WithSent(std::span<const uint8_t> bytes,
                              const std::array<KindCount, kTags>& sent) {
  Statistics statistics = Decode<Statistics>(bytes);
  for (const KindCount& count : sent)
    if (count.messages > 0) statistics.sent.push_back(count);
  statistics.sent.push_back({Statistics::kName, 1, 0});
  statistics.sent.back().bytes = Encode(statistics).size();
  return Encode(statistics);
}

void RunReport::CountSent(const KindCount& count) {
  if (count.messages == 0) return;
  stats.messages += count.messages;
  stats.bytes_sent += count.bytes;
  sent_by_kind_[count.name].messages += count.messages;
  sent_by_kind_[count.name].bytes += count.bytes;
}

void RunReport::AddFrame(const HostProcess& host, const std::vector<std::string>& machines,
                         const std::array<KindCount, kTags>& host_sent) {
  const std::vector<Statistics>& reports = host.statistics();
  stats.processes.resize(reports.size());
  stats.object_bytes = 0;
  for (size_t i = 0; i < reports.size(); ++i) {
    const Statistics& report = reports[i];
    stats.processes[i].id = static_cast<int>(i + 1);
    stats.processes[i].host = machines[i];
    AddProcess(report, &stats.processes[i]);
    stats.operations += report.counts;
    stats.object_bytes += report.object_bytes;
    demand_rays_ += report.demand_rays;
    data_rays_ += report.data_rays;
    forwarded_rays_ += report.forwarded_rays;
    for (const KindCount& count : report.sent) CountSent(count);
  }
  for (const KindCount& count : host_sent) CountSent(count);
  stats.operations.supersampled_pixels += host.sampling().supersampled_pixels();
  stats.speculative_samples += host.sampling().speculative_samples();
  cells_ = host.tree().size();
  in_flight_limit_ = host.in_flight_limit();
}

void RunReport::Finish(const RunOptions& run) {
  const auto add = [this](const char* name, uint64_t value) {
    stats.extra.emplace_back(name, std::to_string(value));
  };
  stats.extra.emplace_back("schedule", JsonString(Name(run.schedule)));
  add("memory", run.memory);
  add("resident", run.resident);
  add("cache", run.cache);
  add("cells", cells_);
  add("rays_in_flight_max", in_flight_limit_);
  add("demand_rays", demand_rays_);
  add("data_rays", data_rays_);
  add("forwarded_rays", forwarded_rays_);
  stats.extra.emplace_back("sent_by_kind", Json(sent_by_kind_));
  stats.peak_bytes = PeakBytes();
}

}  // namespace rayshade::parallel
