// Where a line crosses the surface of a primitive, by the formulas of the textbooks, for any
// scalar: in double precision they are the plain solution, in quadruple precision the truth.
// Nothing here is shared with rayshade/geom, and no canonical frame, shift or threshold is used.
#pragma once

#include <vector>

#include "rayshade/geom/spec.h"
#include "tests/stability/quad.h"

namespace rayshade::stability {

template <class T>
struct Crossing {
  T distance;
  T cosine;  // between the direction and the surface's normal, in size
};

template <class T>
using Crossings = std::vector<Crossing<T>>;

// All crossings beyond 0, ascending. T: double or Quad. scale: of a placement around the object
// (height fields have no size of their own).
template <class T>
Crossings<T> CrossingsOf(const GeomSpec& spec, double scale, const Vector& origin,
                         const Vector& direction);

extern template Crossings<double> CrossingsOf(const GeomSpec&, double, const Vector&,
                                              const Vector&);
extern template Crossings<Quad> CrossingsOf(const GeomSpec&, double, const Vector&, const Vector&);

}  // namespace rayshade::stability
