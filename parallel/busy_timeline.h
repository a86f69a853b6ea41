// How busy a process was, over time: the bars of figure 8. Kept by whoever runs the process, in at
// most kIntervals equal intervals whose length doubles as the run gets longer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rayshade::parallel {

class BusyTimeline {
 public:
  static constexpr size_t kIntervals = 1024;

  // Busy from begin to end, seconds since the run began.
  void Add(double begin, double end) {
    total_seconds_ += end - begin;
    while (end >= interval_seconds_ * kIntervals) Double();
    const size_t last = static_cast<size_t>(end / interval_seconds_);
    if (busy_seconds_.size() <= last) busy_seconds_.resize(last + 1);
    for (size_t i = static_cast<size_t>(begin / interval_seconds_); i <= last; ++i) {
      const double from = static_cast<double>(i) * interval_seconds_, to = from + interval_seconds_;
      const double inside = (end < to ? end : to) - (begin > from ? begin : from);
      if (inside > 0) busy_seconds_[i] += inside;
    }
  }

  double total_seconds() const { return total_seconds_; }
  double interval_seconds() const { return interval_seconds_; }
  const std::vector<double>& busy_seconds() const { return busy_seconds_; }  // by interval

 private:
  void Double() {
    interval_seconds_ *= 2;
    const size_t n = (busy_seconds_.size() + 1) / 2;
    for (size_t i = 0; i < n; ++i) {
      const double second = 2 * i + 1 < busy_seconds_.size() ? busy_seconds_[2 * i + 1] : 0;
      busy_seconds_[i] = busy_seconds_[2 * i] + second;
    }
    busy_seconds_.resize(n);
  }

  double total_seconds_ = 0;
  double interval_seconds_ = 1.0 / 4096;
  std::vector<double> busy_seconds_;
};

}  // namespace rayshade::parallel
