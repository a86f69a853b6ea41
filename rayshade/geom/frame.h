// The canonical frame of cylinder, cone and torus [rayshade4/2 s.3.7]: the z axis runs along the
// object, unit radius, unit length.
#pragma once

#include <optional>

#include "rayshade/common/transform.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

// From the canonical frame to the object's space: scale(radius, radius, length), the turn that
// takes z to `axis` (unit), translation to base. Within 4.47e-3 rad of +-z the turn is about x
// whatever the direction of the tilt, as in Rayshade. Nothing where the matrix counts as singular
// (radius^2 length < 1e-10).
std::optional<Transform> CanonicalFrame(const Vector& base, const Vector& axis, double radius,
                                        double length);

// The size of the numbers that rays go through on their way into the frame, in the object's space.
double ReachOf(const Transform& frame);

// A ray in the canonical frame, its direction renormalised: canonical distance = scale * distance.
struct CanonicalRay {
  Vector origin, direction;
  double scale = 0;
};
CanonicalRay ToCanonical(const Transform& frame, const ObjectRay& ray);

// How far along the ray its origin is to be moved so that it lies next to the canonical object
// (|x|, |y|, |z| about 1): 0 where it does already, so that near rays keep Rayshade's arithmetic.
double ShiftTowards(const CanonicalRay& ray, const Vector& center);

}  // namespace rayshade
