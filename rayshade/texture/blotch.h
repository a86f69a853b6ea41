// Blotch: another surface shines through where the noise is high [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class BlotchTexture : public PlacedTexture {
 public:
  BlotchTexture(const BlotchSpec& spec, const Surface& surface, const TransformChain& transforms)
      : PlacedTexture(transforms), mix_(spec.mix), surface_(surface) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  double mix_;
  Surface surface_;
};

}  // namespace rayshade
