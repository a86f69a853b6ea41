// The points; see quality.h.
#include "rayshade/scene/quality.h"

#include <algorithm>

namespace rayshade {
namespace {

void Sample(int n, double contrast, Settings* settings) {
  settings->samples = n;
  settings->contrast = {contrast, contrast, contrast};
  settings->jitter = true;
  settings->pattern = SamplePattern::kLowDiscrepancy;
}

}  // namespace

std::optional<Quality> QualityNamed(std::string_view name) {
  if (name == "draft") return Quality::kDraft;
  if (name == "rayshade") return Quality::kRayshade;
  if (name == "fine") return Quality::kFine;
  if (name == "reference") return Quality::kReference;
  return std::nullopt;
}

void ApplyQuality(Quality quality, Settings* s) {
  switch (quality) {
    case Quality::kDraft:
      Sample(1, 1, s);
      s->max_depth = std::min(s->max_depth, 3);
      for (int c = 0; c < 3; ++c) s->cutoff[c] = std::max(s->cutoff[c], .05);
      s->area_cells = 4;
      s->light_cutoff = 1. / 64;
      return;
    case Quality::kRayshade:
      return;
    case Quality::kFine:
      Sample(4, .05, s);
      s->area_cells = 16;
      return;
    case Quality::kReference:
      Sample(8, 0, s);
      s->every_pixel_full = true;
      s->cutoff = {0, 0, 0};
      return;
  }
}

}  // namespace rayshade
