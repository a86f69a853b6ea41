// Triangles with vertex normals; see phong_triangle.h. The weights of the vertices are computed
// from the hit point: nothing is left behind in the triangle [rayshade4/2 s.6.6 names the defect].
#include "rayshade/geom/phong_triangle.h"

#include "rayshade/geom/primitive.h"
#include "rayshade/geom/triangle.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

struct SmoothShape {
  TriangleShape flat;
  Vector normal[3];           // unit
  bool inconsistent = false;  // the vertex normals point to the plane's other side
};

SmoothShape MakeSmoothShape(const Vector point[3], const Vector normal[3], bool flip) {
  SmoothShape shape{MakeTriangleShape(point, flip), {}, false};
  for (int i = 0; i < 3; ++i) {
    shape.normal[i] = Normalized(normal[i]);
    if (flip) shape.normal[i] = -shape.normal[i];
  }
  shape.inconsistent = !flip && Dot(shape.normal[0], shape.flat.normal) < 0;
  return shape;
}

class PhongTriangle : public Geom {
 public:
  explicit PhongTriangle(const SmoothShape& shape) : shape_(shape) {}

  bool closed() const override { return false; }
  bool inclusive() const override { return true; }
  Bounds bounds() const override { return TriangleBox(shape_.flat.point); }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    return IntersectTriangle(shape_.flat, ray.origin, ray.direction, min, max, distance);
  }

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, 3 * shape_.flat.reach, path);
    double weight[3];
    TriangleWeights(shape_.flat, path->point, weight);
    const Vector* n = shape_.normal;
    path->normal = UnitOf(weight[0] * n[0] + weight[1] * n[1] + weight[2] * n[2]);
    path->geometric_normal = shape_.inconsistent ? -shape_.flat.normal : shape_.flat.normal;
    path->smooth = true;
  }

  UvPoint Uv(const HitPath& path) const override { return FlatTriangleUv(shape_.flat, path.point); }

 protected:
  SmoothShape shape_;
};

class UvTriangle final : public PhongTriangle {
 public:
  UvTriangle(const SmoothShape& shape, const TriangleUvSpec& spec)
      : PhongTriangle(shape), du_(Tangent(spec, 1)), dv_(Tangent(spec, 0)) {
    for (int i = 0; i < 3; ++i) {
      uv_[i][0] = spec.uv[i][0];
      uv_[i][1] = spec.uv[i][1];
    }
  }

  size_t bytes() const override { return sizeof *this; }

  UvPoint Uv(const HitPath& path) const override {
    double weight[3];
    TriangleWeights(shape_.flat, path.point, weight);
    const double sum = weight[0] + weight[1] + weight[2];
    UvPoint uv{0, 0, du_, dv_};
    for (int i = 0; i < 3; ++i) {
      uv.u += weight[i] / sum * uv_[i][0];
      uv.v += weight[i] / sum * uv_[i][1];
    }
    return uv;
  }

 private:
  // The direction in which the coordinate other than `fixed` grows while `fixed` (0: u, 1: v) stays
  // the same: from the middle vertex to the opposite edge, or back.
  static Vector Tangent(const TriangleUvSpec& spec, int fixed) {
    const int moving = 1 - fixed;
    int order[3] = {0, 1, 2};
    std::stable_sort(order, order + 3,
                     [&](int a, int b) { return spec.uv[a][fixed] > spec.uv[b][fixed]; });
    const int high = order[0], middle = order[1], low = order[2];
    const double range = spec.uv[high][fixed] - spec.uv[low][fixed];
    if (range < kEpsilon) return {0, 0, 0};
    const double f = (spec.uv[middle][fixed] - spec.uv[low][fixed]) / range;
    const Vector base = (1 - f) * spec.point[low] + f * spec.point[high];
    const double at_base = (1 - f) * spec.uv[low][moving] + f * spec.uv[high][moving];
    const Vector& apex = spec.point[middle];
    return UnitOf(spec.uv[middle][moving] < at_base ? base - apex : apex - base);
  }

  double uv_[3][2];
  Vector du_, dv_;
};

std::optional<Complaint> CheckSmooth(const Vector point[3], const Vector normal[3], bool flip) {
  if (auto complaint = CheckTriangle(point)) return complaint;
  for (int i = 0; i < 3; ++i) {
    const double length = Length(normal[i]);
    if (!(length >= kEpsilon) || !std::isfinite(length)) {
      return Refuse("Degenerate vertex normal.");
    }
  }
  if (MakeSmoothShape(point, normal, flip).inconsistent) {
    return Complaint{Severity::kAdvise, "Inconsistant triangle normals.", false};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Complaint> Check(const PhongTriangleSpec& spec) {
  return CheckSmooth(spec.point, spec.normal, spec.flip);
}
std::optional<Complaint> Check(const TriangleUvSpec& spec) {
  for (const auto& uv : spec.uv) {
    if (!std::isfinite(uv[0]) || !std::isfinite(uv[1])) {
      return Refuse("Degenerate triangle.", Severity::kAdvise);
    }
  }
  return CheckSmooth(spec.point, spec.normal, spec.flip);
}

Bounds BoxOf(const PhongTriangleSpec& spec) { return TriangleBox(spec.point); }
Bounds BoxOf(const TriangleUvSpec& spec) { return TriangleBox(spec.point); }

std::unique_ptr<const Geom> Make(const PhongTriangleSpec& spec) {
  return std::make_unique<PhongTriangle>(MakeSmoothShape(spec.point, spec.normal, spec.flip));
}
std::unique_ptr<const Geom> Make(const TriangleUvSpec& spec) {
  return std::make_unique<UvTriangle>(MakeSmoothShape(spec.point, spec.normal, spec.flip), spec);
}

}  // namespace rayshade
