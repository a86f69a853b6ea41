// See mapping.h.
#include "rayshade/texture/mapping.h"

#include <algorithm>
#include <cmath>

namespace rayshade {
namespace {

constexpr double kTwoPi = 2.0 * kPi;

}  // namespace

Mapping::Mapping(const MappingSpec& spec) : kind_(spec.kind) {
  if (!spec.framed || kind_ == MappingKind::kUv) return;
  origin_ = spec.origin;
  if (kind_ == MappingKind::kPlanar) {
    // The origin of a planar frame has no effect (s.14, K15).
    const Vector& u = spec.u_axis;
    const Vector& v = spec.up;
    const Vector w = Cross(u, v);
    const auto inverse = Inverse({{{u.x, u.y, u.z}, {v.x, v.y, v.z}, {w.x, w.y, w.z}}});
    if (!inverse) return;
    planar_ = *inverse;
    x_ = Normalized(u);
    y_ = Normalized(v);
    return;
  }
  axis_ = Normalized(spec.up);
  y_ = Normalized(Cross(spec.up, spec.u_axis));
  x_ = Normalized(Cross(y_, spec.up));
}

MappedPoint Mapping::Uv(const TextureHit& hit, const Transform& texture) const {
  // Texture space, back through the primitive's transformations, then through the texture's own:
  // Rayshade's order, odd where both are there (s.14, K15).
  HitPath path = *hit.path;
  path.point = texture.Point(hit.primitive_to_model.InversePoint(texture.InversePoint(hit.point)));
  const UvPoint uv = path.primitive->Uv(path);
  return {uv.u, uv.v, uv.du, uv.dv};
}

MappedPoint Mapping::Planar(const Vector& m) const {
  const Vector uv = Transform::Apply(planar_, m);
  return {uv.x, uv.y, x_, y_};
}

MappedPoint Mapping::Cylindrical(const Vector& m) const {
  const Vector r = m - origin_;
  MappedPoint at{0, Dot(axis_, r), x_, axis_};
  double a = Dot(x_, r), c = Dot(y_, r);
  const double h = std::sqrt(a * a + c * c);
  if (h < kEpsilon) return at;
  a /= h;
  c /= h;
  // Rounding may carry a beyond 1; Rayshade then has 0.5 on both sides (s.14, F8).
  at.u = std::acos(std::clamp(a, -1.0, 1.0)) / kTwoPi;
  if (c < 0) at.u = 1.0 - at.u;
  at.du = Normalized(Cross(axis_, m));  // from the origin of the space, not of the frame (K15)
  return at;
}

MappedPoint Mapping::Spherical(const Vector& m) const {
  Vector r = m - origin_;
  MappedPoint at{0, 0, x_, y_};
  if (Normalize(&r) == 0) return at;
  const double phi = std::acos(std::clamp(-Dot(axis_, r), -1.0, 1.0));
  at.v = phi / kPi;
  if (at.v < kEpsilon || 1.0 - at.v < kEpsilon) return at;
  const double t = Dot(x_, r) / std::sin(phi);
  const double theta = t > 1 ? 0 : t < -1 ? 0.5 : std::acos(t) / kTwoPi;
  at.u = Dot(y_, r) > 0 ? theta : 1.0 - theta;
  // Rayshade leaves these unset (s.14, F3); here they are those of the sphere.
  at.du = Normalized(Cross(axis_, r));
  at.dv = Normalized(Cross(r, at.du));
  return at;
}

MappedPoint Mapping::Map(const TextureHit& hit, const TextureSpace& space, bool tangents) const {
  const Transform texture = space.At(hit.moment);
  MappedPoint at;
  switch (kind_) {
    case MappingKind::kUv:
      at = Uv(hit, texture);
      break;
    case MappingKind::kPlanar:
      at = Planar(hit.point);
      break;
    case MappingKind::kCylindrical:
      at = Cylindrical(hit.point);
      break;
    case MappingKind::kSpherical:
      at = Spherical(hit.point);
      break;
  }

  // The texture's own transformations act on (u, v).
  const Vector uv = texture.InversePoint({at.u, at.v, 0});
  at.u = uv.x;
  at.v = uv.y;
  if (!tangents) return at;

  // The primitive's are applied to the tangents of every mapping, as in Rayshade (K15).
  const Transform& p = hit.primitive_to_model;
  const Vector rows[3] = {p.Direction(at.du), p.Direction(at.dv),
                          p.Direction(hit.path->geometric_normal)};
  const auto& t = texture.matrix.m;
  at.du = Normalized(t[0][0] * rows[0] + t[0][1] * rows[1] + t[0][2] * rows[2]);
  at.dv = Normalized(t[1][0] * rows[0] + t[1][1] * rows[1] + t[1][2] * rows[2]);
  return at;
}

Vector Tilted(const Vector& n, const MappedPoint& at, double fu, double fv) {
  return Normalized(n + (fu * Cross(n, at.dv) - fv * Cross(n, at.du)));
}

}  // namespace rayshade
