// The sphere; see sphere.h.
#include "rayshade/geom/sphere.h"

#include "rayshade/geom/primitive.h"

namespace rayshade {
namespace {

class Sphere final : public Geom {
 public:
  explicit Sphere(const SphereSpec& spec) : spec_(spec) {}

  bool closed() const override { return true; }
  bool inclusive() const override { return false; }
  Bounds bounds() const override { return BoxOf(spec_); }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    return IntersectSphere(spec_.center, spec_.radius, ray.origin, ray.direction, min, max,
                           distance);
  }

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, ReachOf(bounds()), path);
    const Vector n = path->point - spec_.center;
    SetNormal({n.x / spec_.radius, n.y / spec_.radius, n.z / spec_.radius}, path);
  }

  // The near root leads in. Rayshade asks whether the ray's beginning lies outside, which is the
  // same but for beginnings on the sphere itself, where that is chance.
  bool Enters(const ObjectRay& ray, double, double distance) const override {
    return distance <= Dot(spec_.center - ray.origin, ray.direction);
  }

  UvPoint Uv(const HitPath& path) const override;

 private:
  SphereSpec spec_;
};

UvPoint Sphere::Uv(const HitPath& path) const {
  const Vector m = Normalized(path.point - spec_.center);
  const double phi = m.z > 1 ? kPi : m.z < -1 ? 0 : std::acos(-m.z);
  UvPoint uv;
  uv.v = phi / kPi;
  if (uv.v < kEpsilon || std::abs(uv.v - 1) < kEpsilon) {
    uv.u = 0;
  } else {
    const double q = m.x / std::sin(phi);
    const double theta = q > 1 ? 0 : q < -1 ? 0.5 : std::acos(q) / (2 * kPi);
    uv.u = m.y > 0 ? theta : 1 - theta;
  }
  uv.du = Normalized({-m.y, m.x, 0});
  uv.dv = Normalized(Cross(m, uv.du));
  return uv;
}

}  // namespace

std::optional<Complaint> Check(const SphereSpec& spec) {
  if (!(spec.radius >= kEpsilon) || !std::isfinite(spec.radius) || !IsFinite(spec.center)) {
    return Refuse("Degenerate sphere.");
  }
  return std::nullopt;
}

Bounds BoxOf(const SphereSpec& spec) {
  const Vector r{spec.radius, spec.radius, spec.radius};
  return {spec.center - r, spec.center + r};
}

std::unique_ptr<const Geom> Make(const SphereSpec& spec) { return std::make_unique<Sphere>(spec); }

}  // namespace rayshade
