// Mount: a colour map by height, turbulence and slope [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class MountTexture : public PlacedTexture {
 public:
  MountTexture(const MountSpec& spec, const TransformChain& transforms);

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  MountSpec spec_;
};

}  // namespace rayshade
