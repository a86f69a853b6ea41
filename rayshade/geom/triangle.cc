// The flat triangle; see triangle.h.
#include "rayshade/geom/triangle.h"

#include "rayshade/geom/primitive.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

class Triangle final : public Geom {
 public:
  explicit Triangle(const TriangleShape& shape) : shape_(shape) {}

  bool closed() const override { return false; }
  bool inclusive() const override { return true; }
  Bounds bounds() const override { return TriangleBox(shape_.point); }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    return IntersectTriangle(shape_, ray.origin, ray.direction, min, max, distance);
  }

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, 3 * shape_.reach, path);
    SetNormal(shape_.normal, path);
  }

  UvPoint Uv(const HitPath& path) const override { return FlatTriangleUv(shape_, path.point); }

 private:
  TriangleShape shape_;
};

Vector RawNormal(const Vector point[3]) { return Cross(point[1] - point[0], point[2] - point[1]); }

}  // namespace

TriangleShape MakeTriangleShape(const Vector point[3], bool flip) {
  TriangleShape t;
  std::copy(point, point + 3, t.point);
  const Vector raw = RawNormal(point);
  const double area = Length(raw);
  t.normal = Normalized(raw);
  if (flip) t.normal = -t.normal;
  t.offset = Dot(t.normal, point[0]);

  // Dominant axis: x before z, y before z, and y before x, where they are equal.
  const double x = std::abs(raw.x), y = std::abs(raw.y), z = std::abs(raw.z);
  const int dominant = x > y && x > z ? 0 : y > z ? 1 : 2;
  t.u = (dominant + 1) % 3;
  t.v = (dominant + 2) % 3;
  t.dominant_normal = raw[dominant];

  // Edges, and how far rounding can move an edge function.
  const double inverse = 1.0 / raw[dominant];
  double longest = 0, widest = 0;
  for (int i = 0; i < 3; ++i) {
    const Vector edge = point[(i + 1) % 3] - point[i];
    t.edge_u[i] = edge[t.u] * inverse;
    t.edge_v[i] = edge[t.v] * inverse;
    longest = std::max(longest, Dot(edge, edge));
    widest = std::max(widest, std::abs(t.edge_u[i]) + std::abs(t.edge_v[i]));
    for (int axis = 0; axis < 3; ++axis) {
      t.reach = std::max(t.reach, std::abs(point[i][axis]));
    }
  }
  t.margin = kEdgeMargin * widest * std::max(1.0, longest / area);
  return t;
}

bool RayMeetsTriangle(const TriangleShape& t, const Vector& origin, const Vector& direction) {
  const int a = EdgeSign(origin, direction, t.point[0], t.point[1]);
  const int b = EdgeSign(origin, direction, t.point[1], t.point[2]);
  const int c = EdgeSign(origin, direction, t.point[2], t.point[0]);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

std::optional<Complaint> CheckTriangle(const Vector point[3]) {
  const double length = Length(RawNormal(point));
  if (!(length >= kEpsilon) || !std::isfinite(length)) {
    return Refuse("Degenerate triangle.", Severity::kAdvise);
  }
  return std::nullopt;
}

Bounds TriangleBox(const Vector point[3]) {
  Bounds box{point[0], point[0]};
  box.Include(point[1]);
  box.Include(point[2]);
  return box;
}

UvPoint FlatTriangleUv(const TriangleShape& t, const Vector& point) {
  double weight[3];
  TriangleWeights(t, point, weight);
  const double sum = weight[0] + weight[1] + weight[2];
  for (double& w : weight) w /= sum;
  UvPoint uv;
  uv.v = weight[2];
  uv.u = std::abs(uv.v - 1) < kEpsilon ? 0 : weight[1] / (weight[0] + weight[1]);
  // Along the first edge, the other way round where the dominant component is negative.
  const Vector edge = t.point[1] - t.point[0];
  uv.du = UnitOf(t.dominant_normal < 0 ? -edge : edge);
  uv.dv = UnitOf(t.point[0] - point);
  return uv;
}

std::optional<Complaint> Check(const TriangleSpec& spec) { return CheckTriangle(spec.point); }
Bounds BoxOf(const TriangleSpec& spec) { return TriangleBox(spec.point); }
std::unique_ptr<const Geom> Make(const TriangleSpec& spec) {
  return std::make_unique<Triangle>(MakeTriangleShape(spec.point, spec.flip));
}

}  // namespace rayshade
