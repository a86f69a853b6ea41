// Adding up by rows; see hit_rows.h.
#include "rayshade/render/hit_rows.h"

#include <algorithm>

namespace rayshade {

void HitRows::Set(const Scene& scene, std::span<const Ray> rays,
                  std::span<const SurfaceHit> surfaces, std::span<const uint32_t> owners,
                  std::span<Color> colors) {
  PointLightRows::Set(scene, rays, surfaces, owners);
  rays_ = rays;
  surfaces_ = surfaces;
  owners_ = owners;
  colors_ = colors;
  shiny_.clear();
  const size_t end = (count_ + 7) / 8 * 8;
  for (size_t s = 0; s < end; ++s) {
    const size_t at = std::min(s, count_ - 1);
    const Surface& surface = surfaces[at].surface();
    for (int k = 0; k < 3; ++k) {
      diffuse_[k][s] = surface.diffuse[k];
      sum_[k][s] = colors[at][k];
    }
    if (s < count_ && HasHighlight(surface)) shiny_.push_back(static_cast<uint32_t>(s));
  }
}

// What is added goes out of the rows.
void HitRows::AddThroughTransparent(const Light& light, ShadowTracer* shadows, OpCounts* counts) {
  for (size_t s = 0; s < count_; ++s) {
    if (blocked_[s] || !crossed_[s]) continue;
    blocked_[s] = 1;
    LightSample sample = Sample(light, 0, s);
    Ray shadow;
    MakeShadowRay(rays_[owners_[s]], surfaces_[s], sample.toward, &shadow);
    if (shadows->Pass(shadow, sample.limit, &sample.color, counts)) Add(s, sample, sample.color);
  }
}

void HitRows::Illuminate(const Scene& scene, const ObjectSet& objects, const Light& light,
                         ShadowTracer* shadows, OpCounts* counts) {
  Trace(scene, objects, light, counts);
  if (scene.any_transparent) AddThroughTransparent(light, shadows, counts);
  const Color arrived = light.intensity();
  objects.AddDiffuse({blocked_,
                      cosine_,
                      {diffuse_[0], diffuse_[1], diffuse_[2]},
                      {arrived.r, arrived.g, arrived.b},
                      {sum_[0], sum_[1], sum_[2]},
                      static_cast<uint32_t>(count_)});
  for (const uint32_t s : shiny_) {
    if (blocked_[s]) continue;
    const Color highlight = Highlight(surfaces_[s], Sample(light, 0, s), arrived);
    for (int c = 0; c < 3; ++c) sum_[c][s] += highlight[c];
  }
}

void HitRows::Add(size_t s, const LightSample& sample, const Color& arrived) {
  Color sum{sum_[0][s], sum_[1][s], sum_[2][s]};
  AddLight(surfaces_[s], sample, arrived, &sum);
  for (int c = 0; c < 3; ++c) sum_[c][s] = sum[c];
}

void HitRows::Finish() {
  for (size_t s = 0; s < count_; ++s) colors_[s] = {sum_[0][s], sum_[1][s], sum_[2][s]};
}

}  // namespace rayshade
