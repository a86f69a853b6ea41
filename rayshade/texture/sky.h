// Sky: fractal clouds on a plane or dome, transparent between them [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/noise.h"
#include "rayshade/texture/texture_space.h"

namespace rayshade {

class SkyTexture : public PlacedTexture {
 public:
  SkyTexture(const SkySpec& spec, const TransformChain& transforms)
      : PlacedTexture(transforms), spec_(spec), omega_(OmegaOf(spec.h, spec.lambda)) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  SkySpec spec_;
  double omega_;
};

}  // namespace rayshade
