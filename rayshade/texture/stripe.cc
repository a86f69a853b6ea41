// See stripe.h.
#include "rayshade/texture/stripe.h"

#include <cmath>

namespace rayshade {

void StripeTexture::Apply(TextureHit* hit) const {
  const MappedPoint at = mapping_.Map(*hit, space(), true);
  const double w = width_, b = bump_;
  double u = at.u - std::floor(at.u), v = at.v - std::floor(at.v);

  // The middle of the square stays, the stripe has its own surface.
  if (u > 2.0 * w && v > 2.0 * w && u <= 1.0 - w && v <= 1.0 - w) return;
  if (u < w || v < w) {
    hit->surface = surface_;
    return;
  }

  // The bevel between them leans towards the nearest side.
  u = (u - w) / (1.0 - w);
  v = (v - w) / (1.0 - w);
  const bool low = v < u, left = v < 1.0 - u;
  double fu = 0, fv = 0;
  (low == left ? fv : fu) = left ? -b : b;
  hit->normal = Tilted(hit->normal, at, fu, fv);
}

size_t StripeTexture::bytes() const { return sizeof(*this) + space().bytes(); }

}  // namespace rayshade
