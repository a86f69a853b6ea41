// Wood: rings and grain [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class WoodTexture : public PlacedTexture {
 public:
  explicit WoodTexture(const TransformChain& transforms) : PlacedTexture(transforms) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;
};

}  // namespace rayshade
