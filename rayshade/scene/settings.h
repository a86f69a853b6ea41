// View, sampling and output settings of a scene file, after file and command line have been merged
// [rayshade4/1 s.6]. Members hold the defaults.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rayshade/common/color.h"
#include "rayshade/common/vector.h"

namespace rayshade {

enum class FilterKind : uint8_t { kBox, kGauss };
enum class SamplePattern : uint8_t { kRayshade, kLowDiscrepancy };
enum class StereoEye : uint8_t { kNone, kLeft, kRight };

struct Window {
  int xmin = 0, xmax = 0, ymin = 0, ymax = 0;
};
struct Crop {
  double left = 0, right = 1, low = 0, high = 1;
};

struct Settings {
  // Camera.
  Vector eye{0, -10, 0}, look{0, 0, 0}, up{0, 0, 1};
  double hfov = 45;
  std::optional<double> vfov;  // none: hfov * height / width
  int width = 512, height = 512;
  std::optional<Window> window;
  Crop crop;
  double aperture = 0;
  std::optional<double> focal_distance;  // none: from eye to look point
  std::optional<double> eye_separation;
  StereoEye stereo = StereoEye::kNone;
  // Time.
  double start_time = 0, frame_length = 1, shutter = 0;
  int first_frame = 0, frames = 1;
  // Sampling.
  int samples = 3;  // n: n x n sub-cells per pixel
  bool jitter = true;
  FilterKind filter = FilterKind::kBox;
  std::optional<double> filter_width;  // none: 1.0 (box), 1.8 (Gaussian)
  Color contrast{.2, .15, .3};
  uint64_t seed = 1;  // of the picture's random numbers
  // What only --quality sets; the defaults are Rayshade's ways.
  SamplePattern pattern = SamplePattern::kRayshade;
  bool every_pixel_full = false;  // whatever the contrast
  int area_cells = 0;             // of an area light, that one hit asks; 0: all
  double light_cutoff = 0;        // lights that could add less arrive untested
  // Shading.
  int max_depth = 5;
  Color cutoff{.002, .002, .002};
  Color background;
  Color ambient_light{1, 1, 1};
  bool shadows = true;
  bool shadow_transparency = true;
  // Output.
  std::string output = "rays.png";
  double gamma = 1;
  bool alpha = false;
  bool sample_map = false;
  int report_frequency = 10;
  bool verbose = false;
  bool quiet = false;
  std::string report_file;  // empty: standard error

  double filter_width_used() const {
    return filter_width.value_or(filter == FilterKind::kBox ? 1.0 : 1.8);
  }
};

}  // namespace rayshade
