// Adding up by rows; see hit_rows.h.
#include "rayshade/shade/hit_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayshade {

// A highlight is cosine^p, at most e^(p (cosine - 1)), times specular times what arrives. e^-45 of
// kFaint times a sum is less than half a unit of its last place: the sum does not change.
constexpr double kFaintExponent = 45;
constexpr double kPowerMost = 1e6;  // beyond, rounding of the least cosine would count

void HitRows::Set(const Scene& scene, std::span<const Ray> rays,
                  std::span<const SurfaceHit> surfaces, std::span<const uint32_t> owners,
                  std::span<Color> colors) {
  PointLightRows::Set(scene, rays, surfaces, owners);
  surfaces_ = surfaces;
  colors_ = colors;
  any_shiny_ = false;
  const size_t end = (count_ + 7) / 8 * 8;
  for (size_t row = 0; row < end; ++row) {
    const size_t at = order_.hit(std::min(row, count_ - 1));
    const Surface& surface = surfaces[at].surface();
    const Color& s = surface.specular;
    for (int k = 0; k < 3; ++k) {
      diffuse_[k][row] = surface.diffuse[k];
      sum_[k][row] = colors[at][k];
      mirror_[k][row] = surfaces[at].mirror[k];
    }
    const bool shiny = HasHighlight(surface);
    any_shiny_ |= shiny;
    specular_[row] = shiny ? std::abs(s.r) + std::abs(s.g) + std::abs(s.b) : -1;
    least_[row] =
        shiny ? std::max(0.0, 1 - kFaintExponent / std::min<double>(surface.specpow, kPowerMost))
              : std::numeric_limits<double>::infinity();
  }
}

void HitRows::AddUp(const ObjectSet& objects, const Light& light) {
  const Color arrived = light.intensity();
  objects.AddDiffuse({blocked_,
                      cosine_,
                      {diffuse_[0], diffuse_[1], diffuse_[2]},
                      {arrived.r, arrived.g, arrived.b},
                      {sum_[0], sum_[1], sum_[2]},
                      static_cast<uint32_t>(count_)});
  if (any_shiny_) AddHighlights(objects, light);
}

void HitRows::AddHighlights(const ObjectSet& objects, const Light& light) {
  const Color arrived = light.intensity();
  uint8_t shines[kMost];
  objects.Shine({blocked_,
                 {toward_[0], toward_[1], toward_[2]},
                 {mirror_[0], mirror_[1], mirror_[2]},
                 least_,
                 specular_,
                 {sum_[0], sum_[1], sum_[2]},
                 std::abs(arrived.r) + std::abs(arrived.g) + std::abs(arrived.b),
                 static_cast<uint32_t>(count_),
                 shines});
  ForEachRow([&](size_t row) { return EightOf(shines, row); },
             [&](size_t row) {
               const size_t s = order_.hit(row);
               if (!HasHighlight(surfaces_[s].surface())) return;
               const Color highlight = Highlight(surfaces_[s], Sample(light, 0, s), arrived);
               for (int c = 0; c < 3; ++c) sum_[c][row] += highlight[c];
             });
}

void HitRows::Add(size_t s, const LightSample& sample, const Color& arrived) {
  const size_t row = order_.row(s);
  Color sum = this->sum(s);
  AddLight(surfaces_[s], sample, arrived, &sum);
  for (int c = 0; c < 3; ++c) sum_[c][row] = sum[c];
}

void HitRows::Finish() {
  for (size_t s = 0; s < count_; ++s) colors_[s] = sum(s);
}

}  // namespace rayshade
