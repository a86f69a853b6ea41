// See fbm_bump.h.
#include "rayshade/texture/fbm_bump.h"

namespace rayshade {

void FbmBumpTexture::Apply(TextureHit* hit) const {
  const Vector d = VectorFbm(PointOf(*hit), omega_, spec_.lambda, spec_.octaves);
  const Vector shake{spec_.offset + spec_.scale * d.x, spec_.offset + spec_.scale * d.y,
                     spec_.offset + spec_.scale * d.z};
  hit->normal = hit->normal + shake;
}

size_t FbmBumpTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
