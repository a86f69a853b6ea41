// The flat triangle [rayshade4/2 s.6.5], and the test that all three kinds of triangles share.
//
//   1. Distance and side of edges are computed as in Rayshade, in the projection along the
//      dominant axis. Only where an edge function comes out within its rounding error of zero is
//      it decided by EdgeSign, for all three edges: triangles that share an edge or a vertex leave
//      no gap.
//   2. Edges belong to the triangle (the inclusive rule).
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/edge_sign.h"
#include "rayshade/geom/geom.h"
#include "rayshade/geom/plane.h"

namespace rayshade {

// What a ray needs to know of a triangle. Edge i leads from point i to point i + 1.
struct TriangleShape {
  Vector point[3];
  Vector normal;           // unit; negated by option -f
  double offset = 0;       // normal . p on the plane
  int u = 0, v = 1;        // the coordinates kept: the two after the dominant axis, cyclically
  double edge_u[3] = {};   // edges in these coordinates, divided by the dominant component of
  double edge_v[3] = {};   // the normal before normalisation
  double margin = 0;       // see EdgeFunctionMargin
  double reach = 0;        // largest coordinate in size
  double dominant_normal;  // the component divided by
};

// REQUIRES: not degenerate.
TriangleShape MakeTriangleShape(const Vector point[3], bool flip);

// Edge functions, and at the same time weights of the three vertices; weight[i] belongs to
// point[i]. hit: on the plane.
inline void TriangleWeights(const TriangleShape& t, const Vector& hit, double weight[3]) {
  const auto weigh = [&](int edge, int from) {
    const double h_u = hit[t.u] - t.point[from][t.u], h_v = hit[t.v] - t.point[from][t.v];
    return t.edge_u[edge] * h_v - t.edge_v[edge] * h_u;
  };
  weight[0] = weigh(1, 1);
  weight[1] = weigh(2, 2);
  weight[2] = weigh(0, 0);
}

// Weights nearer to zero than this may have the wrong sign.
inline double WeightMargin(const TriangleShape& t, const Vector& origin, double distance,
                           double cosine) {
  const double far = std::abs(origin.x) + std::abs(origin.y) + std::abs(origin.z);
  return t.margin * (far + std::abs(distance) + t.reach) / std::abs(cosine);
}

// The slow answer, for rays near an edge: does the line of the ray pass through the closed
// triangle?
bool RayMeetsTriangle(const TriangleShape& t, const Vector& origin, const Vector& direction);

// Inclusive at both ends of the window.
inline bool IntersectTriangle(const TriangleShape& t, const Vector& origin, const Vector& direction,
                              double min, double max, double* distance) {
  double s, cosine;
  if (!PlaneDistance(t.normal, t.offset, origin, direction, &s, &cosine)) return false;
  if (!(s >= min && s <= max)) return false;
  double weight[3];
  TriangleWeights(t, origin + s * direction, weight);
  const double least = std::min({weight[0], weight[1], weight[2]});
  const double margin = WeightMargin(t, origin, s, cosine);
  if (least < -margin) return false;
  if (!(least > margin) && !RayMeetsTriangle(t, origin, direction)) return false;
  *distance = s;
  return true;
}

std::optional<Complaint> Check(const TriangleSpec& spec);
Bounds BoxOf(const TriangleSpec& spec);
std::unique_ptr<const Geom> Make(const TriangleSpec& spec);

// For the other kinds of triangles.
std::optional<Complaint> CheckTriangle(const Vector point[3]);
Bounds TriangleBox(const Vector point[3]);
UvPoint FlatTriangleUv(const TriangleShape& t, const Vector& point);

}  // namespace rayshade
