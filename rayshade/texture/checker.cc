// See checker.h.
#include "rayshade/texture/checker.h"

namespace rayshade {
namespace {

// The parity of the cell that a coordinate lies in. 0 itself lies in cell 1.
int Parity(double x) { return Truncated(x > 0 ? x : 1.0 - x) & 1; }

}  // namespace

void CheckerTexture::Apply(TextureHit* hit) const {
  const Vector p = PointOf(*hit);
  if ((Parity(p.x) ^ Parity(p.y) ^ Parity(p.z)) == 1) hit->surface = surface_;
}

size_t CheckerTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
