// Where an object stands: the path from the object outwards to the world. One placement serves all
// objects that are written alike in one aggregate; it is stored once per process, however many
// objects use it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rayshade/common/bounds.h"
#include "rayshade/geom/geom.h"
#include "rayshade/geom/spec.h"

namespace rayshade {

using PlacementId = uint32_t;

// One object on the path: the primitive itself, then each enclosing aggregate or instance.
struct PathLevel {
  Attributes attributes;
  // Set where this level is a bounded aggregate (or CSG that counts as bounded) and the placed
  // object is an unbounded one inside of it: rays that miss the box (in the level's outer space) do
  // not see the object [rayshade4/2 s.8.5].
  std::optional<Bounds> clip;
};

struct Placement {
  std::vector<PathLevel> levels;  // innermost first; at least one
  // Derived by Finish:
  bool plain = true;               // no transforms, textures or clips anywhere
  bool in_place = true;            // no transforms or clips: object space is world space
  SurfaceId surface = kNoSurface;  // innermost bound surface; kNoSurface: the default surface
  void Finish();
};

// A world ray brought into the object's space through all levels, outermost first; direction
// renormalised at each link. *scale: product of the length factors: object distance = scale * world
// distance. False where a clip box is missed.
bool ToObject(const Placement& placement, const ObjectRay& world, double min_distance,
              double max_distance, ObjectRay* object, double* scale);

// The box of an object around which these attributes stand, in the space outside of it; own: its
// box inside. Grown as Rayshade grows boxes [rayshade4/2 s.2.2]. Animated transformations: the
// union over kBoundsMoments moments spread evenly over the interval and both of its ends.
inline constexpr int kBoundsMoments = 100;
Bounds OuterBounds(const Attributes& attributes, const Bounds& own, const ShutterInterval& shutter);

// World bounds of a placed object with these own-space bounds: OuterBounds level by level.
Bounds WorldBounds(const Placement& placement, const Bounds& own, const ShutterInterval& shutter);

}  // namespace rayshade
