// What the lights do to a hit [rayshade4/3 s.5.2, 6, 7].
#include <cmath>

#include "rayshade/common/check.h"
#include "rayshade/shade/shade.h"

namespace rayshade {
namespace {

constexpr Color kBlack;

}  // namespace

bool SampleLight(const Scene& scene, uint32_t light_number, const Ray& ray, const SurfaceHit& hit,
                 LightSample* sample, Ray* shadow, OpCounts* counts) {
  ++counts->light_samples;
  const Light& light = *scene.lights[light_number];
  const LightKey key{ray.key, light_number, ray.sample_number, scene.settings().samples};
  const LightDirection direction = light.Toward(hit.point, key);

  // On which side of the surface does it stand?
  double cosine = Dot(direction.toward, hit.normal);
  if (hit.smooth && cosine <= 0) {
    const double geometric = Dot(direction.toward, hit.geometric_normal);
    if (geometric > 0) cosine = geometric;
  }
  const Surface& surface = hit.surface();
  if (!(cosine > 0) && surface.translucency < kEpsilon) return false;

  // What would arrive?
  const std::optional<LightArrival> arrival = light.Arrive(hit.point, direction, key);
  if (!arrival) return false;
  sample->toward = direction.toward;
  sample->cosine = cosine;
  sample->limit = arrival->shadow_distance;
  sample->color = arrival->color;
  sample->light = light_number;
  sample->traced = scene.settings().shadows && !light.noshadow() && !surface.noshadow;

  shadow->origin = hit.point;
  shadow->direction = arrival->shadow_direction;
  shadow->min_distance = LeastDistance(hit, arrival->shadow_direction, kShadowEpsilon);
  shadow->time = ray.time;
  shadow->key = ray.key;
  shadow->sample_number = ray.sample_number;
  shadow->media_begin = 0;
  shadow->media_count = 0;
  shadow->depth = ray.depth;
  shadow->kind = RayKind::kShadow;
  if (sample->traced) ++counts->shadow_rays;
  return true;
}

void SpawnShadows(const Scene& scene, const Ray& ray, const SurfaceHit& hit,
                  std::vector<ShadowRay>* shadows, OpCounts* counts) {
  for (uint32_t light = 0; light < scene.lights.size(); ++light) {
    ShadowRay shadow;
    if (SampleLight(scene, light, ray, hit, &shadow, &shadow.ray, counts)) {
      shadows->push_back(shadow);
    }
  }
}

void AddLight(const SurfaceHit& hit, const LightSample& sample, const Color& arrived, Color* sum) {
  const Surface& surface = hit.surface();
  const double c = sample.cosine;
  if (c > 0) {
    *sum += c * surface.diffuse * arrived;
    if (surface.specpow >= kEpsilon && surface.specular != kBlack) {
      const double a = Dot(hit.mirror, sample.toward);
      if (a > 0) *sum += std::pow(a, surface.specpow) * surface.specular * arrived;
    }
    return;
  }
  *sum += -c * surface.translucent * arrived;
  if (surface.translucent_pow >= kEpsilon && surface.body != kBlack) {
    const double a = -Dot(hit.mirror, sample.toward);
    if (a > 0) *sum += std::pow(a, surface.translucent_pow) * surface.body * arrived;
  }
  *sum = surface.translucency * *sum;
}

Color ShadeLights(const Scene& scene, const Ray&, const SurfaceHit& hit,
                  std::span<const ShadowRay> shadows, std::span<const uint8_t> arrived) {
  CHECK(shadows.size() == arrived.size());
  Color sum = ShadeAmbient(scene, hit);
  for (size_t i = 0; i < shadows.size(); ++i) {
    if (arrived[i]) AddLight(hit, shadows[i], shadows[i].color, &sum);
  }
  return sum;
}

}  // namespace rayshade
