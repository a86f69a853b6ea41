// Cloud: a sphere of fractal cloud, thinner towards its limb [rayshade4/3 s.10; s.14, K14].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class CloudTexture : public PlacedTexture {
 public:
  CloudTexture(const CloudSpec& spec, const TransformChain& transforms);

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  CloudSpec spec_;
  double omega_;
  double max_;  // taken for the greatest value of the sum
};

}  // namespace rayshade
