// What a run reports with --stats FILE: a JSON object, one for sequential and parallel runs alike.
// Filled by whoever runs; nothing here measures.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rayshade/common/op_counts.h"

namespace rayshade {

struct MessageCount {
  uint64_t messages = 0, bytes = 0;
};

// One process of a parallel run; the sequential tracer reports itself as the only one.
struct ProcessStats {
  int id = 0;
  std::string host;
  OpCounts operations;
  double busy_seconds = 0;
  double trace_busy_seconds = 0;  // of these, after the objects were stored
  uint64_t messages_sent = 0, bytes_sent = 0;
  uint64_t cache_hits = 0, cache_misses = 0;
  uint64_t bytes_held_max = 0;  // objects and hierarchy, own and foreign
  uint64_t peak_bytes = 0;      // as the operating system counts
  std::map<std::string, MessageCount> sent_by_kind;
};

struct RunStats {
  // Phases: they follow each other and together are the run.
  double read_seconds = 0;        // parsing
  double build_seconds = 0;       // bounds, hierarchy, subdivision
  double distribute_seconds = 0;  // sending objects out
  double trace_seconds = 0;       // from the first ray to the last pixel
  double write_seconds = 0;       // the picture
  OpCounts operations;            // of all processes
  uint64_t speculative_samples = 0;
  uint64_t objects = 0;
  uint64_t object_bytes = 0;  // all objects and hierarchies; of processes together
  uint64_t peak_bytes = 0;    // of the program itself
  uint64_t messages = 0, bytes_sent = 0;
  std::vector<ProcessStats> processes;
  // Further members, name and JSON value ("12", "\"hybrid\""), in order.
  std::vector<std::pair<std::string, std::string>> extra;

  double total_seconds() const {
    return read_seconds + build_seconds + distribute_seconds + trace_seconds + write_seconds;
  }
};

// A JSON string with its quotes.
std::string JsonString(const std::string& text);
std::string StatsJson(const RunStats& stats);

// Writes beside the file and renames. Throws std::runtime_error naming file and reason.
void WriteStats(const RunStats& stats, const std::string& file);

// Peak memory of this process as the operating system counts it (VmHWM); 0 where it does not tell.
uint64_t PeakBytes();

}  // namespace rayshade
