// What the lights do to a hit [rayshade4/3 s.5.2, 6, 7].
#include <algorithm>
#include <cmath>

#include "rayshade/common/check.h"
#include "rayshade/shade/shade.h"

namespace rayshade {
namespace {

constexpr Color kBlack;

// Whether fog leaves nothing of the hit's colour in any channel. The way is taken a little shorter
// than it is: rounding must not decide.
bool HiddenByFog(const Scene& scene, const Ray& ray, const SurfaceHit& hit) {
  const Atmosphere& air = scene.spec.atmosphere;
  if (air.effects.empty() || ray.media_count > 0) return false;
  const double squared = Dot(ray.direction, ray.direction);
  return air.Hides(.99 * Dot(hit.point - ray.origin, ray.direction) / squared);
}

// Whether a light before the surface cannot change the picture, whatever is in its way: in each
// channel the light is dark, or the surface takes nothing of it, or the path to the eye lets
// nothing pass; or fog hides the hit. All of these are factors of exactly 0, and what they are
// multiplied with is finite.
bool CannotShow(const Scene& scene, const Ray& ray, const SurfaceHit& hit,
                const LightSample& sample) {
  if (!(sample.cosine > 0) || !scene.finite) return false;
  const Surface& surface = hit.surface();
  const auto passes = [&](int c) { return ray.contribution[c] != 0 && sample.color[c] != 0; };
  const bool fog = HiddenByFog(scene, ray, hit);
  if (!fog && passes(0) && surface.diffuse.r != 0) return false;  // nearly always

  const bool has_highlight = surface.specpow >= kEpsilon && surface.specular != kBlack;
  const double a = has_highlight ? Dot(hit.mirror, sample.toward) : 0;
  if (a > 1 + kEpsilon)
    return false;  // a mirror direction that is not normalised: any power may come of it
  if (fog) return true;
  for (int c = 0; c < 3; ++c) {
    const bool takes = surface.diffuse[c] != 0 || (a > 0 && surface.specular[c] != 0);
    if (takes && passes(c)) return false;
  }
  return true;
}

// The most that a light before the surface can add to a channel of the ray's sample.
double MostAdded(const Ray& ray, const SurfaceHit& hit, const LightSample& sample) {
  const Surface& surface = hit.surface();
  const bool has_highlight = surface.specpow >= kEpsilon && Dot(hit.mirror, sample.toward) > 0;
  double most = 0;
  for (int c = 0; c < 3; ++c) {
    const double taken = sample.cosine * surface.diffuse[c] + has_highlight * surface.specular[c];
    most = std::max(most, ray.contribution[c] * sample.color[c] * taken);
  }
  return most;
}

}  // namespace

void MakeShadowRay(const Ray& ray, const SurfaceHit& hit, const Vector& direction, Ray* shadow) {
  shadow->origin = hit.point;
  shadow->direction = direction;
  shadow->min_distance = LeastDistance(hit, direction, kShadowEpsilon);
  shadow->time = ray.time;
  shadow->key = ray.key;
  shadow->sample_number = ray.sample_number;
  shadow->media_begin = 0;
  shadow->media_count = 0;
  shadow->depth = ray.depth;
  shadow->kind = RayKind::kShadow;
}

bool SampleLight(const Scene& scene, uint32_t light_number, const Ray& ray, const SurfaceHit& hit,
                 LightSample* sample, Ray* shadow, OpCounts* counts) {
  ++counts->light_samples;
  const Light& light = *scene.lights[light_number];
  const Settings& settings = scene.settings();
  const Surface& surface = hit.surface();
  const bool opaque = surface.translucency < kEpsilon;
  const LightKey key{ray.key, light_number, ray.sample_number, settings.samples,
                     settings.area_cells};
  // Each light behind a translucent surface scales what was gathered before: none may stand for
  // others.
  const double share = settings.area_cells > 0 && opaque ? light.Share(key) : 1;
  if (share == 0) return false;
  const LightDirection direction = light.Toward(hit.point, key);

  // On which side of the surface does it stand?
  double cosine = Dot(direction.toward, hit.normal);
  if (hit.smooth && cosine <= 0) {
    const double geometric = Dot(direction.toward, hit.geometric_normal);
    if (geometric > 0) cosine = geometric;
  }
  if (!(cosine > 0) && opaque) return false;

  // What would arrive?
  const std::optional<LightArrival> arrival = light.Arrive(hit.point, direction, key);
  if (!arrival) return false;
  sample->toward = direction.toward;
  sample->cosine = cosine;
  sample->limit = arrival->shadow_distance;
  sample->color = share * arrival->color;
  sample->light = light_number;
  sample->traced = settings.shadows && !light.noshadow() && !surface.noshadow;
  if (sample->traced && settings.light_cutoff > 0 && cosine > 0) {
    sample->traced = MostAdded(ray, hit, *sample) >= settings.light_cutoff;
  }
  if (sample->traced) ++counts->shadow_rays;
  if (sample->traced && CannotShow(scene, ray, hit, *sample)) {
    ++counts->rays_saved;
    return false;
  }

  MakeShadowRay(ray, hit, arrival->shadow_direction, shadow);
  return true;
}

bool HasHighlight(const Surface& surface) {
  return surface.specpow >= kEpsilon && surface.specular != kBlack;
}

Color Highlight(const SurfaceHit& hit, const LightSample& sample, const Color& arrived) {
  const Surface& surface = hit.surface();
  const double a = Dot(hit.mirror, sample.toward);
  return a > 0 ? std::pow(a, surface.specpow) * surface.specular * arrived : kBlack;
}

void AddLight(const SurfaceHit& hit, const LightSample& sample, const Color& arrived, Color* sum) {
  const Surface& surface = hit.surface();
  const double c = sample.cosine;
  if (c > 0) {
    *sum += c * surface.diffuse * arrived;
    if (HasHighlight(surface)) *sum += Highlight(hit, sample, arrived);
    return;
  }
  *sum += -c * surface.translucent * arrived;
  if (surface.translucent_pow >= kEpsilon && surface.body != kBlack) {
    const double a = -Dot(hit.mirror, sample.toward);
    if (a > 0) *sum += std::pow(a, surface.translucent_pow) * surface.body * arrived;
  }
  *sum = surface.translucency * *sum;
}

}  // namespace rayshade
