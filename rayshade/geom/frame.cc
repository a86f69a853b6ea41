// Canonical frames; see frame.h.
#include "rayshade/geom/frame.h"

#include <cmath>

#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

// Right-handed rotation about a unit axis [rayshade4/2 s.3.2].
Matrix RotationMatrix(const Vector& n, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix r;
  r.m[0][0] = n.x * n.x + (1 - n.x * n.x) * c;
  r.m[0][1] = n.x * n.y * (1 - c) + n.z * s;
  r.m[0][2] = n.x * n.z * (1 - c) - n.y * s;
  r.m[1][0] = n.x * n.y * (1 - c) - n.z * s;
  r.m[1][1] = n.y * n.y + (1 - n.y * n.y) * c;
  r.m[1][2] = n.y * n.z * (1 - c) + n.x * s;
  r.m[2][0] = n.x * n.z * (1 - c) + n.y * s;
  r.m[2][1] = n.y * n.z * (1 - c) - n.x * s;
  r.m[2][2] = n.z * n.z + (1 - n.z * n.z) * c;
  return r;
}

}  // namespace

std::optional<Transform> CanonicalFrame(const Vector& base, const Vector& axis, double radius,
                                        double length) {
  Vector about{1, 0, 0};
  if (!(1.0 - std::abs(axis.z) < kEpsilon)) about = Normalized({axis.y, -axis.x, 0});
  Matrix scale;
  scale.m[0][0] = scale.m[1][1] = radius;
  scale.m[2][2] = length;
  return FromMatrix(scale * RotationMatrix(about, -std::acos(axis.z)), base);
}

double ReachOf(const Transform& frame) {
  double reach = SumOfSizes(frame.translation);
  for (const auto& row : frame.matrix.m) reach += SumOfSizes({row[0], row[1], row[2]});
  return reach;
}

CanonicalRay ToCanonical(const Transform& frame, const ObjectRay& ray) {
  CanonicalRay canonical{frame.InversePoint(ray.origin), frame.InverseDirection(ray.direction), 0};
  canonical.scale = NormalizeAny(&canonical.direction);
  return canonical;
}

double ShiftTowards(const CanonicalRay& ray, const Vector& center) {
  constexpr double kNear = 30;
  const Vector to_center = center - ray.origin;
  if (Dot(to_center, to_center) < kNear * kNear) return 0;
  return Dot(to_center, ray.direction);
}

}  // namespace rayshade
