// Transmitted and reflected rays [rayshade4/3 s.5.1, 5.3, 5.4].
#include <algorithm>
#include <cmath>

#include "rayshade/common/keyed_random.h"
#include "rayshade/shade/shade.h"

namespace rayshade {
namespace {

bool AnyAbove(const Color& color, const Color& limit) {
  return color.r > limit.r || color.g > limit.g || color.b > limit.b;
}

bool AnyAbove(const Color& color, double limit) { return AnyAbove(color, {limit, limit, limit}); }

// Appends a ray that goes on from the hit. innermost: one more medium, or null.
void Append(const Ray& ray, const SurfaceHit& hit, const Vector& direction,
            const Color& contribution, RayKind kind, std::span<const Medium> media,
            const Medium* innermost, RayBundle* bundle) {
  Ray& next = bundle->rays.emplace_back(ray);
  next.origin = hit.point;
  next.direction = direction;
  next.min_distance = LeastDistance(hit, direction, kEpsilon);
  next.contribution = contribution;
  next.key = PathKey(ray.key, kind == RayKind::kRefracted);
  next.media_begin = static_cast<uint32_t>(bundle->media.size());
  next.media_count = static_cast<uint16_t>(media.size() + (innermost != nullptr ? 1 : 0));
  next.depth = static_cast<uint16_t>(ray.depth + 1);
  next.kind = kind;
  if (!media.empty()) bundle->media.insert(bundle->media.end(), media.begin(), media.end());
  if (innermost != nullptr) bundle->media.push_back(*innermost);
}

// Appends the transmitted ray; false where it is reflected totally.
bool Transmit(const Scene& scene, const Ray& ray, std::span<const Medium> media,
              const SurfaceHit& hit, const Color& contribution, double* extinct,
              RayBundle* transmitted) {
  // The media before and behind the surface.
  const Surface& surface = hit.surface();
  const double top = scene.spec.atmosphere.index;
  const Medium inside{surface.index, surface.extinct};
  double n1, n2;
  if (hit.entering) {
    n1 = media.empty() ? top : media.back().index;
    n2 = inside.index;
    *extinct = inside.extinct;
  } else {
    if (!media.empty()) media = media.first(media.size() - 1);
    n1 = inside.index;
    n2 = media.empty() ? top : media.back().index;
    *extinct = media.empty() ? 1 : media.back().extinct;
  }

  // Snell's law.
  const bool away = hit.facing < 0;
  const double c1 = away ? -hit.facing : hit.facing;
  const Vector normal = away ? -hit.normal : hit.normal;
  const double eta = n1 / n2;
  const double c2 = 1 - eta * eta * (1 - c1 * c1);
  if (c2 < 0) return false;
  const Vector direction = eta * ray.direction + (eta * c1 - std::sqrt(c2)) * normal;
  Append(ray, hit, direction, contribution, RayKind::kRefracted, media,
         hit.entering ? &inside : nullptr, transmitted);
  return true;
}

}  // namespace

void SpawnSecondary(const Scene& scene, const Ray& ray, std::span<const Medium> media,
                    const SurfaceHit& hit, RayBundle* transmitted, RayBundle* reflected,
                    Secondary* secondary) {
  secondary->transmitted.wanted = false;
  secondary->reflected.wanted = false;
  const Settings& settings = scene.settings();
  if (ray.depth >= settings.max_depth) return;
  const Surface& surface = hit.surface();
  Color reflection = surface.reflect * surface.specular;
  if (surface.transp > kEpsilon) {
    const Color weight = surface.transp * surface.body;
    const Color contribution = weight * ray.contribution;
    if (AnyAbove(contribution, settings.cutoff)) {
      SecondaryRay& way = secondary->transmitted;
      if (Transmit(scene, ray, media, hit, contribution, &way.extinct, transmitted)) {
        way.wanted = true;
        way.weight = weight;
      } else {
        reflection = reflection + weight;
      }
    }
  }
  if (AnyAbove(reflection, kEpsilon)) {
    const Color contribution = reflection * ray.contribution;
    if (AnyAbove(contribution, settings.cutoff)) {
      SecondaryRay& way = secondary->reflected;
      way.wanted = true;
      way.weight = reflection;
      way.extinct = 1;
      Append(ray, hit, hit.mirror, contribution, RayKind::kReflected, media, nullptr, reflected);
    }
  }
}

}  // namespace rayshade
