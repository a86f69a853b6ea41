// What a shadow ray goes through: transparent objects tint the light [rayshade4/3 s.7]. Crossings
// are collected first, from as many object sets as there are and in any order, and folded at the
// end in order along the ray: the result does not depend on how the objects are spread.
#pragma once

#include <optional>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/scene/scene.h"

namespace rayshade {

struct ShadowCrossing {
  double distance = 0;
  Rank rank = 0;
  Color through;       // transp * body of the textured surface
  double extinct = 1;  // of the medium behind it, where the ray enters
  bool entering = false;
  bool opaque = false;  // no light comes through

  bool operator<(const ShadowCrossing& o) const {
    return distance < o.distance || (distance == o.distance && rank < o.rank);
  }
};

// Appends everything that the shadow ray meets in the set within its limit. REQUIRES:
// ObjectSet::Block found nothing opaque there.
void CollectCrossings(const Scene& scene, const ObjectSet& set, const Ray& shadow, double limit,
                      std::vector<ShadowCrossing>* crossings, OpCounts* counts);

// What is left of the light after its crossings (sorted here; one that several sets reported counts
// once). Nothing where the light does not arrive.
std::optional<Color> FoldCrossings(std::vector<ShadowCrossing>* crossings, Color light);

}  // namespace rayshade
