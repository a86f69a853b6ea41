// The infinite plane; see plane.h.
#include "rayshade/geom/plane.h"

#include "rayshade/geom/primitive.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

class Plane final : public Geom {
 public:
  explicit Plane(const PlaneSpec& spec)
      : spec_(spec), normal_(Normalized(spec.normal)), offset_(Dot(normal_, spec.point)) {}

  bool bounded() const override { return false; }
  bool closed() const override { return false; }
  bool inclusive() const override { return false; }
  Bounds bounds() const override { return {}; }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    double s, cosine;
    if (!PlaneDistance(normal_, offset_, ray.origin, ray.direction, &s, &cosine)) return false;
    if (!(s > min && s < max)) return false;
    *distance = s;
    return true;
  }

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, SumOfSizes(spec_.point), path);
    SetNormal(normal_, path);
  }

  UvPoint Uv(const HitPath& path) const override {
    const AxisPair axes = AxesAcross(path.geometric_normal);
    const Vector from = path.point - spec_.point;
    return {Dot(from, axes.u), Dot(from, axes.v), axes.u, axes.v};
  }

 private:
  PlaneSpec spec_;
  Vector normal_;
  double offset_;
};

}  // namespace

std::optional<Complaint> Check(const PlaneSpec& spec) {
  const double length = Length(spec.normal);
  if (!(length >= kEpsilon) || !std::isfinite(length) || !IsFinite(spec.point)) {
    return Refuse("Degenerate plane normal.");
  }
  return std::nullopt;
}

std::unique_ptr<const Geom> Make(const PlaneSpec& spec) { return std::make_unique<Plane>(spec); }

}  // namespace rayshade
