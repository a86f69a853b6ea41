// See progress.h.
#include "rayshade/render/progress.h"

#include <algorithm>

namespace rayshade {
namespace {

constexpr double kDrawEverySeconds = .2;
constexpr int kBarWidth = 30;

std::string Duration(double seconds) {
  char text[40];
  const long long s = static_cast<long long>(std::clamp(seconds, 0.0, 1e9) + .5);
  if (s >= 3600) {
    std::snprintf(text, sizeof text, "%lld:%02lld:%02lld", s / 3600, s / 60 % 60, s % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld:%02lld", s / 60, s % 60);
  }
  return text;
}

}  // namespace

void Progress::Update(double seconds, double fraction, uint64_t rays) {
  if (!stream_ || seconds - drawn_at_seconds_ < kDrawEverySeconds) return;
  drawn_at_seconds_ = seconds;
  visible_ = true;
  std::fprintf(stream_, "\r%s\033[K", Line(seconds, fraction, rays).c_str());
  std::fflush(stream_);
}

void Progress::Clear() {
  if (!visible_) return;
  visible_ = false;
  std::fprintf(stream_, "\r\033[K");
  std::fflush(stream_);
}

std::string Progress::Line(double seconds, double fraction, uint64_t rays) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  const int filled = static_cast<int>(fraction * kBarWidth);
  const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, ' ');
  char figures[80];
  std::snprintf(figures, sizeof figures, "%3d%%  %6.2f M rays/s", static_cast<int>(fraction * 100),
                seconds > 0 ? rays / seconds * 1e-6 : 0);
  const std::string left =
      fraction > 0 && seconds > 0 ? Duration(seconds / fraction * (1 - fraction)) : "-:--";
  return "[" + bar + "] " + figures + "  " + left + " left";
}

}  // namespace rayshade
