// The primitives that are measured: each of a given size, in general position near the origin.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rayshade/geom/geom.h"

namespace rayshade::stability {

struct Subject {
  std::string name;
  GeomSpec spec;
  Vector center;     // world
  double reach = 1;  // radius of a ball around it, world
  double scale = 1;  // of a placement around it: height fields have no size of their own

  // The nearest crossing in (min, max), world distances, the way the renderer brings rays to placed
  // objects.
  std::optional<double> Intersect(const Vector& origin, const Vector& direction, double min,
                                  double max) const;

  std::shared_ptr<const Geom> geom;
  TransformChain placement;
};

// All twelve kinds; those that the language refuses at this size are left out.
std::vector<Subject> SubjectsOf(double size);

}  // namespace rayshade::stability
