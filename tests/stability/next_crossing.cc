// Bounds by derivatives; see next_crossing.h.
#include "tests/stability/next_crossing.h"

#include <algorithm>
#include <cmath>

namespace rayshade::stability {
namespace {

constexpr double kNever = INFINITY;

// f' and a bound of f'' along the ray, f > 0 outside.
double FromSlope(double slope, double bend) { return 2 * std::abs(slope) / bend; }

// Of a convex body: rays that go outwards never come back.
double OfConvex(double slope, double bend) {
  return slope >= 0 || bend == 0 ? kNever : FromSlope(slope, bend);
}

double Next(const SphereSpec& s, const Vector& p, const Vector& d) {
  return OfConvex(2 * Dot(p - s.center, d), 2 * Dot(d, d));
}

double Next(const CylinderSpec& s, const Vector& p, const Vector& d) {
  const Vector axis = Normalized(s.top - s.base), from = p - s.base;
  const Vector o = from - Dot(from, axis) * axis, across = d - Dot(d, axis) * axis;
  return OfConvex(2 * Dot(o, across), 2 * Dot(across, across));
}

double Next(const ConeSpec& s, const Vector& p, const Vector& d) {
  const double length = Length(s.top - s.base);
  const Vector axis = Normalized(s.top - s.base), from = p - s.base;
  const Vector o = from - Dot(from, axis) * axis, across = d - Dot(d, axis) * axis;
  const double growth = (s.top_radius - s.base_radius) / length;
  const double radius = s.base_radius + growth * Dot(from, axis), wider = growth * Dot(d, axis);
  const double bend = 2 * (Dot(across, across) - wider * wider);
  return OfConvex(2 * (Dot(o, across) - radius * wider), std::max(bend, 0.0));
}

// The function is (rho - R)^2 + z^2, rho being the distance from the axis.
double Next(const TorusSpec& s, const Vector& p, const Vector& d) {
  const Vector n = Normalized(s.normal), from = p - s.center;
  const Vector across = from - Dot(from, n) * n;
  const double rho = Length(across), inner = s.swept_radius - s.tube_radius;
  const Vector ring = (s.swept_radius / rho) * across;
  const double slope = 2 * Dot(from - ring, d), bend = 2 * s.swept_radius / inner;
  // Before it comes near to the axis, the ray has gone half of the hole.
  return std::min(FromSlope(slope, 2 * bend), inner / 2);
}

double Next(const BlobSpec& s, const Vector& p, const Vector& d) {
  double slope = 0, bend = 0;
  for (const BlobSpec::Ball& ball : s.balls) {
    const Vector from = p - ball.center;
    const double r2 = ball.radius * ball.radius, inside = 1 - Dot(from, from) / r2;
    // strength (1 - q)^2 with q'' = 2 / r2 and |q'| <= 2 / radius: the second derivative is at most
    // 2 q'^2 + 2 q'' = 12 / r2.
    bend += 12 * ball.strength / r2;
    if (inside > 0) slope += -4 * ball.strength * inside / r2 * Dot(from, d);
  }
  return FromSlope(slope, bend);
}

// All others are flat.
template <class Flat>
double Next(const Flat&, const Vector&, const Vector&) {
  return kNever;
}

}  // namespace

double NextCrossing(const GeomSpec& spec, const Vector& p, const Vector& d) {
  return std::visit([&](const auto& s) { return Next(s, p, d); }, spec);
}

}  // namespace rayshade::stability
