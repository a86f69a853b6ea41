// The last step: secondary results and the air [rayshade4/3 s.5.1, 5.4, 8].
#include "rayshade/shade/shade.h"

#include <cmath>

namespace rayshade {
namespace {

// The weight first, then what the medium leaves.
Color Weighted(const SecondaryRay& way, const RayResult& result) {
  const Color color = way.weight * result.color;
  return way.extinct == 1 ? color : std::pow(way.extinct, result.distance) * color;
}

Color ThroughAir(const Scene& scene, const Ray& ray, bool in_air, double distance,
                 const Color& color) {
  const Atmosphere& atmosphere = scene.spec.atmosphere;
  if (!in_air || atmosphere.effects.empty()) return color;
  return atmosphere.Apply(ray.origin, ray.direction, distance, color);
}

}  // namespace

RayResult Shade(const Scene& scene, const Ray& ray, bool in_air, double distance,
                const Color& lights, const Secondary& secondary, const RayResult& transmitted,
                const RayResult& reflected) {
  Color color = lights;
  if (secondary.transmitted.wanted) color += Weighted(secondary.transmitted, transmitted);
  if (secondary.reflected.wanted) color += Weighted(secondary.reflected, reflected);
  return {ThroughAir(scene, ray, in_air, distance, color), distance, true};
}

RayResult ShadeMiss(const Scene& scene, const Ray& ray, bool in_air) {
  return {ThroughAir(scene, ray, in_air, kFar, scene.settings().background), kFar, false};
}

}  // namespace rayshade
