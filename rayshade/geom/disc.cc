// The disc; see disc.h. Its u is meaningful only where the centre lies on the z axis: kept, since
// textures show it.
#include "rayshade/geom/disc.h"

#include <algorithm>

#include "rayshade/geom/plane.h"
#include "rayshade/geom/primitive.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

class Disc final : public Geom {
 public:
  explicit Disc(const DiscSpec& spec) : spec_(spec) {
    Normalize(&spec_.normal);
    offset_ = Dot(spec_.normal, spec_.center);
  }

  bool closed() const override { return false; }
  bool inclusive() const override { return true; }
  Bounds bounds() const override { return BoxOf(spec_); }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    double s, cosine;
    if (!PlaneDistance(spec_.normal, offset_, ray.origin, ray.direction, &s, &cosine)) return false;
    if (!(s >= min && s <= max)) return false;
    const Vector from = ray.origin + s * ray.direction - spec_.center;
    if (!(Dot(from, from) <= spec_.radius * spec_.radius)) return false;
    *distance = s;
    return true;
  }

  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override {
    BeginPath(this, ray, distance, ReachOf(bounds()), path);
    SetNormal(spec_.normal, path);
  }

  UvPoint Uv(const HitPath& path) const override {
    const Vector from = path.point - spec_.center;
    const double square = Dot(from, from);
    UvPoint uv;
    if (square < kEpsilon) {
      // Rayshade leaves the tangents unset here; any pair across the normal will do.
      const AxisPair axes = AxesAcross(path.geometric_normal);
      return {0, 0, axes.u, axes.v};
    }
    const double d = std::sqrt(square);
    uv.v = d / spec_.radius;
    const double w = path.point.x / d;
    if (std::abs(w) > 1) {
      uv.u = 0.5;
    } else {
      uv.u = std::acos(w) / (2 * kPi);
      if (path.point.y < 0) uv.u = 1 - uv.u;
    }
    uv.dv = from;
    uv.du = Cross(from, path.geometric_normal);
    return uv;
  }

 private:
  DiscSpec spec_;  // normal: unit
  double offset_;
};

}  // namespace

std::optional<Complaint> Check(const DiscSpec& spec) {
  if (!(spec.radius >= kEpsilon) || !std::isfinite(spec.radius) || !IsFinite(spec.center)) {
    return Refuse("Degenerate disc.");
  }
  const double length = Length(spec.normal);
  if (!(length >= kEpsilon) || !std::isfinite(length)) return Refuse("Degenerate disc normal.");
  return std::nullopt;
}

Bounds BoxOf(const DiscSpec& spec) {
  const Vector n = Normalized(spec.normal);
  Vector reach;
  for (int axis = 0; axis < 3; ++axis) {
    reach[axis] = spec.radius * std::sqrt(std::max(0.0, 1 - n[axis] * n[axis]));
  }
  return {spec.center - reach, spec.center + reach};
}

std::unique_ptr<const Geom> Make(const DiscSpec& spec) { return std::make_unique<Disc>(spec); }

}  // namespace rayshade
