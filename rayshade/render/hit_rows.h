// The hits of a level in rows, with what they gather: a light that shines from one point is added
// up for eight hits at a time. Hits that it may do something unusual to go the general way
// (sequential_tracer.cc), with the same results to the bit.
#pragma once

#include <cstdint>
#include <span>

#include "rayshade/render/sequential_tracer.h"
#include "rayshade/shade/point_light_rows.h"

namespace rayshade {

class HitRows : public PointLightRows {
 public:
  // Takes the hits of rays[owners[s]]; colors: what they gather, ambient light so far. All must
  // outlive the lights.
  void Set(const Scene& scene, std::span<const Ray> rays, std::span<const SurfaceHit> surfaces,
           std::span<const uint32_t> owners, std::span<Color> colors);

  // Does what it can of a light; the hits that are left are not done(). REQUIRES: Suit.
  void Illuminate(const Scene& scene, const ObjectSet& objects, const Light& light,
                  ShadowTracer* shadows, OpCounts* counts);

  // For the hits that are left.
  void Add(size_t s, const LightSample& sample, const Color& arrived);
  // Writes the colors.
  void Finish();

 private:
  void AddThroughTransparent(const Light& light, ShadowTracer* shadows, OpCounts* counts);

  void AddHighlights(const ObjectSet& objects, const Light& light);

  alignas(64) double diffuse_[3][kRow], sum_[3][kRow];
  // For highlights: smaller cosines leave nothing that a sum would notice; sum of channels.
  alignas(64) double mirror_[3][kRow], least_[kRow], specular_[kRow];
  bool any_shiny_;

  std::span<const Ray> rays_;
  std::span<const SurfaceHit> surfaces_;
  std::span<const uint32_t> owners_;
  std::span<Color> colors_;
};

}  // namespace rayshade
