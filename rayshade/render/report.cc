// See report.h. Tabs and blanks are the original's.
#include "rayshade/render/report.h"

#include <algorithm>
#include <cctype>
#include <cinttypes>
#include <string>

#include "rayshade/geom/kind_name.h"

namespace rayshade {
namespace {

void Count(const char* name, const char* tabs, uint64_t count, std::FILE* stream) {
  std::fprintf(stream, "%s%s%" PRIu64 "\n", name, tabs, count);
}

void Memory(uint64_t bytes, std::FILE* stream) {
  std::fprintf(stream, "Total memory allocated:\t\t%" PRIu64 " bytes\n", bytes);
}

double Percent(uint64_t part, uint64_t whole) { return 100. * part / whole; }

void Tests(const std::string& name, const KindCounts& counts, std::FILE* stream) {
  std::fprintf(stream, "%s intersection tests:\t%" PRIu64 " (%" PRIu64 " hit, %f%%)\n",
               name.c_str(), counts.tests, counts.hits, Percent(counts.hits, counts.tests));
}

void ReportTests(const OpCounts& counts, const std::vector<size_t>& kinds, std::FILE* stream) {
  KindCounts total;
  for (auto kind = kinds.rbegin(); kind != kinds.rend(); ++kind) {
    KindCounts sum;
    for (size_t i = 0; i < kGeomKinds; ++i) {
      if (ReportedKind(i) == *kind) sum += counts.kinds[i];
    }
    total += sum;
    if (sum.tests == 0) continue;
    std::string name(kKindNames[*kind]);
    name[0] = static_cast<char>(std::toupper(name[0]));
    Tests(name, sum, stream);
  }
  if (total.tests == 0) return Count("Total prim. intersection tests:", "\t", 0, stream);
  Tests("Total prim.", total, stream);
}

}  // namespace

void ReportWorld(const Bounds& bounds, uint64_t primitives, std::FILE* stream) {
  std::fprintf(stream, "list \"World\":\n");
  for (int axis = 0; axis < 3 && !bounds.empty(); ++axis) {
    std::fprintf(stream, "\t%c: %f to %f\n", "XYZ"[axis], bounds.low[axis], bounds.high[axis]);
  }
  std::fprintf(stream, "\t%" PRIu64 " primitive%s\n", primitives, primitives == 1 ? " " : "s");
}

void ReportOptions(const Settings& s, const PictureWindow& window, std::FILE* stream) {
  const int last_frame = s.first_frame + std::max(s.frames, 1) - 1;
  if (s.frames > 1) {
    std::fprintf(stream, "Rendering frames %d through %d.\n", s.first_frame, last_frame);
  } else {
    std::fprintf(stream, "Rendering frame %d.\n", s.first_frame);
  }
  std::fprintf(stream, "Screen resolution: %d x %d\n", s.width, s.height);
  std::fprintf(stream, "Image window: (%d - %d), (%d - %d).\n", window.minx, window.maxx,
               window.miny, window.maxy);
  std::fprintf(stream, "%sMax sampling rate %d sample%s/pixel.\n",
               s.jitter ? "Using jittered sampling, " : "", s.samples * s.samples,
               s.samples == 1 ? "" : "s");
  std::fprintf(stream, "Maximum contrast: %g red, %g green, %g blue.\n", s.contrast.r, s.contrast.g,
               s.contrast.b);
  std::fprintf(stream, "Maximum ray depth: %d.  Cutoff thresh: %g %g %g.\n", s.max_depth,
               s.cutoff.r, s.cutoff.g, s.cutoff.b);
  if (s.stereo == StereoEye::kLeft) std::fprintf(stream, "Rendering image for left eye.\n");
  if (s.stereo == StereoEye::kRight) std::fprintf(stream, "Rendering image for right eye.\n");
  if (!s.shadows) {
    std::fprintf(stream, "No shadows are rendered.\n");
  } else if (s.shadow_transparency) {
    std::fprintf(stream, "Object opacity affects depth of shadowing.\n");
  }
  if (s.frames != 1) std::fprintf(stream, "Rendering %d frames.\n", s.frames);
}

void ReportStart(const CpuTime& cpu, std::FILE* stream) {
  std::fprintf(stream, "Preprocessing time:\t%2.2fu  %2.2fs\nStarting trace.\n", cpu.user_seconds,
               cpu.system_seconds);
}

void ReportFrame(int frame, const CpuTime& cpu, uint64_t bytes, std::FILE* stream) {
  std::fprintf(stream, "Total CPU time for frame %d: %2.2f \n", frame, cpu.total());
  Memory(bytes, stream);
}

void ReportStatistics(const OpCounts& counts, const std::vector<size_t>& kinds, const CpuTime& cpu,
                      uint64_t bytes, std::FILE* stream) {
  const uint64_t total = counts.total_rays();
  const uint64_t intersecting = counts.hits + counts.shadow_hits;
  Count("Eye rays:", "\t\t\t", counts.primary_rays, stream);
  Count("Shadow rays:", "\t\t\t", counts.shadow_rays, stream);
  Count("Reflected rays:", "\t\t\t", counts.reflected_rays, stream);
  Count("Refracted rays:", "\t\t\t", counts.refracted_rays, stream);
  Count("Total rays:", "\t\t\t", total, stream);
  if (counts.rays_saved > 0) Count("Rays not traced:", "\t\t", counts.rays_saved, stream);
  if (total > 0) {
    std::fprintf(stream, "Intersecting rays:\t\t%" PRIu64 " (%3.3f%%)\n", intersecting,
                 Percent(intersecting, total));
  }
  if (counts.shadow_rays > 0) {
    std::fprintf(stream, "Total shadow hits:\t\t%" PRIu64 " (%3.3f%%)\n", counts.shadow_hits,
                 Percent(counts.shadow_hits, counts.shadow_rays));
  }
  Count("Supersampled pixels:", "\t\t", counts.supersampled_pixels, stream);
  Count("B.V. intersection tests:", "\t", counts.node_visits, stream);
  ReportTests(counts, kinds, stream);
  std::fprintf(stream, "Total CPU time (sec):\t\t%2.2f (%2.2fu + %2.2fs)\n", cpu.total(),
               cpu.user_seconds, cpu.system_seconds);
  if (total > 0) std::fprintf(stream, "Seconds / ray:\t\t\t%4.4f\n", cpu.total() / total);
  if (intersecting > 0) {
    std::fprintf(stream, "Seconds / intersecting ray:\t%4.4f\n", cpu.total() / intersecting);
  }
  Memory(bytes, stream);
}

LineReport::LineReport(const Settings& settings, const PictureWindow& window, std::FILE* stream)
    : frequency_(std::max(1, settings.report_frequency)),
      verbose_(settings.verbose),
      window_(window),
      stream_(stream) {}

void LineReport::Update(int rows_done, uint64_t eye_rays, const CpuTime& cpu) {
  for (; reported_ < std::min(rows_done, window_.height() - 1); ++reported_) {
    const int y = reported_ + window_.miny;
    if (y % frequency_ != 0) continue;
    std::fprintf(stream_, "Finished line %d (%" PRIu64 " rays", y, eye_rays);
    if (verbose_) {
      std::fprintf(stream_, ", %2.2f sec, %2.2f split", cpu.total(),
                   cpu.total() - last_cpu_seconds_);
      last_cpu_seconds_ = cpu.total();
    }
    std::fprintf(stream_, ")\n");
  }
}

}  // namespace rayshade
