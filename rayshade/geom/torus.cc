// The torus; see torus.h. The quartic is set up in units of the outer radius from the point of the
// ray nearest to the centre, searched inside the bounding sphere only, and its zeros are polished
// on the distance to the ring: neither size nor distance costs digits (Rayshade's own solution is
// good for sizes between 0.6 and 1e4 up to 1e3 radii away [rayshade4/2 s.12]).
#include "rayshade/geom/torus.h"

#include <cmath>

#include "rayshade/geom/frame.h"
#include "rayshade/geom/primitive.h"
#include "rayshade/geom/quartic.h"
#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

Transform FrameOf(const TorusSpec& spec) {
  return *CanonicalFrame(spec.center, Normalized(spec.normal), 1, 1);
}

Bounds CanonicalBox(const TorusSpec& spec) {
  const double reach = spec.swept_radius + spec.tube_radius, r = spec.tube_radius;
  return {{-reach, -reach, -r}, {reach, reach, r}};
}

class Torus final : public Geom {
 public:
  explicit Torus(const TorusSpec& spec)
      : frame_(FrameOf(spec)), swept_(spec.swept_radius), tube_(spec.tube_radius) {}

  bool closed() const override { return true; }
  bool inclusive() const override { return false; }
  Bounds bounds() const override { return frame_.Box(CanonicalBox({swept_, tube_, {}, {}})); }
  size_t bytes() const override { return sizeof *this; }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override;
  void Describe(const ObjectRay& ray, double, double distance, HitPath* path) const override;
  UvPoint Uv(const HitPath& path) const override;

 private:
  Transform frame_;
  double swept_, tube_;
};

// A torus of outer radius 1 and a ray whose origin is its point nearest to the centre.
struct UnitTorus {
  double swept, tube;
  Vector o, d;

  Quartic Equation() const {
    const double a = swept * swept, b = tube * tube;
    const double g0 = Dot(o, o) - a - b, g2 = Dot(o, d);
    return {{g0 * g0 + 4 * a * (o.z * o.z - b), 4 * (g2 * g0 + 2 * a * o.z * d.z),
             2 * (g0 + 2 * g2 * g2 + 2 * a * d.z * d.z), 4 * g2, 1}};
  }

  // Where the ray is inside both the bounding sphere and the slab |z| <= tube.
  bool Interval(double* low, double* high) const {
    constexpr double kMargin = 1 + 1e-9;
    const double square = kMargin - Dot(o, o);
    if (!(square > 0)) return false;
    const double middle = -Dot(o, d);
    *low = middle - std::sqrt(square);
    *high = middle + std::sqrt(square);
    const double reach = tube * kMargin;
    if (d.z == 0) return std::abs(o.z) <= reach;
    const double first = (-reach - o.z) / d.z, second = (reach - o.z) / d.z;
    *low = std::max(*low, std::min(first, second));
    *high = std::min(*high, std::max(first, second));
    return *low < *high;
  }

  // Newton on the distance from the ring, where that is the sheet that the zero lies on.
  double Polish(double t) const {
    for (int i = 0; i < 2; ++i) {
      const Vector p = o + t * d;
      const double rho = std::sqrt(p.x * p.x + p.y * p.y);
      const double out = rho - swept;
      const double value = out * out + p.z * p.z - tube * tube;
      const double slope = 2 * (out * ((p.x * d.x + p.y * d.y) / rho) + p.z * d.z);
      const double step = value / slope;
      if (!(std::abs(step) < 1e-9)) return t;
      t -= step;
    }
    return t;
  }
};

bool Torus::Intersect(const ObjectRay& ray, double min, double max, double* distance) const {
  const CanonicalRay r = ToCanonical(frame_, ray);
  const double size = swept_ + tube_;
  const double shift = -Dot(r.origin, r.direction);
  const Vector foot = r.origin + shift * r.direction;
  const UnitTorus torus{
      swept_ / size, tube_ / size, {foot.x / size, foot.y / size, foot.z / size}, r.direction};
  double low, high;
  if (!torus.Interval(&low, &high)) return false;
  double roots[4];
  const int count = SignChanges(torus.Equation(), low, high, roots);
  for (int i = 0; i < count; ++i) {
    const double s = (shift + size * torus.Polish(roots[i])) / r.scale;
    if (!(s > min)) continue;
    if (!(s < max)) return false;
    *distance = s;
    return true;
  }
  return false;
}

void Torus::Describe(const ObjectRay& ray, double, double distance, HitPath* path) const {
  BeginPath(this, ray, distance, ReachOf(frame_) + swept_ + tube_, path);
  const Vector p = frame_.InversePoint(path->point);
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  Vector ring;
  if (rho > kEpsilon * std::min(1.0, swept_)) ring = {swept_ * p.x / rho, swept_ * p.y / rho, 0};
  // On the inner sheet of a spindle the tube belongs to the far side of the ring.
  if (tube_ > swept_ && std::abs(Length(p + ring) - tube_) < std::abs(Length(p - ring) - tube_)) {
    ring = -ring;
  }
  SetNormal(UnitOf(frame_.Normal(p - ring)), path);
}

// dv is brought out of the canonical frame although it is outside already, as in Rayshade.
UvPoint Torus::Uv(const HitPath& path) const {
  const Vector p = frame_.InversePoint(path.point);
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  const auto turn = [](double cosine) {
    return cosine > 1 ? 0 : cosine < -1 ? 0.5 : std::acos(cosine) / (2 * kPi);
  };
  UvPoint uv;
  uv.u = rho > 0 ? turn(p.x / rho) : 0;
  if (p.y < 0) uv.u = 1 - uv.u;
  uv.v = turn(-(rho - swept_) / tube_);
  if (p.z > 0) uv.v = 1 - uv.v;
  uv.du = UnitOf(frame_.Direction({-p.y, p.x, 0}));
  uv.dv = UnitOf(frame_.Direction(Cross(path.geometric_normal, uv.du)));
  return uv;
}

}  // namespace

std::optional<Complaint> Check(const TorusSpec& spec) {
  if (!(spec.swept_radius >= kEpsilon && spec.tube_radius >= kEpsilon) ||
      !std::isfinite(spec.swept_radius + spec.tube_radius) || !IsFinite(spec.center)) {
    return Refuse("Degenerate torus.");
  }
  const double length = Length(spec.normal);
  if (!(length >= kEpsilon) || !std::isfinite(length)) return Refuse("Degenerate torus normal.");
  return std::nullopt;
}

Bounds BoxOf(const TorusSpec& spec) { return FrameOf(spec).Box(CanonicalBox(spec)); }

std::unique_ptr<const Geom> Make(const TorusSpec& spec) { return std::make_unique<Torus>(spec); }

}  // namespace rayshade
