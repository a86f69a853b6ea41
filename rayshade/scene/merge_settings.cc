// Settings of file and command line; see merge_settings.h.
#include "rayshade/scene/merge_settings.h"

#include <algorithm>

namespace rayshade {
namespace {

// -1 in a file means: as if nothing were said.
void DropUnset(Settings* s) {
  const Settings defaults;
  if (s->samples == -1) s->samples = defaults.samples;
  if (s->aperture == -1) s->aperture = defaults.aperture;
  if (s->focal_distance == -1.0) s->focal_distance.reset();
  if (s->eye_separation == -1.0) s->eye_separation.reset();
  if (s->contrast.r == -1) s->contrast = defaults.contrast;
  if (s->cutoff.r == -1) s->cutoff = defaults.cutoff;
}

template <typename T, typename U>
void Override(T* setting, const std::optional<U>& option) {
  if (option) *setting = *option;
}

}  // namespace

Settings SettingsBeforeFile(const Options& options) {
  Settings s;
  if (options.toggle_gauss) s.filter = FilterKind::kGauss;
  if (options.toggle_shadow_transparency) s.shadow_transparency = false;
  s.verbose = options.verbose;
  s.quiet = options.quiet;
  s.report_file = options.report_file;
  return s;
}

Settings SettingsAfterFile(const Settings& from_file, const Options& options) {
  Settings s = from_file;
  DropUnset(&s);
  ApplyQuality(options.quality, &s);
  if (options.resolution) {
    s.width = options.resolution->first;
    s.height = options.resolution->second;
  }
  Override(&s.output, options.output);
  Override(&s.max_depth, options.max_depth);
  Override(&s.cutoff, options.cutoff);
  Override(&s.samples, options.samples);
  Override(&s.contrast, options.contrast);
  Override(&s.jitter, options.jitter);
  Override(&s.window, options.window);
  Override(&s.crop, options.crop);
  Override(&s.eye_separation, options.eye_separation);
  Override(&s.first_frame, options.first_frame);
  Override(&s.frames, options.frames);
  Override(&s.report_frequency, options.report_frequency);
  Override(&s.gamma, options.gamma);
  s.max_depth = std::max(s.max_depth, 0);
  s.stereo = options.stereo;
  s.shadows = !options.no_shadows;
  s.alpha = options.alpha;
  s.sample_map = options.sample_map;
  s.seed = options.seed;
  return s;
}

}  // namespace rayshade
