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
  for (size_t row = 0; row < end; ++row) {
    const size_t at = order_.hit(std::min(row, count_ - 1));
    const Surface& surface = surfaces[at].surface();
    for (int k = 0; k < 3; ++k) {
      diffuse_[k][row] = surface.diffuse[k];
      sum_[k][row] = colors[at][k];
    }
    if (row < count_ && HasHighlight(surface)) shiny_.push_back(static_cast<uint32_t>(row));
  }
}

// What is added goes out of the rows.
void HitRows::AddThroughTransparent(const Light& light, ShadowTracer* shadows, OpCounts* counts) {
  for (size_t row = 0; row < count_; ++row) {
    if (blocked_[row] || !crossed_[row]) continue;
    blocked_[row] = 1;
    const size_t s = order_.hit(row);
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
  for (const uint32_t row : shiny_) {
    if (blocked_[row]) continue;
    const size_t s = order_.hit(row);
    const Color highlight = Highlight(surfaces_[s], Sample(light, 0, s), arrived);
    for (int c = 0; c < 3; ++c) sum_[c][row] += highlight[c];
  }
}

void HitRows::Add(size_t s, const LightSample& sample, const Color& arrived) {
  const size_t row = order_.row(s);
  Color sum{sum_[0][row], sum_[1][row], sum_[2][row]};
  AddLight(surfaces_[s], sample, arrived, &sum);
  for (int c = 0; c < 3; ++c) sum_[c][row] = sum[c];
}

void HitRows::Finish() {
  for (size_t s = 0; s < count_; ++s) {
    const size_t row = order_.row(s);
    colors_[s] = {sum_[0][row], sum_[1][row], sum_[2][row]};
  }
}

}  // namespace rayshade
