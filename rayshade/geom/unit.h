// Unit vectors of vectors of any length, and the axes of a plane [rayshade4/2 s.1]. Rayshade leaves
// vectors shorter than kEpsilon as they are, which makes small normals dark; these do not.
#pragma once

#include <algorithm>
#include <cmath>

#include "rayshade/common/vector.h"

namespace rayshade {

// Makes *a a unit vector and returns its former length; 0, and *a unchanged, only for the zero
// vector and for vectors that are not finite. The same bits as Normalize from kEpsilon upwards.
inline double NormalizeAny(Vector* a) {
  const double length = Length(*a);
  if (length >= kEpsilon && length < 1e150) {
    *a = {a->x / length, a->y / length, a->z / length};
    return length;
  }
  const double largest = std::max({std::abs(a->x), std::abs(a->y), std::abs(a->z)});
  if (!(largest > 0) || !std::isfinite(largest)) return 0;
  Vector b{a->x / largest, a->y / largest, a->z / largest};
  const double rest = Length(b);
  *a = {b.x / rest, b.y / rest, b.z / rest};
  return rest * largest;
}

inline Vector UnitOf(Vector a) {
  NormalizeAny(&a);
  return a;
}

// Two unit vectors across n that span a plane's coordinates [rayshade4/2 s.1, "axis pair"].
struct AxisPair {
  Vector u, v;
};
inline AxisPair AxesAcross(const Vector& n) {
  AxisPair axes{{-n.y, n.x, 0}, {}};
  if (Normalize(&axes.u) == 0) {
    axes.u = {n.z, 0, -n.x};
    Normalize(&axes.u);
  }
  axes.v = Normalized(Cross(n, axes.u));
  return axes;
}

}  // namespace rayshade
