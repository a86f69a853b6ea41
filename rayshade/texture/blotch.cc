// See blotch.h.
#include "rayshade/texture/blotch.h"

#include "rayshade/texture/noise.h"

namespace rayshade {

void BlotchTexture::Apply(TextureHit* hit) const {
  const double v = Noise(PointOf(*hit));
  if (!(v > mix_)) return;
  const double w = (v - mix_) / (1.0 - mix_);
  hit->surface = Blend(hit->surface, surface_, 1.0 - w, w);
}

size_t BlotchTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
