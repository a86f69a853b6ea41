// The polygon; see polygon.h.
#include "rayshade/geom/polygon.h"

#include <algorithm>

#include "rayshade/geom/primitive.h"

namespace rayshade {
namespace {

class Polygon final : public Geom {
 public:
  explicit Polygon(const PolygonSpec& spec)
      : plane_(MakePolygonPlane(spec.points, spec.flip)), points_(spec.points) {}

  bool closed() const override { return false; }
  bool inclusive() const override { return true; }
  Bounds bounds() const override {
    Bounds box;
    for (const Vector& p : points_) box.Include(p);
    return box;
  }
  size_t bytes() const override { return sizeof *this + points_.capacity() * sizeof(Vector); }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    return IntersectPolygon(plane_, points_, ray.origin, ray.direction, min, max, distance);
  }

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, 3 * plane_.reach, path);
    SetNormal(plane_.normal, path);
  }

  UvPoint Uv(const HitPath& path) const override {
    return {path.point.x, path.point.y, {1, 0, 0}, {0, 1, 0}};
  }

 private:
  PolygonPlane plane_;
  std::vector<Vector> points_;
};

Vector NewellNormal(std::span<const Vector> points) {
  Vector n;
  const Vector* p = &points.back();
  for (const Vector& c : points) {
    n.x += (p->y - c.y) * (p->z + c.z);
    n.y += (p->z - c.z) * (p->x + c.x);
    n.z += (p->x - c.x) * (p->y + c.y);
    p = &c;
  }
  return n;
}

// Rayshade's own answer: the sum of quadrant steps around the hit.
bool QuadrantsWind(const PolygonPlane& p, std::span<const Vector> points, double h_u, double h_v) {
  const auto quadrant = [&](const Vector& q) {
    return q[p.u] >= h_u ? (q[p.v] >= h_v ? 0 : 3) : (q[p.v] >= h_v ? 1 : 2);
  };
  int winding = 0;
  const Vector* last = &points.back();
  int last_quadrant = quadrant(*last);
  for (const Vector& current : points) {
    const int now = quadrant(current);
    const int step = (now - last_quadrant + 4) % 4;
    if (step == 1) {
      ++winding;
    } else if (step == 3) {
      --winding;
    } else if (step == 2) {
      const double l_u = (*last)[p.u], l_v = (*last)[p.v];
      const double c_u = current[p.u], c_v = current[p.v];
      winding += (l_v - c_v) * (h_u - l_u) + l_v * (l_u - c_u) > (l_u - c_u) * h_v ? 2 : -2;
    }
    last = &current;
    last_quadrant = now;
  }
  return winding != 0;
}

// Winding of the points around the line of the ray, counted where edges cross the half-plane from
// the ray towards `aside`. Where an edge meets the ray, of the ray beside (edge_sign.h).
bool WindsAroundRay(std::span<const Vector> points, const Vector& origin, const Vector& direction,
                    const Vector& aside) {
  // The half-plane moves with the ray: all points that lie in it are then on one side.
  const Vector step = Cross(direction, aside);
  const bool in_it_is_above = step.x != 0 ? step.x > 0 : step.y != 0 ? step.y > 0 : step.z > 0;
  const auto is_above = [&](const Vector& p) {
    const int height = EdgeSign(origin, direction, origin + aside, p);
    return height != 0 ? height > 0 : in_it_is_above;
  };
  int winding = 0;
  const Vector* last = &points.back();
  bool was_above = is_above(*last);
  for (const Vector& current : points) {
    const bool above = is_above(current);
    if (above != was_above) {
      const int sign = EdgeSignBeside(origin, direction, *last, current);
      if (above && sign > 0) ++winding;
      if (!above && sign < 0) --winding;
    }
    last = &current;
    was_above = above;
  }
  return winding != 0;
}

}  // namespace

PolygonPlane MakePolygonPlane(std::span<const Vector> points, bool flip) {
  PolygonPlane p;
  const Vector raw = NewellNormal(points);
  p.normal = Normalized(raw);
  if (flip) p.normal = -p.normal;
  p.offset = Dot(p.normal, points[0]);

  // The largest component; x before y before z where they are equal.
  const double x = std::abs(p.normal.x), y = std::abs(p.normal.y), z = std::abs(p.normal.z);
  const int dominant = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  p.u = dominant == 0 ? 1 : 0;
  p.v = dominant == 2 ? 1 : 2;

  Bounds box;
  double off_plane = 0;
  for (const Vector& q : points) {
    box.Include(q);
    off_plane = std::max(off_plane, std::abs(Dot(p.normal, q - points[0])));
    for (int axis = 0; axis < 3; ++axis) p.reach = std::max(p.reach, std::abs(q[axis]));
  }
  const Vector extent = box.high - box.low;
  const double size = Dot(extent, extent);
  p.margin = kEdgeMargin * std::max(1.0, size / Length(raw));
  // Points that were written with few digits; what is farther off is not meant to be flat.
  if (off_plane <= kEpsilon * std::sqrt(size)) p.off_plane = 2 * off_plane;
  return p;
}

bool RayMeetsPolygon(const PolygonPlane& p, std::span<const Vector> points, const Vector& origin,
                     const Vector& direction, double distance) {
  const double h_u = origin[p.u] + distance * direction[p.u];
  const double h_v = origin[p.v] + distance * direction[p.v];
  if (QuadrantsWind(p, points, h_u, h_v)) return true;
  const int across = std::abs(direction[p.u]) <= std::abs(direction[p.v]) ? p.u : p.v;
  Vector aside;
  aside[across] = 1 + std::abs(origin[across]) + p.reach;
  return WindsAroundRay(points, origin, direction, aside);
}

std::optional<Complaint> Check(const PolygonSpec& spec) {
  if (spec.points.size() < 3) return Refuse("Degenerate polygon.");
  const double length = Length(NewellNormal(spec.points));
  if (!(length >= kEpsilon) || !std::isfinite(length)) return Refuse("Degenerate polygon.");
  return std::nullopt;
}

Bounds BoxOf(const PolygonSpec& spec) {
  Bounds box;
  for (const Vector& p : spec.points) box.Include(p);
  return box;
}

std::unique_ptr<const Geom> Make(const PolygonSpec& spec) {
  return std::make_unique<Polygon>(spec);
}

}  // namespace rayshade
