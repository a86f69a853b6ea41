// Crossings of shadow rays; see crossing.h.
#include "rayshade/shade/crossing.h"

#include <algorithm>
#include <cmath>

#include "rayshade/shade/shade.h"

namespace rayshade {

namespace {

// A search for further objects starts this much behind a hit, relatively: more than what a distance
// loses on its way into object space and back, so that the same hit is not found again.
constexpr double kBehind = 1e-12;

// All crossings of one object, each searched from kEpsilon behind the one before, as in Rayshade:
// an object's enter rule and the inside of CSG need the ray to have left the surface it comes from.
// That other objects' crossings do not enter here keeps the result independent of what else a set
// holds.
void CollectOf(const Scene& scene, const ObjectSet& set, uint32_t object, const Ray& shadow,
               double limit, std::vector<ShadowCrossing>* crossings, OpCounts* counts) {
  Ray rest = shadow;
  for (;;) {
    Hit hit;
    hit.distance = limit;
    set.NearestOf(rest, object, &hit);
    KindCounts& kind = counts->kinds[set.kind_of(object)];
    ++counts->primitive_tests;
    ++kind.tests;
    if (!hit.found()) return;
    ++kind.hits;
    SurfaceHit resolved;
    ResolveHit(scene, rest, hit, &resolved);
    ShadowCrossing crossing;
    crossing.distance = hit.distance;
    crossing.rank = hit.rank;
    crossing.through = resolved.surface().transp * resolved.surface().body;
    crossing.extinct = resolved.surface().extinct;
    crossing.entering = resolved.entering;
    crossing.opaque = resolved.bound_transp < kEpsilon;
    crossings->push_back(crossing);
    if (crossing.opaque) return;
    rest.min_distance = std::max(hit.distance + kEpsilon, std::nextafter(hit.distance, kFar));
  }
}

}  // namespace

void CollectCrossings(const Scene& scene, const ObjectSet& set, const Ray& shadow, double limit,
                      std::vector<ShadowCrossing>* crossings, OpCounts* counts) {
  const size_t begin = crossings->size();
  Ray rest = shadow;
  for (;;) {
    // The objects in the way, one after the other; each is gone through once.
    Hit hit;
    hit.distance = limit;
    set.Nearest({&rest, 1}, {&hit, 1}, counts);
    if (!hit.found()) return;
    const bool known =
        std::any_of(crossings->begin() + begin, crossings->end(),
                    [&hit](const ShadowCrossing& crossing) { return crossing.rank == hit.rank; });
    if (!known) CollectOf(scene, set, hit.object, shadow, limit, crossings, counts);
    if (!crossings->empty() && crossings->back().opaque) return;
    rest.min_distance = hit.distance * (1 + kBehind);
  }
}

std::optional<Color> FoldCrossings(std::vector<ShadowCrossing>* crossings, Color light) {
  std::sort(crossings->begin(), crossings->end());
  const ShadowCrossing* medium = nullptr;  // what the ray is inside of
  double from = 0;
  for (const ShadowCrossing& c : *crossings) {
    if (c.distance < from)
      continue;  // within kEpsilon of the last one: not met by a ray that starts behind it
    if (c.opaque) return std::nullopt;
    if (medium != nullptr && medium->extinct != 1) {
      light = std::pow(medium->extinct, c.distance - from) * light;
    }
    medium = c.entering ? &c : nullptr;
    light = light * c.through;
    if (light.r < kEpsilon && light.g < kEpsilon && light.b < kEpsilon) return std::nullopt;
    from = c.distance + kEpsilon;
  }
  return light;
}

}  // namespace rayshade
