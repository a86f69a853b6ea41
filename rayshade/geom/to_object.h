// Rays through the transformations written after an object, boxes the other way [rayshade4/2 s.2.2,
// s.2.4].
#pragma once

#include "rayshade/common/transform_chain.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

// Brings *ray from outside into the space before the chain, link by link, the last one first; the
// direction is made a unit vector again at each link, and *scale is multiplied by the lengths that
// it had: inner distance = scale * outer distance. False where the direction vanishes. Objects
// enlarged by any factor stay visible (Rayshade loses them above 1e5).
bool ToObject(const TransformChain& chain, ObjectRay* ray, double* scale);

// The box outside of the chain, grown by kEpsilon before and after; of an animated chain, over the
// whole shutter interval.
Bounds ChainBounds(const TransformChain& chain, const Bounds& own, const ShutterInterval& shutter);

}  // namespace rayshade
