// A bar with rate and time left on a terminal. It is told the time: it has no clock.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace rayshade {

class Progress {
 public:
  // stream: a terminal; null: nothing is drawn.
  explicit Progress(std::FILE* stream) : stream_(stream) {}
  ~Progress() { Clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // seconds: since the first ray; fraction: 0 to 1, of the work. Draws a few times in a second.
  void Update(double seconds, double fraction, uint64_t rays);
  // Takes the bar away, before anything else is written.
  void Clear();

  // "[#####               ]  25%   1.20 M rays/s   0:36 left"
  static std::string Line(double seconds, double fraction, uint64_t rays);

 private:
  std::FILE* stream_;
  double drawn_at_seconds_ = -1;
  bool visible_ = false;
};

}  // namespace rayshade
