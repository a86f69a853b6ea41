// Bracketing by derivatives; see quartic.h.
#include "rayshade/geom/quartic.h"

#include <algorithm>
#include <cmath>

namespace rayshade {
namespace {

// A polynomial of some degree up to 4, c[0] first.
struct Polynomial {
  double c[5] = {};
  int degree = 0;

  double operator()(double x) const {
    double value = c[degree];
    for (int i = degree - 1; i >= 0; --i) value = value * x + c[i];
    return value;
  }
  Polynomial Derivative() const {
    Polynomial d;
    d.degree = std::max(degree - 1, 0);
    for (int i = 1; i <= degree; ++i) d.c[i - 1] = i * c[i];
    return d;
  }
};

int Sign(double x) { return x < 0 ? -1 : 1; }

// The zero between a and b, whose signs differ, but for `tolerance`: Newton, kept inside the
// bracket by halving it.
double Bracketed(const Polynomial& p, const Polynomial& slope, double a, double b,
                 double tolerance) {
  const int sign_a = Sign(p(a));
  double x = 0.5 * (a + b);
  for (int i = 0; i < 100; ++i) {
    const double value = p(x);
    if (value == 0) return x;
    (Sign(value) == sign_a ? a : b) = x;
    double next = x - value / slope(x);
    if (!(next > std::min(a, b) && next < std::max(a, b))) next = 0.5 * (a + b);
    if (next == x || next == a || next == b) return next;
    if (std::abs(next - x) <= std::max(tolerance, 0x1.0p-53 * std::abs(x))) return next;
    x = next;
  }
  return x;
}

// Zeros of a parabola in (low, high), ascending, by the formula; a double one is none.
int ZerosOfParabola(const Polynomial& p, double low, double high, double* zeros) {
  const double discriminant = p.c[1] * p.c[1] - 4 * p.c[2] * p.c[0];
  if (!(discriminant > 0)) return 0;
  const double q = -0.5 * (p.c[1] + std::copysign(std::sqrt(discriminant), p.c[1]));
  double first = q / p.c[2], second = p.c[0] / q;
  if (first > second) std::swap(first, second);
  int found = 0;
  for (const double x : {first, second}) {
    if (x > low && x < high) zeros[found++] = x;
  }
  return found;
}

// Zeros in (low, high) where p changes its sign, ascending.
int Zeros(const Polynomial& p, double low, double high, double tolerance, double* zeros) {
  if (p.degree == 0) return 0;
  if (p.degree == 2) return ZerosOfParabola(p, low, high, zeros);
  const Polynomial slope = p.Derivative();
  // Between the zeros of the slope; these need not be exact.
  double edges[6];
  edges[0] = low;
  int count = 1;
  if (p.degree > 1) {
    count += Zeros(slope, low, high, std::max(tolerance, 1e-10 * (high - low)), edges + 1);
  }
  edges[count++] = high;
  int found = 0;
  int sign = Sign(p(edges[0]));
  for (int i = 1; i < count; ++i) {
    const int next = Sign(p(edges[i]));
    if (next != sign) zeros[found++] = Bracketed(p, slope, edges[i - 1], edges[i], tolerance);
    sign = next;
  }
  return found;
}

Polynomial AsPolynomial(const Quartic& q) {
  Polynomial p;
  std::copy(q.c, q.c + 5, p.c);
  p.degree = 4;
  while (p.degree > 0 && p.c[p.degree] == 0) --p.degree;
  return p;
}

}  // namespace

int SignChanges(const Quartic& q, double low, double high, double roots[4]) {
  return Zeros(AsPolynomial(q), low, high, 0, roots);
}

int SignChanges(const Quartic& q, double low, double high, int* sign, double roots[5]) {
  int count = 0;
  const int first = Sign(q(low));
  if (*sign != 0 && first != *sign) roots[count++] = low;
  const int inside = Zeros(AsPolynomial(q), low, high, 0, roots + count);
  *sign = inside % 2 == 0 ? first : -first;
  return count + inside;
}

}  // namespace rayshade
