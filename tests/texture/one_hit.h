// A picture's pixel without a tracer: one ray of a fixed view, one object, its textures one after
// the other, one light. For the rows of [rayshade4/3 s.16.6].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "rayshade/geom/geom.h"
#include "rayshade/texture/texture.h"

namespace rayshade::test {

using Bytes = std::array<int, 3>;

// A primitive of the test's own, so that textures are tested apart from geom/.
class OneGeom : public Geom {
 public:
  bool closed() const override { return true; }
  bool inclusive() const override { return true; }
  Bounds bounds() const override { return {}; }
  size_t bytes() const override { return sizeof(*this); }
};

class OnePlane : public OneGeom {
 public:
  OnePlane(Vector point, Vector normal) : point_(point), normal_(normal) {}
  bool Intersect(const ObjectRay& ray, double min, double, double* distance) const override {
    *distance = Dot(point_ - ray.origin, normal_) / Dot(ray.direction, normal_);
    return *distance > min;
  }
  void Describe(const ObjectRay&, double, double, HitPath* path) const override {
    path->normal = path->geometric_normal = normal_;
  }
  UvPoint Uv(const HitPath&) const override { return {}; }

 private:
  Vector point_, normal_;
};

class OneSphere : public OneGeom {
 public:
  OneSphere(double radius, Vector center) : radius_(radius), center_(center) {}
  bool Intersect(const ObjectRay& ray, double min, double, double* distance) const override {
    const Vector to_center = center_ - ray.origin;
    const double b = Dot(to_center, ray.direction);
    const double square = b * b + radius_ * radius_ - Dot(to_center, to_center);
    if (square < 0) return false;
    *distance = b - std::sqrt(square);
    return *distance > min;
  }
  void Describe(const ObjectRay&, double, double, HitPath* path) const override {
    path->normal = path->geometric_normal = Normalized(path->point - center_);
  }
  UvPoint Uv(const HitPath& path) const override {
    const Vector r = Normalized(path.point - center_);
    UvPoint uv;
    const double phi = std::acos(-r.z);
    uv.v = phi / kPi;
    const double theta = std::acos(std::clamp(r.x / std::sin(phi), -1.0, 1.0)) / (2 * kPi);
    uv.u = r.y > 0 ? theta : 1 - theta;
    uv.du = Normalized({-r.y, r.x, 0});
    uv.dv = Normalized(Cross(r, uv.du));
    return uv;
  }

 private:
  double radius_;
  Vector center_;
};

// The scene of the rows: view, background and light are fixed.
struct OneHitScene {
  const Geom* geom = nullptr;
  Transform object;  // primitive to world
  Surface surface;
  std::vector<const Texture*> textures;
  double fov = 45;

  // Rays go through (column - 1/2, row - 1/2) of a 9 x 9 screen.
  Vector Direction(int column, int row) const {
    const double step = 2 * 10 * std::tan(0.5 * fov * kPi / 180) / 9;
    return Normalized({(column - 0.5 - 4.5) * step, 10, -(row - 0.5 - 4.5) * step});
  }

  // The hit of a pixel's ray, ready for the first texture; path must outlive it.
  std::optional<TextureHit> Hit(int column, int row, HitPath* path) const {
    TextureHit hit;
    hit.ray_origin = {.11, -10, .07};
    hit.ray_direction = Direction(column, row);
    ObjectRay ray{object.InversePoint(hit.ray_origin),
                  Normalized(object.InverseDirection(hit.ray_direction)),
                  {}};
    double distance = 0;
    if (!geom->Intersect(ray, kEpsilon, kFar, &distance)) return std::nullopt;
    path->primitive = geom;
    path->ray = ray;
    path->distance = distance;
    path->point = ray.origin + distance * ray.direction;
    geom->Describe(ray, kEpsilon, distance, path);
    if (Dot(path->normal, ray.direction) > 0) {
      path->normal = -path->normal;
      path->geometric_normal = -path->geometric_normal;
    }
    hit.surface = surface;
    hit.point = object.Point(path->point);
    hit.normal = Normalized(object.Normal(path->normal));
    hit.primitive_to_model = object;
    hit.path = path;
    return hit;
  }

  // After all textures: ambient light, one directional light from -y, and what shines through.
  Bytes Pixel(int column, int row) const {
    HitPath path;
    const Color background{.8, .4, .2};
    std::optional<TextureHit> hit = Hit(column, row, &path);
    if (!hit) return ToBytes(background);
    for (const Texture* texture : textures) {
      texture->Apply(&*hit);
      ++hit->application;
    }
    const Surface& s = hit->surface;
    const Vector &i = hit->ray_direction, &n = hit->normal, light{0, -1, 0};
    const Vector mirror = i + -2 * Dot(i, n) * n;
    Color color = s.ambient;
    const double cosine = Dot(light, n);
    if (cosine > 0) {
      color += cosine * s.diffuse;
      const double a = Dot(mirror, light);
      if (a > 0) color += std::pow(a, s.specpow) * s.specular;
    }
    if (s.transp > .002) color += s.transp * s.body * background;
    return ToBytes(color);
  }

  static Bytes ToBytes(const Color& c) {
    Bytes bytes;
    for (int i = 0; i < 3; ++i) {
      bytes[static_cast<size_t>(i)] = c[i] < 0 ? 0 : c[i] > 1 ? 255 : static_cast<int>(255 * c[i]);
    }
    return bytes;
  }
};

}  // namespace rayshade::test
