// Edge signs in 113-bit arithmetic; see edge_sign.h. Slow (software), but asked only for rays
// within some 1e-14 of an edge.
#include "rayshade/geom/edge_sign.h"

namespace rayshade {
namespace {

using Quad = __float128;

constexpr Quad kNoise = 0x1.0p-104;

Quad Size(Quad x) { return x < 0 ? -x : x; }

// Of a number that was added up from parts of this size in all.
int SignOf(Quad sum, Quad size) {
  const Quad noise = size * kNoise;
  return sum > noise ? 1 : sum < -noise ? -1 : 0;
}

}  // namespace

int EdgeSign(const Vector& origin, const Vector& direction, const Vector& a, const Vector& b) {
  Quad p[3], q[3], sum = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    p[i] = Quad(a[i]) - Quad(origin[i]);
    q[i] = Quad(b[i]) - Quad(origin[i]);
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Quad left = p[j] * q[k], right = p[k] * q[j];
    sum += Quad(direction[i]) * (left - right);
    size += Size(Quad(direction[i])) * (Size(left) + Size(right));
  }
  return SignOf(sum, size);
}

int EdgeSignBeside(const Vector& origin, const Vector& direction, const Vector& a,
                   const Vector& b) {
  const int sign = EdgeSign(origin, direction, a, b);
  if (sign != 0) return sign;
  // Moved by -step, D . ((a - O) x (b - O)) grows by step . ((b - a) x D).
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Quad left = (Quad(b[j]) - Quad(a[j])) * Quad(direction[k]);
    const Quad right = (Quad(b[k]) - Quad(a[k])) * Quad(direction[j]);
    const int along = SignOf(left - right, Size(left) + Size(right));
    if (along != 0) return along;
  }
  return 0;
}

}  // namespace rayshade
