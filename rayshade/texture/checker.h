// Checker: every second cell of a cubic lattice has another surface [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class CheckerTexture : public PlacedTexture {
 public:
  CheckerTexture(const Surface& surface, const TransformChain& transforms)
      : PlacedTexture(transforms), surface_(surface) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  Surface surface_;
};

}  // namespace rayshade
