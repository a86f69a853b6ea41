// Rays against single objects; see other_objects.h.
#include "rayshade/accel/other_objects.h"

#include <cmath>
#include <limits>

#include "rayshade/geom/make_geom.h"
#include "rayshade/geom/sphere.h"

namespace rayshade {

namespace {

// A distance that may be equalled, taken into object space and back, stays below this.
constexpr double kLoose = 1 + 1e-12;

ObjectRay WorldRay(const Scene& scene, const Ray& ray) {
  return {ray.origin, ray.direction, {scene.shutter.frame, ray.time}};
}

bool HasUnitDirection(const Ray& ray) {
  return std::abs(Dot(ray.direction, ray.direction) - 1) < kUnitTolerance;
}

}  // namespace

bool OtherObjects::bounded(uint32_t object) const {
  const Item& item = objects_->item(object);
  return item.kind != kOtherLeaf || objects_->other(item).bounded;
}

bool OtherObjects::MeetsBox(const Ray& ray, uint32_t object, double distance) const {
  const Bounds box = objects_->WorldBox(object);
  double near = ray.min_distance, far = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < box.low[axis] || o > box.high[axis]) return false;
      continue;
    }
    const double a = (box.low[axis] - o) / d, b = (box.high[axis] - o) / d;
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near <= far && distance >= near * (1 - 1e-7);
}

bool OtherObjects::BoxDecides(const Ray& ray, uint32_t object, double distance) const {
  if (objects_->is_sphere(object)) return distance > kSureDistance || !HasUnitDirection(ray);
  const Item& item = objects_->item(object);
  if (item.kind == kOtherLeaf) return objects_->other(item).bounded;
  if (item.kind == kPolygonLeaf && !objects_->polygon(item).planar) return true;
  return distance > kSureDistance || !HasUnitDirection(ray);
}

bool OtherObjects::Intersect(const Ray& ray, uint32_t object, double limit, double most,
                             double* distance) const {
  if (objects_->is_sphere(object)) {
    const SphereSpec s = objects_->sphere(object);
    return IntersectSphere(s.center, s.radius, ray.origin, ray.direction, ray.min_distance, most,
                           distance);
  }
  const Item& item = objects_->item(object);
  if (item.kind == kTriangleLeaf) {
    const TriangleShape& shape = objects_->triangle(item).shape;
    return IntersectTriangle(shape, ray.origin, ray.direction, ray.min_distance, most, distance);
  }
  if (item.kind == kPolygonLeaf) {
    const FlatPolygon& polygon = objects_->polygon(item);
    return IntersectPolygon(polygon.plane, objects_->PointsOf(polygon), ray.origin, ray.direction,
                            ray.min_distance, most, distance);
  }
  return IntersectOther(ray, object, limit, most, distance);
}

bool OtherObjects::IntersectOther(const Ray& ray, uint32_t object, double limit, double most,
                                  double* distance) const {
  const OtherObject& other = objects_->other(objects_->item(object));
  const Placement& placement = objects_->scene().placement(objects_->key(object).placement);
  // The window is the limit's where that is nearer, so that the kind's own rule decides there; else
  // a little longer than the best distance, which may be equalled.
  const double window = std::min(most * kLoose, limit);
  ObjectRay local = WorldRay(objects_->scene(), ray);
  double scale = 1;
  if (!placement.in_place &&
      !ToObject(placement, local, ray.min_distance, std::min(limit, kFar), &local, &scale)) {
    return false;
  }
  if (!other.geom->Intersect(local, ray.min_distance * scale, window * scale, distance)) {
    return false;
  }
  *distance /= scale;
  return true;
}

void OtherObjects::Nearest(const Ray& ray, uint32_t object, double limit, Hit* hit) const {
  double distance;
  if (!Intersect(ray, object, limit, hit->distance, &distance)) return;
  const Rank rank = objects_->key(object).rank;
  if (!(distance < hit->distance || (distance == hit->distance && rank < hit->rank))) return;
  if (BoxDecides(ray, object, distance) && !MeetsBox(ray, object, distance)) return;
  hit->distance = distance;
  hit->rank = rank;
  hit->object = object;
}

