// See lease.h.
#include "parallel/pvm/lease.h"

namespace rayshade::parallel {

void Lease::Begin(const std::vector<bool>& watched, double now_seconds) {
  watched_ = watched;
  heard_seconds_.assign(watched.size(), now_seconds);
}

void Lease::Heard(ProcessId from, double now_seconds) {
  if (from != kHost && from <= heard_seconds_.size()) heard_seconds_[from - 1] = now_seconds;
}

ProcessId Lease::Silent(double now_seconds) const {
  for (std::size_t i = 0; i < watched_.size(); ++i)
    if (watched_[i] && now_seconds - heard_seconds_[i] > kSeconds)
      return static_cast<ProcessId>(i + 1);
  return kHost;
}

}  // namespace rayshade::parallel
