// Quadrilaterals around flat objects; see quads.h.
#include "rayshade/accel/quads.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayshade {

namespace {

// The corner that a convex polygon in the plane has at point i: positive where it turns around the
// normal.
double Turn(std::span<const Vector> p, size_t i, const Vector& normal) {
  const Vector& a = p[i];
  const Vector& b = p[(i + 1) % p.size()];
  const Vector& c = p[(i + 2) % p.size()];
  return Dot(Cross(b - a, c - b), normal);
}

// All corners turn the same way: the polygon is its own quadrilateral.
bool IsConvexQuad(std::span<const Vector> p, const Vector& normal) {
  if (p.size() != 4) return false;
  int turns = 0;
  for (size_t i = 0; i < 4; ++i) {
    const double turn = Turn(p, i, normal);
    turns += turn > 0 ? 1 : turn < 0 ? -1 : 0;
  }
  return turns == 4 || turns == -4;
}

// A rectangle in the plane around the points, along the longest of their edges.
void RectangleAround(std::span<const Vector> points, const Vector& normal, Vector corner[4]) {
  Vector along;
  double longest = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vector edge = points[(i + 1) % points.size()] - points[i];
    const Vector flat = edge - Dot(edge, normal) * normal;
    if (Dot(flat, flat) <= longest) continue;
    longest = Dot(flat, flat);
    along = flat;
  }
  along = (1 / std::sqrt(longest)) * along;
  const Vector across = Cross(normal, along);
  double low[2] = {0, 0}, high[2] = {0, 0};
  for (const Vector& p : points) {
    const double at[2] = {Dot(p - points[0], along), Dot(p - points[0], across)};
    for (int i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], at[i]);
      high[i] = std::max(high[i], at[i]);
    }
  }
  const auto place = [&](double a, double b) { return points[0] + a * along + b * across; };
  corner[0] = place(low[0], low[1]);
  corner[1] = place(high[0], low[1]);
  corner[2] = place(high[0], high[1]);
  corner[3] = place(low[0], high[1]);
}

}  // namespace

bool QuadIsObject(std::span<const Vector> points, const Vector& normal) {
  return points.size() == 3 || IsConvexQuad(points, normal);
}

Quad QuadAround(std::span<const Vector> points, const Vector& normal, double offset,
                const double center[3], double room) {
  Vector corner[4];
  const bool triangle = points.size() == 3;
  const bool own = QuadIsObject(points, normal);
  if (own) {
    std::copy(points.begin(), points.end(), corner);
    if (triangle) corner[3] = 0.5 * (corner[2] + corner[0]);
  } else {
    RectangleAround(points, normal, corner);
  }
  // Around the normal.
  const Vector area = Cross(corner[2] - corner[0], corner[3] - corner[1]);
  if (Dot(area, normal) < 0) std::swap(corner[0], corner[2]);

  Quad quad;
  double off_plane = 0, reach = 0;
  for (const Vector& p : points) {
    off_plane = std::max(off_plane, std::abs(Dot(normal, p) - offset));
    for (int axis = 0; axis < 3; ++axis) reach = std::max(reach, std::abs(p[axis]));
  }
  for (int i = 0; i < 4; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      quad.row[3 * i + axis] = static_cast<float>(corner[i][axis] - center[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis) quad.row[12 + axis] = static_cast<float>(normal[axis]);
  const Vector middle{center[0], center[1], center[2]};
  quad.row[15] = static_cast<float>(offset - Dot(normal, middle));
  quad.row[16] = static_cast<float>(2 * off_plane + 1e-14 * reach);
  double diameter = 0;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < i; ++k) diameter = std::max(diameter, Length(corner[i] - corner[k]));
  }
  quad.row[17] = static_cast<float>(1.00001 * diameter);
  const float endless = std::numeric_limits<float>::infinity();
  // Hits lie no farther outside of the convex hull of the points than these are off the plane,
  // along the normal's dominant axis.
  quad.row[18] = own && quad.row[16] <= room ? 0 : endless;
  // A rectangle could not be made, or single precision ends here.
  const bool sound = std::all_of(quad.row, quad.row + 18,
                                 [](float x) { return std::isfinite(x) && std::abs(x) < 1e15f; });
  if (!sound) {
    std::fill(quad.row, quad.row + kQuadRows, 0.0f);
    quad.row[16] = quad.row[18] = endless;
  }
  return quad;
}

Quad BoxAsQuad(const float low[3], const float high[3]) {
  Quad quad{};
  std::copy(low, low + 3, quad.row);
  std::copy(high, high + 3, quad.row + 3);
  return quad;
}

void WriteQuads(std::span<const Quad> quads, float* rows) {
  for (int row = 0; row < kQuadRows; ++row) {
    for (const Quad& quad : quads) *rows++ = quad.row[row];
  }
}

}  // namespace rayshade
