// Gloss: the normal is drawn at random around the true one [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class GlossTexture : public PlacedTexture {
 public:
  GlossTexture(const GlossSpec& spec, const TransformChain& transforms)
      : PlacedTexture(transforms), gloss_(spec.gloss) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  double gloss_;
};

}  // namespace rayshade
