// How soon can a ray that leaves a primitive's surface truly meet it again?
#pragma once

#include "rayshade/geom/spec.h"

namespace rayshade::stability {

// A lower bound for the distance of the next crossing of a ray from the point p of the surface (in
// the object's space) in direction d: twice the slope of the surface's implicit function along the
// ray over a bound of its second derivative. Infinite where the surface curves away from the ray,
// or not at all. Boxes and height fields, whose faces are told apart by their normals, are not
// asked.
double NextCrossing(const GeomSpec& spec, const Vector& p, const Vector& d);

}  // namespace rayshade::stability
