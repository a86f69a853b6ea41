// What the descriptions of all primitives have in common.
#pragma once

#include "rayshade/geom/geom.h"

namespace rayshade {

// Everything of *path but the normals.
inline void BeginPath(const Geom* primitive, const ObjectRay& ray, double distance, HitPath* path) {
  path->primitive = primitive;
  path->ray = ray;
  path->distance = distance;
  path->point = ray.origin + distance * ray.direction;
  path->smooth = false;
  path->stamp = Stamp::kNone;
  path->inner.clear();
}

inline void SetNormal(const Vector& normal, HitPath* path) {
  path->normal = normal;
  path->geometric_normal = normal;
}

}  // namespace rayshade
