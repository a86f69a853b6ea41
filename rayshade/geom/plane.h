// The infinite plane [rayshade4/2 s.6.3]. Rays within 1e-5 of lying in it miss it.
#pragma once

#include <memory>

#include "rayshade/geom/complaint.h"
#include "rayshade/geom/geom.h"

namespace rayshade {

// Distance to the plane n . p = offset, the way all flat primitives compute it; false within
// kEpsilon of parallel. *cosine: n . D.
inline bool PlaneDistance(const Vector& normal, double offset, const Vector& origin,
                          const Vector& direction, double* distance, double* cosine) {
  *cosine = Dot(normal, direction);
  if (!(std::abs(*cosine) >= kEpsilon)) return false;
  *distance = (offset - Dot(normal, origin)) / *cosine;
  return true;
}

std::optional<Complaint> Check(const PlaneSpec& spec);
std::unique_ptr<const Geom> Make(const PlaneSpec& spec);

}  // namespace rayshade
