// Shading, cut where the paper cuts it [RJ s.2]: a hit spawns rays; when their results are
// completed, it is shaded. The sequential tracer does this by recursion, the trace processes by
// messages, both through the functions below.
//
//   ResolveHit      hit → point, normals, textured surface
//   SampleLight     what a light does to the hit, and the shadow ray that asks whether it arrives
//   AddLight        folds the lights in visiting order, once all shadow results are there
//   SpawnSecondary  at most one transmitted and one reflected ray; total reflection, depth limit
//                   and cutoff are decided here, before anything is traced
//   Shade           folds the secondary results (transmitted, then reflected) and the atmosphere
//
//   1. All are pure functions of their arguments; none traces a ray.
//   2. Folding is by slot, never by order of arrival.
//   3. What a shadow ray goes through on its way is in shade/crossing.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/common/ray.h"
#include "rayshade/scene/scene.h"
#include "rayshade/shade/ray_result.h"

namespace rayshade {

// A hit in world space, ready for shading [rayshade4/2 s.2.5, rayshade4/3 s.4]. Stays in the
// process that has the scene: it points into it.
struct SurfaceHit {
  Vector point;
  Vector normal;            // N: shading normal, after textures
  Vector geometric_normal;  // smooth, textured and transformed: still in primitive space
  double facing;            // k = -(I . N) of the ray's direction I; may be negative after textures
  Vector mirror;            // R = I + 2 k N, not normalised
  Vector face;              // normal of the surface itself, world space; zero where faces meet
  double slack;             // the point lies within this distance of the surface
  bool smooth;
  bool entering;
  bool textured;         // `own` holds the surface; it is not set otherwise
  double bound_transp;   // transp of the surface before textures: shadows ask for that one
  const Surface* bound;  // in the scene
  Surface own;

  const Surface& surface() const { return textured ? own : *bound; }
};

// REQUIRES: hit.found() and hit.set != nullptr. path: scratch, so that hits in a row share one.
void ResolveHit(const Scene& scene, const Ray& ray, const Hit& hit, HitPath* path,
                SurfaceHit* resolved);
void ResolveHit(const Scene& scene, const Ray& ray, const Hit& hit, SurfaceHit* resolved);

// Where hits of a ray that leaves the point in this direction begin to count: at epsilon
// (Rayshade's own rule), or where that is farther, beyond the last point at which rounding could
// let the ray meet the surface that it leaves (shade/slack.h).
inline double LeastDistance(const SurfaceHit& hit, const Vector& direction, double epsilon) {
  constexpr double kGrazing = 1e-8;
  const double cosine = std::abs(Dot(direction, hit.face));
  return hit.slack > epsilon * cosine ? std::max(epsilon, hit.slack / std::max(cosine, kGrazing))
                                      : epsilon;
}

// What one light does to a hit if nothing is in its way.
struct LightSample {
  Vector toward;       // L, for highlights
  double cosine = 0;   // L . N, or the one that counts in its place
  double limit = 0;    // nothing at or beyond this distance matters
  Color color;         // what arrives unless something is in between
  uint32_t light = 0;  // in visiting order
  bool traced = true;  // false: no shadows here (noshadow, -n): the colour arrives
};

// The same with its shadow ray: kind kShadow, min_distance at least kShadowEpsilon.
struct ShadowRay : LightSample {
  Ray ray;
};

// The shadow ray of a hit of `ray`.
void MakeShadowRay(const Ray& ray, const SurfaceHit& hit, const Vector& direction, Ray* shadow);
// One light; false where it does not concern the hit. Sets *shadow too, also where it is not
// traced.
bool SampleLight(const Scene& scene, uint32_t light, const Ray& ray, const SurfaceHit& hit,
                 LightSample* sample, Ray* shadow, OpCounts* counts);

inline Color ShadeAmbient(const Scene& scene, const SurfaceHit& hit) {
  return hit.surface().ambient * scene.settings().ambient_light;
}
bool HasHighlight(const Surface& surface);
// The highlight of a light before a surface that has them.
Color Highlight(const SurfaceHit& hit, const LightSample& sample, const Color& arrived);
// Adds to *sum a light of which `arrived` arrives. Lights that are blocked are left out altogether:
// they do not even scale by translucency.
void AddLight(const SurfaceHit& hit, const LightSample& sample, const Color& arrived, Color* sum);
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
// them); the two bundles may be the same one. Of *secondary, only `wanted` is set where a ray is
// not.
void SpawnSecondary(const Scene& scene, const Ray& ray, std::span<const Medium> media,
                    const SurfaceHit& hit, RayBundle* transmitted, RayBundle* reflected,
                    Secondary* secondary);
inline Secondary SpawnSecondary(const Scene& scene, const Ray& ray, std::span<const Medium> media,
                                const SurfaceHit& hit, RayBundle* transmitted,
                                RayBundle* reflected) {
  Secondary secondary;
  SpawnSecondary(scene, ray, media, hit, transmitted, reflected, &secondary);
  return secondary;
}

// What arrives at the hit of a secondary ray's result: the weight first, then what the medium
// leaves.
inline Color Weighted(const SecondaryRay& way, const RayResult& result) {
  const Color color = way.weight * result.color;
  return way.extinct == 1 ? color : std::pow(std::max(way.extinct, 0.0), result.distance) * color;
}
// What the air does to a ray's colour. in_air: the ray's medium stack is empty.
inline Color ThroughAir(const Scene& scene, const Ray& ray, bool in_air, double distance,
                        const Color& color) {
  const Atmosphere& air = scene.spec.atmosphere;
  if (!in_air || air.effects.empty()) return color;
  return air.Apply(ray.origin, ray.direction, distance, color);
}

// The result of a hit of which everything is folded.
inline RayResult Folded(const Scene& scene, const Ray& ray, bool in_air, double distance,
                        const Color& color) {
  return {Bounded(ThroughAir(scene, ray, in_air, distance, color)), distance, true};
}
// The last steps. lights: ambient light and what AddLight added.
inline RayResult Shade(const Scene& scene, const Ray& ray, bool in_air, double distance,
                       const Color& lights, const Secondary& secondary,
                       const RayResult& transmitted, const RayResult& reflected) {
  Color color = lights;
  if (secondary.transmitted.wanted) color += Weighted(secondary.transmitted, transmitted);
  if (secondary.reflected.wanted) color += Weighted(secondary.reflected, reflected);
  return Folded(scene, ray, in_air, distance, color);
}
// The result of a ray that hits nothing: background and atmosphere.
inline RayResult ShadeMiss(const Scene& scene, const Ray& ray, bool in_air) {
  const Color& background = scene.settings().background;
  return {Bounded(ThroughAir(scene, ray, in_air, kFar, background)), kFar, false};
}

}  // namespace rayshade
