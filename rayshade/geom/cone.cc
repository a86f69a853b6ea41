// The cone; see cone.h. Solved in the canonical frame whose origin is the (virtual) apex: x^2 + y^2
// = z^2, start <= z <= 1. The origin of distant rays is moved next to the object first.
#include "rayshade/geom/cone.h"

#include <cmath>

#include "rayshade/geom/cylinder.h"
#include "rayshade/geom/frame.h"
#include "rayshade/geom/primitive.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

struct ConeFrame {
  std::optional<Transform> frame;
  double length = 0;  // of the axis between the ends; 0: degenerate
  double start = 0;   // canonical z of the smaller end
};

// The larger end is the top.
ConeFrame FrameOf(ConeSpec spec) {
  if (spec.top_radius < spec.base_radius) {
    std::swap(spec.top_radius, spec.base_radius);
    std::swap(spec.top, spec.base);
  }
  ConeFrame cone;
  Vector axis = spec.top - spec.base;
  cone.length = Normalize(&axis);
  if (!(cone.length > 0)) return cone;
  const double growth = (spec.top_radius - spec.base_radius) / cone.length;
  const double below = spec.base_radius / growth;  // apex to base
  const Vector apex = spec.base - below * axis;
  const double whole = below + cone.length;
  cone.start = below / whole;
  cone.frame = CanonicalFrame(apex, axis, spec.top_radius, whole);
  return cone;
}

bool IsCylinder(const ConeSpec& spec) {
  return std::abs(spec.base_radius - spec.top_radius) < kEpsilon;
}
CylinderSpec AsCylinder(const ConeSpec& spec) { return {spec.base_radius, spec.base, spec.top}; }

class Cone final : public Geom {
 public:
  Cone(const Transform& frame, double start) : frame_(frame), start_(start) {}

  bool closed() const override { return false; }
  bool inclusive() const override { return false; }
  Bounds bounds() const override { return frame_.Box({{-1, -1, start_}, {1, 1, 1}}); }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override;

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, ReachOf(frame_), path);
    const Vector p = frame_.InversePoint(path->point);
    SetNormal(UnitOf(frame_.Normal({p.x * p.z, p.y * p.z, -(p.x * p.x + p.y * p.y)})), path);
  }

  UvPoint Uv(const HitPath& path) const override;

 private:
  Transform frame_;
  double start_;
};

bool Cone::Intersect(const ObjectRay& ray, double min, double max, double* distance) const {
  const CanonicalRay r = ToCanonical(frame_, ray);
  const Vector& d = r.direction;
  const double shift = ShiftTowards(r, {0, 0, 0.5 * (start_ + 1)});
  const Vector o = shift == 0 ? r.origin : r.origin + shift * d;

  // Roots of a t^2 + 2 b t + c; along the surface lines a is 0 and one root remains.
  const double a = d.x * d.x + d.y * d.y - d.z * d.z;
  const double b = d.x * o.x + d.y * o.y - d.z * o.z;
  const double c = o.x * o.x + o.y * o.y - o.z * o.z;
  double roots[2];
  int count = 0;
  if (std::abs(a) < kEpsilon) {
    // With one step towards the root of the whole equation.
    const double t = -c / (2 * b);
    const double polished = t - ((a * t + 2 * b) * t + c) / (2 * (a * t + b));
    roots[count++] = std::isfinite(polished) ? polished : t;
  } else {
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return false;
    const double root = std::sqrt(discriminant);
    roots[count++] = (-b - root) / a;
    roots[count++] = (-b + root) / a;
    if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  }
  for (int i = 0; i < count; ++i) {
    const double z = o.z + roots[i] * d.z;
    if (!(shift + roots[i] >= min * r.scale && z >= start_ && z <= 1)) continue;
    const double s = (shift + roots[i]) / r.scale;
    if (!(s < max)) return false;
    *distance = s;
    return true;
  }
  return false;
}

// dv is not brought out of the canonical frame and du is brought out twice, as in Rayshade.
UvPoint Cone::Uv(const HitPath& path) const {
  const Vector p = frame_.InversePoint(path.point);
  UvPoint uv;
  uv.v = (p.z - start_) / (1 - start_);
  if (p.z < kEpsilon) {
    uv.u = 0;
  } else {
    const double x = p.x / p.z;
    if (x > 1) {
      uv.u = 0;
    } else if (x < -1) {
      uv.u = 0.5;
    } else {
      uv.u = std::acos(x) / (2 * kPi);
      if (p.y < 0) uv.u = 1 - uv.u;
    }
  }
  uv.du = UnitOf(frame_.Direction(frame_.Direction({-p.y, p.x, 0})));
  uv.dv = UnitOf(p);
  return uv;
}

}  // namespace

std::optional<Complaint> Check(const ConeSpec& spec) {
  const ConeFrame cone = FrameOf(spec);
  if (IsCylinder(spec)) return Check(AsCylinder(spec));
  if (!(cone.length > 0) || !std::isfinite(cone.length) || !std::isfinite(spec.base_radius) ||
      !std::isfinite(spec.top_radius)) {
    return Refuse("Degenerate cone.");
  }
  if (!cone.frame) return Refuse("Singular matrix.", Severity::kFatal);
  return std::nullopt;
}

Bounds BoxOf(const ConeSpec& spec) {
  if (IsCylinder(spec)) return BoxOf(AsCylinder(spec));
  const ConeFrame cone = FrameOf(spec);
  return cone.frame->Box({{-1, -1, cone.start}, {1, 1, 1}});
}

std::unique_ptr<const Geom> Make(const ConeSpec& spec) {
  if (IsCylinder(spec)) return Make(AsCylinder(spec));
  const ConeFrame cone = FrameOf(spec);
  return std::make_unique<Cone>(*cone.frame, cone.start);
}

}  // namespace rayshade
