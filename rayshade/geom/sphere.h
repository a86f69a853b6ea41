// The sphere [rayshade4/2 s.6.1], solved in the perpendicular form: the discriminant comes from
// the foot of the perpendicular from the centre to the ray, not from the difference of two large
// squares, so that distance to the sphere costs no digits [HG19].
#pragma once

#include <cmath>
#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

// The nearest root in (min, max); where the near root is in front of min but not before max, the
// far one is not tried. Every kernel for spheres evaluates exactly this.
inline bool IntersectSphere(const Vector& center, double radius, const Vector& origin,
                            const Vector& direction, double min, double max, double* distance) {
  const Vector c = center - origin;
  const double b = Dot(c, direction);
  const Vector p = c - b * direction;
  const double discriminant = radius * radius - Dot(p, p);
  if (!(discriminant >= 0)) return false;
  const double root = std::sqrt(discriminant);
  double s = b - root;
  if (!(s > min)) {
    s = b + root;
    if (!(s > min)) return false;
  }
  if (!(s < max)) return false;
  *distance = s;
  return true;
}

std::optional<Complaint> Check(const SphereSpec& spec);
Bounds BoxOf(const SphereSpec& spec);
std::unique_ptr<const Geom> Make(const SphereSpec& spec);

}  // namespace rayshade
