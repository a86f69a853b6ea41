// Zeros of a quartic; see polynomial.h.
#include "tests/stability/polynomial.h"

#include <algorithm>

namespace rayshade::stability {
namespace {

// One real zero of y^3 + a y^2 + b y + c: the largest, by Cardano.
double CubicZero(double a, double b, double c) {
  const double p = b / 3 - a * a / 9, q = a * a * a / 27 - a * b / 6 + c / 2;
  const double d = q * q + p * p * p;
  if (d >= 0) {
    const double root = std::sqrt(d);
    return std::cbrt(root - q) - std::cbrt(root + q) - a / 3;
  }
  return 2 * std::sqrt(-p) * std::cos(std::acos(-q / std::sqrt(-p * p * p)) / 3) - a / 3;
}

void AddQuadraticZeros(double b, double c, double shift, std::vector<double>* zeros) {
  const double d = b * b / 4 - c;
  if (!(d > 0)) return;
  zeros->push_back(-b / 2 - std::sqrt(d) - shift);
  zeros->push_back(-b / 2 + std::sqrt(d) - shift);
}

Quad Value(const std::vector<Quad>& c, Quad t) {
  Quad value = 0;
  for (size_t i = c.size(); i-- > 0;) value = value * t + c[i];
  return value;
}

// The zero between a and b, where the signs of the values differ.
Quad Bracketed(const std::vector<Quad>& c, const std::vector<Quad>& slope, Quad a, Quad b) {
  const bool a_negative = Value(c, a) < 0;
  Quad t = (a + b) / 2;
  for (int i = 0; i < 300; ++i) {
    const Quad value = Value(c, t);
    if (value == 0) return t;
    ((value < 0) == a_negative ? a : b) = t;
    Quad next = t - value / Value(slope, t);
    if (!(next > a && next < b)) next = (a + b) / 2;
    if (next == t || next == a || next == b) return next;
    t = next;
  }
  return t;
}

std::vector<Quad> Zeros(const std::vector<Quad>& c, Quad low, Quad high) {
  if (c.size() < 2) return {};
  std::vector<Quad> slope;
  for (size_t i = 1; i < c.size(); ++i) slope.push_back(Quad(static_cast<int>(i)) * c[i]);
  std::vector<Quad> edges = Zeros(slope, low, high), zeros;
  edges.push_back(high);
  Quad from = low;
  for (const Quad to : edges) {
    if ((Value(c, from) < 0) != (Value(c, to) < 0)) zeros.push_back(Bracketed(c, slope, from, to));
    from = to;
  }
  return zeros;
}

}  // namespace

std::vector<double> QuarticZeros(const double c[5]) {
  const double a = c[3] / c[4], b = c[2] / c[4], d = c[1] / c[4], e = c[0] / c[4];
  // t = y - a / 4: y^4 + p y^2 + q y + r.
  const double p = b - 3 * a * a / 8;
  const double q = d - a * b / 2 + a * a * a / 8;
  const double r = e - a * d / 4 + a * a * b / 16 - 3 * a * a * a * a / 256;
  // A zero z of the resolvent makes it (y^2 + z)^2 - (v y - u)^2, v^2 = 2 z - p, u^2 = z^2 - r.
  const double z = CubicZero(-p / 2, -r, r * p / 2 - q * q / 8);
  const double v = std::sqrt(std::max(0.0, 2 * z - p));
  const double u = std::copysign(std::sqrt(std::max(0.0, z * z - r)), q);
  std::vector<double> zeros;
  AddQuadraticZeros(v, z - u, a / 4, &zeros);
  AddQuadraticZeros(-v, z + u, a / 4, &zeros);
  std::sort(zeros.begin(), zeros.end());
  return zeros;
}

std::vector<Quad> QuarticZeros(const Quad c[5], Quad low, Quad high) {
  return Zeros({c, c + 5}, low, high);
}

}  // namespace rayshade::stability
