// Bump: the normal is shaken by noise [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class BumpTexture : public PlacedTexture {
 public:
  BumpTexture(const BumpSpec& spec, const TransformChain& transforms)
      : PlacedTexture(transforms), size_(spec.size) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  double size_;
};

}  // namespace rayshade
