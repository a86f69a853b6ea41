// Rows of hits; see point_light_rows.h.
#include "rayshade/shade/point_light_rows.h"

#include <algorithm>
#include <cmath>

#include "rayshade/common/check.h"

namespace rayshade {

bool PointLightRows::Suit(const Scene& scene, const Light& light) {
  const Settings& settings = scene.settings();
  return light.position() != nullptr && settings.shadows && !light.noshadow() &&
         light.intensity().r != 0 && settings.light_cutoff == 0 && settings.area_cells == 0;
}

void PointLightRows::Set(const Scene& scene, std::span<const Ray> rays,
                         std::span<const SurfaceHit> surfaces, std::span<const uint32_t> owners) {
  const bool clear = scene.spec.atmosphere.effects.empty();
  reach_ = 0;
  count_ = surfaces.size();
  CHECK(count_ <= kMost);
  const size_t end = (count_ + 7) / 8 * 8;
  for (size_t s = 0; s < end; ++s) {
    const size_t hit_number = std::min(s, count_ - 1);
    const SurfaceHit& hit = surfaces[hit_number];
    const Surface& surface = hit.surface();
    for (int axis = 0; axis < 3; ++axis) {
      point_[axis][s] = hit.point[axis];
      normal_[axis][s] = hit.normal[axis];
      reach_ = std::max(reach_, std::abs(hit.point[axis]));
    }
    const Ray& ray = rays[owners[hit_number]];
    time_[s] = ray.time;
    // A light surely shows where something of its red does: SampleLight need not be asked.
    plain_[s] = !hit.smooth && surface.translucency < kEpsilon && !surface.noshadow && clear &&
                surface.diffuse.r != 0 && ray.contribution.r != 0;
  }
}

void PointLightRows::Clear() {
  std::fill_n(done_, count_, uint8_t{0});
  all_done_ = false;
}

void PointLightRows::Trace(const Scene& scene, const ObjectSet& objects, const Light& light,
                           std::span<const SurfaceHit> surfaces, OpCounts* counts) {
  const Vector& at = *light.position();
  const auto size = static_cast<uint32_t>(count_);
  objects.Aim({{point_[0], point_[1], point_[2]},
               {normal_[0], normal_[1], normal_[2]},
               size,
               {at.x, at.y, at.z},
               {toward_[0], toward_[1], toward_[2]},
               distance_,
               cosine_});
  size_t plain = 0, traced = 0;
  for (size_t s = 0; s < count_; ++s) {
    const Vector toward{toward_[0][s], toward_[1][s], toward_[2][s]};
    done_[s] = plain_[s] && LeastDistance(surfaces[s], toward, kShadowEpsilon) == kShadowEpsilon;
    const bool wanted = done_[s] && cosine_[s] > 0;
    plain += done_[s];
    traced += wanted;
    blocked_[s] = !wanted;
    crossed_[s] = 0;
  }
  all_done_ = plain == count_;
  counts->light_samples += plain;
  counts->shadow_rays += traced;
  if (traced == 0) return;
  const double reach = std::max({reach_, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
  objects.Block({{point_[0], point_[1], point_[2]},
                 {toward_[0], toward_[1], toward_[2]},
                 distance_,
                 time_,
                 {at.x, at.y, at.z},
                 reach,
                 blocked_,
                 scene.any_transparent ? crossed_ : nullptr,
                 size},
                counts);
  counts->shadow_hits += std::count(blocked_, blocked_ + count_, 1) - (count_ - traced);
}

void PointLightRows::Sample(const Light& light, uint32_t number, size_t s,
                            LightSample* sample) const {
  sample->toward = {toward_[0][s], toward_[1][s], toward_[2][s]};
  sample->cosine = cosine_[s];
  sample->limit = distance_[s];
  sample->color = light.intensity();
  sample->light = number;
  sample->traced = true;
}

}  // namespace rayshade
