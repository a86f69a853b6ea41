// Shading, cut where the paper cuts it [RJ s.2]: a hit spawns rays; when their results are
// completed, it is shaded. The sequential tracer does this by recursion, the trace processes by
// messages, both through the functions below.
//
//   ResolveHit      hit → point, normals, textured surface
//   SpawnShadows    which shadow rays the hit wants, one for each light at most
//   ShadeLights     folds the lights in visiting order, once all shadow results are there
//   SpawnSecondary  at most one transmitted and one reflected ray; total reflection, depth limit
//   and cutoff are
//                   decided here, before anything is traced
//   Shade           folds the secondary results (transmitted, then reflected) and the atmosphere
//
//   1. All are pure functions of their arguments; none traces a ray.
//   2. Folding is by slot, never by order of arrival.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/common/ray.h"
#include "rayshade/scene/scene.h"
#include "rayshade/shade/ray_result.h"

namespace rayshade {

// A hit in world space, ready for shading [rayshade4/2 s.2.5, rayshade4/3 s.4].
struct SurfaceHit {
  Vector point;
  Vector normal;  // shading normal, after textures
  Vector geometric_normal;
  bool smooth = false;
  bool entering = true;
  Surface surface;  // after textures
};

// REQUIRES: hit.found() and hit.set != nullptr.
void ResolveHit(const Scene& scene, const Ray& ray, const Hit& hit, SurfaceHit* resolved);

// One shadow ray that a hit wants, and what arrives if nothing is in its way.
struct ShadowRay {
  Ray ray;             // kind kShadow, min_distance kShadowEpsilon
  double limit = 0;    // nothing at or beyond this distance matters
  Color color;         // what arrives unless something is in between
  uint32_t light = 0;  // in visiting order
  bool traced = true;  // false: no shadows here (noshadow, -n): the colour arrives
};

// Appends the shadow rays of a hit, in visiting order of the lights.
void SpawnShadows(const Scene& scene, const Ray& ray, const SurfaceHit& hit,
                  std::vector<ShadowRay>* shadows, OpCounts* counts);

// Ambient light and all lights. shadows: as SpawnShadows gave them for this hit, with color
// replaced by what really arrives (black, and arrived[i] 0, where the light is blocked: a blocked
// light does not even scale by translucency).
Color ShadeLights(const Scene& scene, const Ray& ray, const SurfaceHit& hit,
                  std::span<const ShadowRay> shadows, std::span<const uint8_t> arrived);

// What a shadow ray has met so far; folded in order along the ray [rayshade4/3 s.7].
struct ShadowState {
  Color color{1, 1, 1};         // what is left of the light, intensity included
  double last_distance = 0;     // t0: where the last transparent hit lay, plus kEpsilon
  double previous_extinct = 1;  // of the medium the ray is in; 1: none
  bool inside = false;
  bool dark = false;
};
// Folds one transparent hit (bound surface with transp >= kEpsilon) into *state. shadow: the ray.
void FoldShadowHit(const Scene& scene, const Ray& shadow, const Hit& hit, ShadowState* state);

// The secondary rays of a hit, and how their results are weighted.
struct SecondaryRay {
  bool wanted = false;
  Color weight;
  double extinct = 1;  // result is multiplied by extinct^distance
};
struct Secondary {
  SecondaryRay transmitted, reflected;
};
// media: of the ray, outermost first. Wanted rays are appended to the bundles (their media with
// them); the two bundles may be the same one.
Secondary SpawnSecondary(const Scene& scene, const Ray& ray, std::span<const Medium> media,
                         const SurfaceHit& hit, RayBundle* transmitted, RayBundle* reflected);

// The last step. lights: what ShadeLights gave. in_air: the ray's medium stack is empty.
RayResult Shade(const Scene& scene, const Ray& ray, bool in_air, double distance,
                const Color& lights, const Secondary& secondary, const RayResult& transmitted,
                const RayResult& reflected);
// The result of a ray that hits nothing: background and atmosphere.
RayResult ShadeMiss(const Scene& scene, const Ray& ray, bool in_air);

}  // namespace rayshade
