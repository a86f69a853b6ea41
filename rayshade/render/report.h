// The lines of Rayshade's report, which its users know [rayshade4/1 s.11].
#pragma once

#include <cstdint>
#include <cstdio>
#include <vector>

#include "rayshade/common/bounds.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/render/camera.h"
#include "rayshade/scene/settings.h"

namespace rayshade {

struct CpuTime {
  double user_seconds = 0, system_seconds = 0;
  double total() const { return user_seconds + system_seconds; }
};

// The object block of the world. bounds: of its bounded objects, may be empty.
void ReportWorld(const Bounds& bounds, uint64_t primitives, std::FILE* stream);
// The option list.
void ReportOptions(const Settings& settings, const PictureWindow& window, std::FILE* stream);
void ReportStart(const CpuTime& cpu, std::FILE* stream);
// After each frame but the last.
void ReportFrame(int frame, const CpuTime& cpu, uint64_t bytes, std::FILE* stream);
// At the end, over all frames. kinds: those of the scene, in the order of their first appearance;
// they have a line each, in reverse, where there were tests.
void ReportStatistics(const OpCounts& counts, const std::vector<size_t>& kinds, const CpuTime& cpu,
                      uint64_t bytes, std::FILE* stream);

// "Finished line Y (R rays)" for every row whose number is a multiple of the frequency, but the
// last.
class LineReport {
 public:
  LineReport(const Settings& settings, const PictureWindow& window, std::FILE* stream);
  void Update(int rows_done, uint64_t eye_rays, const CpuTime& cpu);
  int rows_reported() const { return reported_; }

 private:
  int frequency_;
  bool verbose_;
  PictureWindow window_;
  std::FILE* stream_;
  int reported_ = 0;  // rows
  double last_cpu_seconds_ = 0;
};

}  // namespace rayshade
