// Stripe: a border of another surface around each unit square of (u, v), raised above it by a
// bevel [rayshade4/3 s.10].
#pragma once

#include "rayshade/texture/mapping.h"
#include "rayshade/texture/texture_space.h"

namespace rayshade {

class StripeTexture : public PlacedTexture {
 public:
  StripeTexture(const StripeSpec& spec, const Surface& surface, const TransformChain& transforms)
      : PlacedTexture(transforms),
        width_(spec.width),
        bump_(spec.bump),
        mapping_(spec.mapping),
        surface_(surface) {}

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  double width_, bump_;
  Mapping mapping_;
  Surface surface_;
};

}  // namespace rayshade
