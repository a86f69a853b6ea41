// A ray is a value without pointers: it can leave the process. Rays travel in bundles of 1 to 1024;
// what only few rays need (the media they are inside of) lies beside them in the bundle, so that a
// scene without glass pays nothing.
//
//   1. Origin and direction never change during a ray's life (DESIGN, exactness 4).
//   2. Distances are measured along the direction as it is; it has length 1 but for mirror rays
//   after fbmbump
//      [rayshade4/3 s.5.1].
#pragma once

#include <cstdint>
#include <vector>

#include "rayshade/common/color.h"
#include "rayshade/common/vector.h"

namespace rayshade {

enum class RayKind : uint8_t { kPrimary, kShadow, kReflected, kRefracted };

// A medium that a ray is inside of: refraction index, and the fraction of light left after one unit
// of length.
struct Medium {
  double index = 1;
  double extinct = 1;
  bool operator==(const Medium&) const = default;
};

struct Ray {
  Vector origin;                   // world space
  Vector direction;                // world space
  double min_distance = kEpsilon;  // hits nearer than this do not count
  double time = 0;                 // moment within the shutter interval
  Color contribution{1, 1, 1};     // product of the weights from the eye to here; for the cutoff
  uint64_t key = 0;                // of its random numbers: sample and path (common/keyed_random.h)
  uint32_t sample_number = 0;      // place in the order tables [rayshade4/1 s.8.5] and, above its
                                   // bits, the pixel's shift (common/sample_pattern.h); inherited
  uint32_t media_begin = 0;        // its media in the bundle, outermost first
  uint16_t media_count = 0;
  uint16_t depth = 0;  // eye rays have 0
  RayKind kind = RayKind::kPrimary;
};

// Rays traced together, and the media of those that are inside something.
struct RayBundle {
  std::vector<Ray> rays;
  std::vector<Medium> media;

  size_t size() const { return rays.size(); }
  bool empty() const { return rays.empty(); }
  void clear() {
    rays.clear();
    media.clear();
  }
};

}  // namespace rayshade
