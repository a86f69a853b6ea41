// Fbmbump: the normal is shaken by fractal noise and, as in Rayshade, not normalised
// afterwards [rayshade4/3 s.10; s.14, K13].
#pragma once

#include "rayshade/texture/noise.h"
#include "rayshade/texture/texture_space.h"

namespace rayshade {

class FbmBumpTexture : public PlacedTexture {
 public:
  FbmBumpTexture(const FbmBumpSpec& spec, const TransformChain& transforms)
      : PlacedTexture(transforms), spec_(spec), omega_(OmegaOf(spec.h, spec.lambda)) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  FbmBumpSpec spec_;
  double omega_;
};

}  // namespace rayshade
