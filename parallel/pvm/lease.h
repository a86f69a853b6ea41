// Who has been silent for too long. PVM tells of a lost task at once, but of a lost machine only
// after minutes; so a trace process on another machine sends a sign of life every second, between
// two steps of work.
#pragma once

#include <cstddef>
#include <vector>

#include "parallel/process_id.h"

namespace rayshade::parallel {

class Lease {
 public:
  // watched[i]: whether process i + 1 is on another machine.
  void Begin(const std::vector<bool>& watched, double now_seconds);
  void Heard(ProcessId from, double now_seconds);
  // One that has been silent for longer than a lease lasts; kHost where there is none.
  ProcessId Silent(double now_seconds) const;

  static constexpr double kSeconds = 30;

 private:
  std::vector<bool> watched_;
  std::vector<double> heard_seconds_;
};

}  // namespace rayshade::parallel
