// What the descriptions of all primitives have in common.
#pragma once

#include <algorithm>

#include "rayshade/geom/geom.h"

namespace rayshade {

// The size of what an object's numbers are made of, for HitPath::reach.
inline double ReachOf(const Bounds& box) {
  return std::max(SumOfSizes(box.low), SumOfSizes(box.high));
}

// Everything of *path but the normals.
inline void BeginPath(const Geom* primitive, const ObjectRay& ray, double distance, double reach,
                      HitPath* path) {
  path->primitive = primitive;
  path->ray = ray;
  path->distance = distance;
  path->point = ray.origin + distance * ray.direction;
  path->smooth = false;
  path->reach = reach;
  path->stamp = Stamp::kNone;
  path->inner.clear();
}

inline void SetNormal(const Vector& normal, HitPath* path) {
  path->normal = normal;
  path->geometric_normal = normal;
}

}  // namespace rayshade
