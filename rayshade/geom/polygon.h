// The polygon, concave or crossing itself, by the non-zero winding rule [rayshade4/2 s.6.8].
//
//   1. Distance and winding are computed as in Rayshade, in the projection along the dominant
//      axis; upper edges belong to the polygon, lower ones do not.
//   2. Where the hit comes within rounding error of the height of a vertex or of an edge, the
//      winding around the ray itself is computed as well, with EdgeSign, and either answer will
//      do: polygons that share an edge leave no gap there.
#pragma once

#include <cmath>
#include <memory>
#include <span>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/edge_sign.h"
#include "rayshade/geom/geom.h"
#include "rayshade/geom/plane.h"

namespace rayshade {

// What a ray needs to know of a polygon, beside its points.
struct PolygonPlane {
  Vector normal;         // unit; negated by option -f
  double offset = 0;     // normal . p at the first point
  int u = 0, v = 1;      // the coordinates kept: (y, z), (x, z) or (x, y)
  double margin = 0;     // relative error of the hit
  double off_plane = 0;  // how far points lie from the plane, where that is rounding only
  double reach = 0;      // largest coordinate in size
};

// REQUIRES: not degenerate.
PolygonPlane MakePolygonPlane(std::span<const Vector> points, bool flip);

// The point of the plane may lie this far from where the ray truly meets it, per coordinate.
inline double HitMargin(const PolygonPlane& p, const Vector& origin, double distance,
                        double cosine) {
  const double far = std::abs(origin.x) + std::abs(origin.y) + std::abs(origin.z);
  return (p.margin * (far + std::abs(distance) + p.reach) + p.off_plane) / std::abs(cosine);
}

enum class Side : uint8_t { kOut, kIn, kNear };

// The fast answer for the hit (h_u, h_v): non-zero winding, or kNear where rounding may decide.
inline Side PolygonSide(const PolygonPlane& p, std::span<const Vector> points, double h_u,
                        double h_v, double margin) {
  int winding = 0;
  const Vector* last = &points.back();
  bool near = false;
  for (const Vector& current : points) {
    const double l_u = (*last)[p.u] - h_u, l_v = (*last)[p.v] - h_v;
    const double c_u = current[p.u] - h_u, c_v = current[p.v] - h_v;
    near |= std::abs(c_v) <= margin;
    if ((l_v >= 0) != (c_v >= 0)) {
      const double cross = l_u * c_v - l_v * c_u;
      near |= std::abs(cross) <= 4 * margin * (std::abs(l_u - c_u) + std::abs(l_v - c_v));
      if (c_v >= 0) {
        winding += cross > 0;
      } else {
        winding -= cross < 0;
      }
    }
    last = &current;
  }
  return near ? Side::kNear : winding != 0 ? Side::kIn : Side::kOut;
}

// The slow answer, for hits near the border or level with a vertex.
bool RayMeetsPolygon(const PolygonPlane& p, std::span<const Vector> points, const Vector& origin,
                     const Vector& direction, double distance);

// Inclusive at both ends of the window.
inline bool IntersectPolygon(const PolygonPlane& p, std::span<const Vector> points,
                             const Vector& origin, const Vector& direction, double min, double max,
                             double* distance) {
  double s, cosine;
  if (!PlaneDistance(p.normal, p.offset, origin, direction, &s, &cosine)) return false;
  if (!(s >= min && s <= max)) return false;
  const double h_u = origin[p.u] + s * direction[p.u], h_v = origin[p.v] + s * direction[p.v];
  const Side side = PolygonSide(p, points, h_u, h_v, HitMargin(p, origin, s, cosine));
  if (side == Side::kOut) return false;
  if (side == Side::kNear && !RayMeetsPolygon(p, points, origin, direction, s)) return false;
  *distance = s;
  return true;
}

std::optional<Complaint> Check(const PolygonSpec& spec);
Bounds BoxOf(const PolygonSpec& spec);
std::unique_ptr<const Geom> Make(const PolygonSpec& spec);

}  // namespace rayshade
