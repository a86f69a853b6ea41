// Rows of hits; see point_light_rows.h.
#include "rayshade/shade/point_light_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rayshade/common/check.h"

namespace rayshade {

// Fewer do not make up for the work of ordering.
constexpr size_t kLightsToOrderFor = 4;

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
  order_.Set(surfaces, scene.lights.size() >= kLightsToOrderFor);
  const size_t end = (count_ + 7) / 8 * 8;
  for (size_t row = 0; row < end; ++row) {
    const size_t at = order_.hit(std::min(row, count_ - 1));
    const SurfaceHit& hit = surfaces[at];
    const Surface& surface = hit.surface();
    for (int k = 0; k < 3; ++k) {
      point_[k][row] = hit.point[k];
      normal_[k][row] = hit.normal[k];
      face_[k][row] = hit.face[k];
      reach_ = std::max(reach_, std::abs(hit.point[k]));
    }
    const Ray& ray = rays[owners[at]];
    time_[row] = ray.time;
    // A light surely shows where something of its red does: SampleLight need not be asked.
    const bool plain = !hit.smooth && surface.translucency < kEpsilon && !surface.noshadow &&
                       clear && surface.diffuse.r != 0 && ray.contribution.r != 0;
    slack_[row] = plain ? hit.slack : std::numeric_limits<double>::infinity();
  }
}

size_t PointLightRows::CountOf(const uint8_t* flags) const {
  static_assert(kMost / 8 < 256);
  uint64_t sums = 0;  // eight of them
  for (size_t row = 0; row < count_; row += 8) sums += EightOf(flags, row);
  const uint64_t pairs = (sums & 0x00ff00ff00ff00ff) + (sums >> 8 & 0x00ff00ff00ff00ff);
  return pairs * 0x0001000100010001 >> 48;
}

void PointLightRows::Clear() {
  std::fill_n(done_, count_, uint8_t{0});
  done_count_ = 0;
}

// Where does the light stand, and which hits does it concern?
void PointLightRows::Aim(const Vector& position, const ObjectSet& objects) {
  const auto count = static_cast<uint32_t>(count_);
  objects.Aim({{point_[0], point_[1], point_[2]},
               {normal_[0], normal_[1], normal_[2]},
               count,
               {position.x, position.y, position.z},
               {toward_[0], toward_[1], toward_[2]},
               distance_,
               cosine_});
  objects.Sort({{toward_[0], toward_[1], toward_[2]},
                cosine_,
                {face_[0], face_[1], face_[2]},
                slack_,
                count,
                done_,
                blocked_});
}

void PointLightRows::Trace(const Scene& scene, const ObjectSet& objects, const Light& light,
                           OpCounts* counts) {
  Aim(*light.position(), objects);
  done_count_ = CountOf(done_);
  const size_t traced = count_ - CountOf(blocked_);
  counts->light_samples += done_count_;
  counts->shadow_rays += traced;
  std::fill_n(crossed_, count_, uint8_t{0});
  if (traced == 0) return;
  ShadowRows rays = shadow_rays(light);
  if (!scene.any_transparent) rays.crossed = nullptr;
  objects.Block(rays, counts);
  counts->shadow_hits += CountOf(blocked_) - (count_ - traced);
}

ShadowRows PointLightRows::shadow_rays(const Light& light) {
  const Vector& at = *light.position();
  return {{point_[0], point_[1], point_[2]},
          {toward_[0], toward_[1], toward_[2]},
          distance_,
          time_,
          {at.x, at.y, at.z},
          std::max({reach_, std::abs(at.x), std::abs(at.y), std::abs(at.z)}),
          blocked_,
          crossed_,
          static_cast<uint32_t>(count_)};
}

LightSample PointLightRows::Sample(const Light& light, uint32_t number, size_t s) const {
  const size_t row = order_.row(s);
  LightSample sample;
  sample.toward = {toward_[0][row], toward_[1][row], toward_[2][row]};
  sample.cosine = cosine_[row];
  sample.limit = distance_[row];
  sample.color = light.intensity();
  sample.light = number;
  return sample;
}

}  // namespace rayshade
