// The cylinder; see cylinder.h. Solved in the canonical frame (x^2 + y^2 = 1, 0 <= z <= 1); the
// origin of distant rays is moved next to the object first.
#include "rayshade/geom/cylinder.h"

#include <cmath>

#include "rayshade/geom/frame.h"
#include "rayshade/geom/primitive.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

struct Axis {
  Vector direction;
  double length;
};

Axis AxisOf(const CylinderSpec& spec) {
  Axis axis{spec.top - spec.base, 0};
  axis.length = Normalize(&axis.direction);
  return axis;
}

std::optional<Transform> FrameOf(const CylinderSpec& spec) {
  const Axis axis = AxisOf(spec);
  return CanonicalFrame(spec.base, axis.direction, spec.radius, axis.length);
}

class Cylinder final : public Geom {
 public:
  explicit Cylinder(const Transform& frame) : frame_(frame) {}

  bool closed() const override { return false; }
  bool inclusive() const override { return false; }
  Bounds bounds() const override { return frame_.Box({{-1, -1, 0}, {1, 1, 1}}); }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override;

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, ReachOf(frame_), path);
    const Vector p = frame_.InversePoint(path->point);
    SetNormal(UnitOf(frame_.Normal({p.x, p.y, 0})), path);
  }

  UvPoint Uv(const HitPath& path) const override {
    const Vector p = frame_.InversePoint(path.point);
    UvPoint uv;
    uv.u = p.x > 1 ? 0 : p.x < -1 ? 0.5 : std::acos(p.x) / (2 * kPi);
    if (p.y < 0) uv.u = 1 - uv.u;
    uv.v = p.z;
    uv.du = UnitOf(frame_.Direction({-p.y, p.x, 0}));
    uv.dv = UnitOf(frame_.Direction({0, 0, 1}));
    return uv;
  }

 private:
  Transform frame_;
};

bool Cylinder::Intersect(const ObjectRay& ray, double min, double max, double* distance) const {
  const CanonicalRay r = ToCanonical(frame_, ray);
  const Vector& d = r.direction;
  const double a = d.x * d.x + d.y * d.y;
  if (!(a >= kEpsilon * kEpsilon)) return false;
  const double shift = ShiftTowards(r, {0, 0, 0.5});
  const Vector o = shift == 0 ? r.origin : r.origin + shift * d;

  // Roots of a t^2 + 2 b t + c.
  const double b = d.x * o.x + d.y * o.y;
  const double c = o.x * o.x + o.y * o.y - 1;
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return false;
  const double root = std::sqrt(discriminant);
  for (const double t : {(-b - root) / a, (-b + root) / a}) {
    const double z = o.z + t * d.z;
    if (!(shift + t >= min * r.scale && z >= 0 && z <= 1)) continue;
    const double s = (shift + t) / r.scale;
    if (!(s < max)) return false;
    *distance = s;
    return true;
  }
  return false;
}

}  // namespace

std::optional<Complaint> Check(const CylinderSpec& spec) {
  if (!(spec.radius > 0) || !std::isfinite(spec.radius)) {
    return Refuse("Invalid cylinder radius.");
  }
  const Axis axis = AxisOf(spec);
  if (!(axis.length > 0) || !std::isfinite(axis.length)) return Refuse("Degenerate cylinder.");
  if (!FrameOf(spec)) return Refuse("Singular matrix.", Severity::kFatal);
  return std::nullopt;
}

Bounds BoxOf(const CylinderSpec& spec) { return FrameOf(spec)->Box({{-1, -1, 0}, {1, 1, 1}}); }

std::unique_ptr<const Geom> Make(const CylinderSpec& spec) {
  return std::make_unique<Cylinder>(*FrameOf(spec));
}

}  // namespace rayshade
