// See mount.h.
#include "rayshade/texture/mount.h"

#include "rayshade/common/check.h"
#include "rayshade/texture/noise.h"

namespace rayshade {

MountTexture::MountTexture(const MountSpec& spec, const TransformChain& transforms)
    : PlacedTexture(transforms), spec_(spec) {
  CHECK(spec.map != nullptr);
}

void MountTexture::Apply(TextureHit* hit) const {
  const Vector p = PointOf(*hit);
  const double height = p.z + spec_.turbulence * Chaos(p, 7) - spec_.slope * (1.0 - hit->normal.z);
  const Color& factor = MapEntry(*spec_.map, height * 256.0);
  hit->surface.ambient = factor * hit->surface.ambient;
  hit->surface.diffuse = factor * hit->surface.diffuse;
  hit->surface.specular = factor * hit->surface.specular;
}

size_t MountTexture::bytes() const {
  return sizeof(*this) + space().bytes() + spec_.map->size() * sizeof(Color);
}

}  // namespace rayshade
