// Marble: veins, as a factor or as places in a colour map [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/texture_space.h"

namespace rayshade {

class MarbleTexture : public PlacedTexture {
 public:
  MarbleTexture(const MarbleSpec& spec, const TransformChain& transforms)
      : PlacedTexture(transforms), map_(spec.map) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  std::shared_ptr<const ColorMap> map_;  // null: a factor
};

}  // namespace rayshade