Meeting OtherObjects::Meets(const Ray& ray, uint32_t object, double limit) const {
  double distance;
  if (!Intersect(ray, object, limit, limit, &distance) || distance > limit) {
    return Meeting::kNothing;
  }
  if (BoxDecides(ray, object, distance) && !MeetsBox(ray, object, distance)) {
    return Meeting::kNothing;
  }
  const bool opaque = all_opaque_ || IsOpaque(ray, object, distance);
  return opaque ? Meeting::kOpaque : Meeting::kTransparent;
}

bool OtherObjects::IsOpaque(const Ray& ray, uint32_t object, double distance) const {
  const Item& item = objects_->item(object);
  const PlacementId placement = objects_->key(object).placement;
  if (item.kind == kOtherLeaf && item.geom == kCompositeGeom) {
    // The surface may be a member's own.
    HitPath path;
    Describe(ray, object, distance, &path);
    for (const Attributes* attributes : path.inner) {
      if (attributes->surface == kNoSurface) continue;
      return !(objects_->scene().bound_surface(attributes->surface).transp >= kEpsilon);
    }
  }
  return (*opaque_)[placement] != 0;
}

void OtherObjects::Describe(const Ray& ray, uint32_t object, double distance, HitPath* path) const {
  const Scene& scene = objects_->scene();
  const Placement& placement = scene.placement(objects_->key(object).placement);
  ObjectRay local = WorldRay(scene, ray);
  path->keep = nullptr;
  if (!objects_->is_sphere(object) && objects_->item(object).kind == kOtherLeaf) {
    double scale = 1;
    if (!placement.in_place) {
      const ObjectRay world = local;
      ToObject(placement, world, ray.min_distance, kFar, &local, &scale);
    }
    // The distance as the object has it: on the way to world space and back it loses its last bits.
    const Geom& geom = *objects_->other(objects_->item(object)).geom;
    double own = distance * scale, exact;
    if (scale != 1 && geom.Intersect(local, ray.min_distance * scale, kFar * scale, &exact) &&
        exact / scale == distance) {
      own = exact;
    }
    geom.Describe(local, ray.min_distance * scale, own, path);
    return;
  }
  if (!placement.plain) {
    // Textures may want to ask the primitive.
    path->keep = MakeGeom(objects_->SpecOf(object), scene.shutter);
    path->keep->Describe(local, ray.min_distance, distance, path);
    return;
  }
  path->primitive = nullptr;
  path->ray = local;
  path->distance = distance;
  path->point = ray.origin + distance * ray.direction;
  path->smooth = false;
  path->stamp = Stamp::kNone;
  path->inner.clear();
  if (objects_->is_sphere(object)) {
    const SphereSpec s = objects_->sphere(object);
    path->reach = SumOfSizes(s.center) + 3 * s.radius;
    const Vector n = path->point - s.center;
    path->normal = {n.x / s.radius, n.y / s.radius, n.z / s.radius};
  } else {
    const Item& item = objects_->item(object);
    const bool triangle = item.kind == kTriangleLeaf;
    path->normal =
        triangle ? objects_->triangle(item).shape.normal : objects_->polygon(item).plane.normal;
    path->reach =
        3 * (triangle ? objects_->triangle(item).shape.reach : objects_->polygon(item).plane.reach);
  }
  path->geometric_normal = path->normal;
}

TraceCallbacks OtherObjects::Callbacks() {
  return {[](const void* set, const Ray& ray, uint32_t object, double limit, Hit* hit) {
            static_cast<const OtherObjects*>(set)->Nearest(ray, object, limit, hit);
          },
          [](const void* set, const Ray& ray, uint32_t object, double limit) {
            return static_cast<const OtherObjects*>(set)->Meets(ray, object, limit);
          },
          [](const void* set, const Ray& ray, uint32_t object, double distance) {
            return static_cast<const OtherObjects*>(set)->MeetsBox(ray, object, distance);
          }};
}

}  // namespace rayshade
