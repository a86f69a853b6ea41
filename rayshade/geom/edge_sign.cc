// Edge signs; see edge_sign.h. In double where its rounding cannot matter, else in 113-bit
// arithmetic, which is slow (software).
#include "rayshade/geom/edge_sign.h"

namespace rayshade {
namespace {

using Quad = __float128;

constexpr Quad kNoise = 0x1.0p-104;
// Products smaller than this may have lost digits to the end of double's range.
constexpr double kSmallest = 1e-200;

template <typename Real>
Real Size(Real x) {
  return x < 0 ? -x : x;
}

// D . ((a - O) x (b - O)), and the sum of the sizes of its terms.
template <typename Real>
struct EdgeSum {
  Real sum = 0, size = 0;

  EdgeSum(const Vector& origin, const Vector& direction, const Vector& a, const Vector& b) {
    Real p[3], q[3];
    for (int i = 0; i < 3; ++i) {
      p[i] = Real(a[i]) - Real(origin[i]);
      q[i] = Real(b[i]) - Real(origin[i]);
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const Real left = p[j] * q[k], right = p[k] * q[j];
      sum += Real(direction[i]) * (left - right);
      size += Size(Real(direction[i])) * (Size(left) + Size(right));
    }
  }
};

// Of a number that was added up from parts of this size in all.
int SignOf(Quad sum, Quad size) {
  const Quad noise = size * kNoise;
  return sum > noise ? 1 : sum < -noise ? -1 : 0;
}

}  // namespace

int EdgeSign(const Vector& origin, const Vector& direction, const Vector& a, const Vector& b) {
  // Each term is off by less than 8 roundings of its size.
  const EdgeSum<double> rough(origin, direction, a, b);
  const double margin = rough.size * 0x1.0p-48;
  if (margin > kSmallest && Size(rough.sum) > margin) return rough.sum > 0 ? 1 : -1;
  const EdgeSum<Quad> fine(origin, direction, a, b);
  return SignOf(fine.sum, fine.size);
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
