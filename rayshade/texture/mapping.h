// From a hit to texture coordinates (u, v), for the textures that are two-dimensional
// [rayshade4/3 s.11.1].
#pragma once

#include "rayshade/common/transform.h"
#include "rayshade/texture/texture_space.h"

namespace rayshade {

struct MappedPoint {
  double u = 0, v = 0;
  Vector du{1, 0, 0}, dv{0, 1, 0};  // unit where they can be
};

class Mapping {
 public:
  // A planar frame that spans no plane is replaced by the axes x and y.
  explicit Mapping(const MappingSpec& spec);

  // space: of the texture. tangents: du and dv are wanted as well.
  MappedPoint Map(const TextureHit& hit, const TextureSpace& space, bool tangents) const;

 private:
  MappedPoint Uv(const TextureHit& hit, const Transform& texture) const;
  MappedPoint Planar(const Vector& m) const;
  MappedPoint Cylindrical(const Vector& m) const;
  MappedPoint Spherical(const Vector& m) const;

  MappingKind kind_;
  Vector origin_;
  Vector x_{1, 0, 0}, y_{0, 1, 0}, axis_{0, 0, 1};  // unit; planar: x_ and y_ are du and dv
  Matrix planar_;                                   // model space to (u, v, -)
};

// The normal n of a surface with these tangents after a bump of slopes fu, fv.
Vector Tilted(const Vector& n, const MappedPoint& at, double fu, double fv);

}  // namespace rayshade
