// Two axes across a vector, as Rayshade chooses them (coordsys of [rayshade4/3 s.0]): for extended
// lights, gloss and the pattern of planes.
#pragma once

#include "rayshade/common/vector.h"

namespace rayshade {

struct CrossAxes {
  Vector u, w;  // unit; v, u, w is right-handed for a unit v
};

// v need not be unit.
inline CrossAxes AxesAcross(const Vector& v) {
  CrossAxes axes;
  axes.u = {-v.y, v.x, 0};
  if (Normalize(&axes.u) == 0) {
    axes.u = {v.z, 0, -v.x};
    Normalize(&axes.u);
  }
  axes.w = Normalized(Cross(v, axes.u));
  return axes;
}

}  // namespace rayshade
