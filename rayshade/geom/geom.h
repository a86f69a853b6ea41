// What rays meet: a primitive, or an aggregate that is one object as a whole (CSG). A Geom works in
// the space in which it was written; its placement (scene/placement.h) brings rays there.
//
//   1. A Geom is immutable: nothing about a hit is kept in it [rayshade4/2 s.6.6 names what that
//   mends].
//   2. Intersect computes a distance in one way only: every other piece of code that tests the same
//   kind (the
//      accelerator's arrays) gives the same bits.
//   3. Describe(ray, distance) is a pure function: a hit can be described anywhere, from ray and
//   distance alone.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "rayshade/common/bounds.h"
#include "rayshade/common/expression.h"
#include "rayshade/common/transform.h"
#include "rayshade/common/vector.h"
#include "rayshade/geom/spec.h"

namespace rayshade {

// A ray in a Geom's space; direction has length 1 wherever the world ray's has.
struct ObjectRay {
  Vector origin, direction;
  Moment moment;
};

class Geom;

// What happened to a hit inside CSG: the enclosing node may know better than the primitive whether
// the ray enters.
enum class Stamp : uint8_t { kNone, kEntering, kLeaving };

// A hit, in the space of the primitive hit.
struct HitPath {
  const Geom* primitive = nullptr;   // null for a flat object without textures (accel/)
  std::shared_ptr<const Geom> keep;  // owns primitive where it was made for this description only
  ObjectRay ray;
  double distance = 0;
  Vector point;             // ray.origin + distance * ray.direction
  Vector normal;            // for shading, unit where it can be, not yet turned towards the ray
  Vector geometric_normal;  // equal to normal but for Phong triangles
  bool smooth = false;      // true for triangles with vertex normals
  double reach = 0;  // the largest numbers that went into the hit: the object's coordinates, summed
  Stamp stamp = Stamp::kNone;
  // Inside a composite: the attributes from the primitive's own outwards, up to but not including
  // the composite's.
  std::vector<const Attributes*> inner;
};

struct UvPoint {
  double u = 0, v = 0;
  Vector du{1, 0, 0}, dv{0, 1, 0};  // tangents in primitive space
};

class Geom {
 public:
  virtual ~Geom() = default;

  virtual bool bounded() const { return true; }
  virtual bool closed() const = 0;  // may be a CSG operand without advice [rayshade4/2 s.5]
  // Hits at equal distances: an inclusive kind beats a strict one, the last tested inclusive one
  // and the first tested strict one win [rayshade4/2 s.5, 8.2].
  virtual bool inclusive() const = 0;
  // Tight box, without Rayshade's growth by kEpsilon; meaningless where !bounded(). Of animated
  // parts: over the whole shutter interval.
  virtual Bounds bounds() const = 0;

  // The nearest hit in the window, by the kind's own rule at both ends. min_distance and
  // max_distance in own space.
  virtual bool Intersect(const ObjectRay& ray, double min_distance, double max_distance,
                         double* distance) const = 0;

  // Fills *path for a hit that Intersect reported with this min_distance.
  virtual void Describe(const ObjectRay& ray, double min_distance, double distance,
                        HitPath* path) const = 0;

  // Does the hit lead into the solid? The kind's rule for CSG [rayshade4/2 s.5]. Default: direction
  // . outward normal < 0.
  virtual bool Enters(const ObjectRay& ray, double min_distance, double distance) const;

  // Does the point of a hit lie within `slack` (in the world) of a second face, so that a ray that
  // leaves it may begin behind that one? to_world: from this space; null where it is the world.
  virtual bool AtEdge(const Vector& point, const Transform* to_world, double slack) const;

  // Texture coordinates of a hit; path as filled by Describe, geometric_normal turned towards the
  // viewer [rayshade4/2 s.4.4, rayshade4/3 s.11.2].
  virtual UvPoint Uv(const HitPath& path) const;

  // Bytes that this object occupies, all included.
  virtual size_t bytes() const = 0;
};

}  // namespace rayshade
