// Windy: waves on water, stronger where the wind blows [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class WindyTexture : public PlacedTexture {
 public:
  WindyTexture(const WindySpec& spec, const TransformChain& transforms)
      : PlacedTexture(transforms), spec_(spec) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  WindySpec spec_;
};

}  // namespace rayshade
