// The box; see box.h. The normal is that of the first face within kEpsilon, in the order +x -x +y
// -y +z -z, as in Rayshade; where none is so near (large or distant boxes), and for boxes so small
// that several are, it is that of the nearest face.
#include "rayshade/geom/box.h"

#include <algorithm>

#include "rayshade/geom/primitive.h"
#include "rayshade/geom/slab.h"

namespace rayshade {
namespace {

class Box final : public Geom {
 public:
  explicit Box(const Bounds& box) : box_(box) {}

  bool closed() const override { return true; }
  bool inclusive() const override { return false; }
  Bounds bounds() const override { return box_; }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    return IntersectSlabs(box_, ray.origin, ray.direction, min, max, distance);
  }

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, ReachOf(box_), path);
    SetNormal(NormalAt(path->point), path);
  }

  // Into the box unless the slab test takes the beginning for a place inside.
  bool Enters(const ObjectRay& ray, double min_distance, double) const override {
    return EntersSlabs(box_, ray.origin, ray.direction, min_distance);
  }

  bool AtEdge(const Vector& point, const Transform* to_world, double slack) const override {
    int near = 0;
    for (int axis = 0; axis < 3; ++axis) {
      Vector normal;
      normal[axis] = 1;
      const double reach = slack * (to_world == nullptr ? 1 : Length(to_world->Normal(normal)));
      near += std::abs(point[axis] - box_.low[axis]) <= reach;
      near += std::abs(point[axis] - box_.high[axis]) <= reach;
    }
    return near > 1;
  }

 private:
  Vector NormalAt(const Vector& p) const {
    const Vector extent = box_.high - box_.low;
    const bool small = std::min({extent.x, extent.y, extent.z}) < 100 * kEpsilon;
    int nearest = 0;
    double nearest_gap = INFINITY;
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const double gap = std::abs(p[axis] - (face % 2 == 0 ? box_.high : box_.low)[axis]);
      if (gap < kEpsilon && !small) {
        nearest = face;
        break;
      }
      if (gap < nearest_gap) {
        nearest = face;
        nearest_gap = gap;
      }
    }
    Vector normal;
    normal[nearest / 2] = nearest % 2 == 0 ? 1 : -1;
    return normal;
  }

  Bounds box_;
};

}  // namespace

std::optional<Complaint> Check(const BoxSpec& spec) {
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = std::abs(spec.corner[axis] - spec.opposite[axis]);
    if (!(extent >= kEpsilon) || !std::isfinite(extent)) return Refuse("Degenerate box.");
  }
  return std::nullopt;
}

Bounds BoxOf(const BoxSpec& spec) {
  Bounds box{spec.corner, spec.corner};
  box.Include(spec.opposite);
  return box;
}

std::unique_ptr<const Geom> Make(const BoxSpec& spec) { return std::make_unique<Box>(BoxOf(spec)); }

}  // namespace rayshade
