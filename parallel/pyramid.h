// A bundle of rays enclosed: the box of their origins and the box of their directions. Where the
// origins' box is a point this is the paper's pyramid with the viewpoint as its top [RJ s.1];
// lenses and bundles of shadow rays have larger boxes.
#pragma once

#include <span>

#include "parallel/cell_tree.h"
#include "rayshade/common/bounds.h"
#include "rayshade/common/ray.h"

namespace rayshade::parallel {

struct Pyramid {
  Bounds origins;
  Bounds directions;

  static Pyramid Around(std::span<const Ray> rays);
  // Every ray goes the same way along at least one axis, so that boxes can be ordered and
  // discarded; a bundle whose rays go everywhere is no pyramid.
  bool narrow() const;
};

// Within which distances some ray of the pyramid may be inside the box: encloses Intersect(box,
// ray) of each of its rays. Empty only if none of them meets the box.
RayInterval Intersect(const Bounds& box, const Pyramid& pyramid);

}  // namespace rayshade::parallel
