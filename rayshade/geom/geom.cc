// What is common to all kinds of Geom; see geom.h.
#include "rayshade/geom/geom.h"

namespace rayshade {

bool Geom::Enters(const ObjectRay& ray, double min_distance, double distance) const {
  HitPath path;
  Describe(ray, min_distance, distance, &path);
  return Dot(ray.direction, path.geometric_normal) < 0;
}

bool Geom::AtEdge(const Vector&, const Transform*, double) const { return false; }

UvPoint Geom::Uv(const HitPath&) const { return {}; }

}  // namespace rayshade
