// Hits and a light by rows; see hit_rows.h.
#include "rayshade/render/hit_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rayshade/common/check.h"

namespace rayshade {

void HitRows::Set(const Scene& scene, std::span<const Ray> rays,
                  std::span<const SurfaceHit> surfaces, std::span<const uint32_t> owners,
                  std::span<Color> colors) {
  CHECK(surfaces.size() <= kHitRowsSize);
  rays_ = rays;
  surfaces_ = surfaces;
  owners_ = owners;
  colors_ = colors;
  transparent_ = scene.any_transparent;
  shiny_.clear();
  reach_ = 0;
  const bool clear = scene.spec.atmosphere.effects.empty();
  const size_t count = surfaces.size(), end = (count + 7) / 8 * 8;
  for (size_t s = 0; s < end; ++s) {
    const size_t at = std::min(s, count - 1);
    const SurfaceHit& hit = surfaces[at];
    const Surface& surface = hit.surface();
    for (int k = 0; k < 3; ++k) {
      point_[k][s] = hit.point[k];
      normal_[k][s] = hit.normal[k];
      face_[k][s] = hit.face[k];
      diffuse_[k][s] = surface.diffuse[k];
      sum_[k][s] = colors[at][k];
      reach_ = std::max(reach_, std::abs(hit.point[k]));
    }
    const Ray& ray = rays[owners[at]];
    time_[s] = ray.time;
    // A light surely shows where something of its red does: SampleLight need not be asked.
    const bool plain = !hit.smooth && surface.translucency < kEpsilon && !surface.noshadow &&
                       clear && surface.diffuse.r != 0 && ray.contribution.r != 0;
    slack_[s] = plain ? hit.slack : std::numeric_limits<double>::infinity();
    if (s < count && HasHighlight(surface)) shiny_.push_back(static_cast<uint32_t>(s));
  }
}

bool HitRows::Suits(const Scene& scene, const Light& light) {
  return light.position() != nullptr && scene.settings().shadows && !light.noshadow() &&
         light.intensity().r != 0 && scene.settings().light_cutoff == 0 &&
         scene.settings().area_cells == 0;
}

void HitRows::SkipLight() {
  std::fill_n(by_row_, surfaces_.size(), uint8_t{0});
  done_ = 0;
}

void HitRows::Illuminate(const Light& light, const ObjectSet& objects, ShadowTracer* shadows,
                         OpCounts* counts) {
  Aim(*light.position(), objects, counts);
  if (traced_ == 0) return;
  Trace(*light.position(), objects, counts);
  AddByRows(light, objects, shadows, counts);
}

// Where does the light stand, and which hits does it concern?
void HitRows::Aim(const Vector& position, const ObjectSet& objects, OpCounts* counts) {
  const auto count = static_cast<uint32_t>(surfaces_.size());
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
                by_row_,
                blocked_});
  done_ = static_cast<size_t>(std::count(by_row_, by_row_ + count, uint8_t{1}));
  traced_ = static_cast<size_t>(std::count(blocked_, blocked_ + count, uint8_t{0}));
  counts->light_samples += done_;
  counts->shadow_rays += traced_;
}

void HitRows::Trace(const Vector& position, const ObjectSet& objects, OpCounts* counts) {
  const size_t count = surfaces_.size();
  if (transparent_) std::fill_n(crossed_, count, uint8_t{0});
  const double reach =
      std::max({reach_, std::abs(position.x), std::abs(position.y), std::abs(position.z)});
  objects.Block({{point_[0], point_[1], point_[2]},
                 {toward_[0], toward_[1], toward_[2]},
                 distance_,
                 time_,
                 {position.x, position.y, position.z},
                 reach,
                 blocked_,
                 transparent_ ? crossed_ : nullptr,
                 static_cast<uint32_t>(count)},
                counts);
  const auto blocked = static_cast<size_t>(std::count(blocked_, blocked_ + count, uint8_t{1}));
  counts->shadow_hits += blocked - (count - traced_);
}

void HitRows::AddByRows(const Light& light, const ObjectSet& objects, ShadowTracer* shadows,
                        OpCounts* counts) {
  const size_t count = surfaces_.size();
  const Color arrived = light.intensity();
  LightSample sample;
  const auto sample_at = [&](size_t s) {
    sample.toward = {toward_[0][s], toward_[1][s], toward_[2][s]};
    sample.cosine = cosine_[s];
  };
  // What comes through something transparent.
  for (size_t s = 0; transparent_ && s < count; ++s) {
    if (blocked_[s] || !crossed_[s]) continue;
    blocked_[s] = 1;
    sample_at(s);
    Ray shadow;
    MakeShadowRay(rays_[owners_[s]], surfaces_[s], sample.toward, &shadow);
    Color passed = arrived;
    if (shadows->Pass(shadow, distance_[s], &passed, counts)) Add(s, sample, passed);
  }
  objects.AddDiffuse({blocked_,
                      cosine_,
                      {diffuse_[0], diffuse_[1], diffuse_[2]},
                      {arrived.r, arrived.g, arrived.b},
                      {sum_[0], sum_[1], sum_[2]},
                      static_cast<uint32_t>(count)});
  for (const uint32_t s : shiny_) {
    if (blocked_[s]) continue;
    sample_at(s);
    const Color highlight = Highlight(surfaces_[s], sample, arrived);
    for (int c = 0; c < 3; ++c) sum_[c][s] += highlight[c];
  }
}

void HitRows::Add(size_t s, const LightSample& sample, const Color& arrived) {
  Color sum{sum_[0][s], sum_[1][s], sum_[2][s]};
  AddLight(surfaces_[s], sample, arrived, &sum);
  for (int c = 0; c < 3; ++c) sum_[c][s] = sum[c];
}

void HitRows::Finish() {
  for (size_t s = 0; s < surfaces_.size(); ++s) colors_[s] = {sum_[0][s], sum_[1][s], sum_[2][s]};
}

}  // namespace rayshade
