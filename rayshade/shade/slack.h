// How far a hit may lie off its surface by rounding alone. Rayshade knows a fixed least distance
// only [rayshade4/2 s.2.1], which objects and coordinates that are large enough outgrow: their rays
// then meet the surface that they leave.
//
//   1. A bound, not an estimate: kRoundings times the rounding of the largest numbers that went
//      into the hit, on the way into the object's space and back (measured by `make stability`).
//   2. It matters to no ray where coordinates are below some 1e5 and that does not graze.
#pragma once

#include "rayshade/common/ray.h"
#include "rayshade/common/transform.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

// For an object in place; reach: HitPath's.
double SlackOf(const Ray& ray, double reach, double distance);
// For one that stands behind a transformation from its space to the world.
double SlackOf(const Ray& ray, const HitPath& path, double distance, const Transform& to_world);

}  // namespace rayshade
