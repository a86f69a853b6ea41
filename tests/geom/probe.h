// A ray shot at one object, and everything that there is to know about its first hit.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "rayshade/geom/make_geom.h"

namespace rayshade {

struct Probe {
  bool hit = false;
  double distance = 0;
  HitPath path;  // geometric_normal turned towards the ray, as shading does it
  UvPoint uv;
};

inline Probe ShootAt(const Geom& geom, const Vector& origin, Vector direction,
                     double min = kEpsilon, double max = kFar) {
  Normalize(&direction);
  Probe probe;
  const ObjectRay ray{origin, direction, {}};
  probe.hit = geom.Intersect(ray, min, max, &probe.distance);
  if (!probe.hit) return probe;
  geom.Describe(ray, min, probe.distance, &probe.path);
  if (Dot(direction, probe.path.geometric_normal) > 0) {
    probe.path.geometric_normal = -probe.path.geometric_normal;
    probe.path.normal = -probe.path.normal;
  }
  probe.uv = probe.path.primitive->Uv(probe.path);
  return probe;
}

inline Probe ShootAt(const GeomSpec& spec, const Vector& origin, const Vector& direction,
                     double min = kEpsilon, double max = kFar) {
  return ShootAt(*MakeGeom(spec), origin, direction, min, max);
}

inline void ExpectNear(const Vector& expected, const Vector& actual, double tolerance = 1e-9) {
  EXPECT_NEAR(expected.x, actual.x, tolerance);
  EXPECT_NEAR(expected.y, actual.y, tolerance);
  EXPECT_NEAR(expected.z, actual.z, tolerance);
}

}  // namespace rayshade
