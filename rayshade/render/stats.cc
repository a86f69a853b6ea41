// JSON by hand; see stats.h.
#include "rayshade/render/stats.h"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "rayshade/image/output_file.h"

namespace rayshade {
namespace {

// Builds one object, members in order.
class JsonObject {
 public:
  JsonObject& Raw(const std::string& name, const std::string& value) {
    text_ += text_.empty() ? "" : ",";
    text_ += JsonString(name) + ":" + value;
    return *this;
  }
  JsonObject& Add(const std::string& name, uint64_t value) {
    return Raw(name, std::to_string(value));
  }
  JsonObject& AddSeconds(const std::string& name, double value) {
    char number[40];
    std::snprintf(number, sizeof number, "%.6f", value);
    return Raw(name, number);
  }
  std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string RaysJson(const OpCounts& operations) {
  return JsonObject()
      .Add("primary", operations.primary_rays)
      .Add("shadow", operations.shadow_rays)
      .Add("reflected", operations.reflected_rays)
      .Add("refracted", operations.refracted_rays)
      .Add("total", operations.total_rays())
      .text();
}

std::string OperationsJson(const OpCounts& operations) {
  JsonObject object;
#define RAYSHADE_ADD_MEMBER(name) object.Add(#name, operations.name);
  RAYSHADE_OP_COUNTS(RAYSHADE_ADD_MEMBER)
#undef RAYSHADE_ADD_MEMBER
  return object.text();
}

std::string ProcessJson(const ProcessStats& process) {
  JsonObject kinds;
  for (const auto& [kind, count] : process.sent_by_kind) {
    kinds.Raw(kind, JsonObject().Add("messages", count.messages).Add("bytes", count.bytes).text());
  }
  return JsonObject()
      .Raw("id", std::to_string(process.id))
      .Raw("host", JsonString(process.host))
      .Raw("rays", RaysJson(process.operations))
      .AddSeconds("busy_seconds", process.busy_seconds)
      .AddSeconds("trace_busy_seconds", process.trace_busy_seconds)
      .Raw("operations", OperationsJson(process.operations))
      .Add("messages_sent", process.messages_sent)
      .Add("bytes_sent", process.bytes_sent)
      .Add("cache_hits", process.cache_hits)
      .Add("cache_misses", process.cache_misses)
      .Add("bytes_held_max", process.bytes_held_max)
      .Add("peak_bytes", process.peak_bytes)
      .Raw("sent_by_kind", kinds.text())
      .text();
}

}  // namespace

std::string JsonString(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      quoted += escape;
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string StatsJson(const RunStats& stats) {
  std::string processes;
  for (const ProcessStats& process : stats.processes) {
    processes += (processes.empty() ? "" : ",\n ") + ProcessJson(process);
  }
  JsonObject object;
  object.AddSeconds("read_seconds", stats.read_seconds)
      .AddSeconds("build_seconds", stats.build_seconds)
      .AddSeconds("distribute_seconds", stats.distribute_seconds)
      .AddSeconds("trace_seconds", stats.trace_seconds)
      .AddSeconds("write_seconds", stats.write_seconds)
      .Raw("rays", RaysJson(stats.operations))
      .Add("rays_saved", stats.operations.rays_saved)
      .Add("objects", stats.objects)
      .AddSeconds("bytes_per_object",
                  stats.objects ? double(stats.object_bytes) / double(stats.objects) : 0)
      .Add("peak_bytes", stats.peak_bytes)
      .Add("messages", stats.messages)
      .Add("bytes_sent", stats.bytes_sent)
      .Add("supersampled", stats.operations.supersampled_pixels)
      .Add("speculative", stats.speculative_samples)
      .Raw("operations", OperationsJson(stats.operations));
  for (const auto& [name, value] : stats.extra) object.Raw(name, value);
  object.Raw("processes", "[" + processes + "]");
  return object.text() + "\n";
}

void WriteStats(const RunStats& stats, const std::string& file) {
  const std::string text = StatsJson(stats);
  OutputFile output(file);
  std::fwrite(text.data(), 1, text.size(), output.stream());
  output.Commit();
}

uint64_t PeakBytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    uint64_t kilobytes = 0;
    if (std::sscanf(line.c_str(), "VmHWM: %" SCNu64, &kilobytes) == 1) return kilobytes * 1024;
  }
  return 0;
}

}  // namespace rayshade
