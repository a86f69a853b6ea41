// See bump.h.
#include "rayshade/texture/bump.h"

#include "rayshade/texture/noise.h"

namespace rayshade {

void BumpTexture::Apply(TextureHit* hit) const {
  hit->normal = Normalized(hit->normal + size_ * DNoise(PointOf(*hit)));
}

size_t BumpTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
