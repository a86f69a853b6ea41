// Fbm: fractal noise above a threshold, as a factor or as places in a colour map
// [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/noise.h"
#include "rayshade/texture/texture_space.h"

namespace rayshade {

class FbmTexture : public PlacedTexture {
 public:
  FbmTexture(const FbmSpec& spec, const TransformChain& transforms)
      : PlacedTexture(transforms), spec_(spec), omega_(OmegaOf(spec.h, spec.lambda)) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  FbmSpec spec_;
  double omega_;
};

}  // namespace rayshade
