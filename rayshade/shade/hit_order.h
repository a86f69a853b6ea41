// The order in which the hits of a bundle lie in rows: neighbours in space together, so that the
// shadow rays of eight or 64 in a row towards one light make a narrow pyramid, also where objects
// at different distances are side by side in the picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "rayshade/shade/shade.h"

namespace rayshade {

class HitOrder {
 public:
  static constexpr size_t kMost = 512;  // hits

  // by_place: else as they come. REQUIRES: at most kMost.
  void Set(std::span<const SurfaceHit> hits, bool by_place);

  size_t hit(size_t row) const { return hit_[row]; }
  size_t row(size_t hit) const { return row_[hit]; }

 private:
  uint16_t hit_[kMost], row_[kMost];
};

}  // namespace rayshade
