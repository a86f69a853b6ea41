// The hits of a bundle in rows, with what they gather: a light that shines from one point is added
// up for eight hits at a time. Hits that it may do something unusual to go the general way, with
// the same results to the bit. For each light:
//
//   1. Trace, where it suits; else Clear. Hits that are not done() then go the general way.
//   2. TakeOut those of which the rows cannot tell what arrives; they go the general way from
//   there.
//   3. AddUp the rest.
//   4. Add what the general way tells.
#pragma once

#include <cstdint>
#include <span>

#include "rayshade/shade/point_light_rows.h"

namespace rayshade {

class HitRows : public PointLightRows {
 public:
  // Takes the hits of rays[owners[s]]; colors: what they gather, ambient light so far. All must
  // outlive the lights.
  void Set(const Scene& scene, std::span<const Ray> rays, std::span<const SurfaceHit> surfaces,
           std::span<const uint32_t> owners, std::span<Color> colors);

  // Calls visit(s) for each hit whose light is not blocked, but maybe crossed.
  template <class Visit>
  void ForEachCrossed(Visit visit) const {
    ForEachUnblocked(crossed_, visit);
  }
  // Calls visit(s) for each hit whose light is not blocked and whose row's flag is 1.
  template <class Visit>
  void ForEachUnblocked(const uint8_t* flags, Visit visit) const {
    ForEachRow([&](size_t row) { return EightOf(flags, row) & ~EightOf(blocked_, row); },
               [&](size_t row) { visit(order_.hit(row)); });
  }
  void TakeOut(size_t s) { blocked_[order_.row(s)] = 1; }
  // objects: any that is built.
  void AddUp(const ObjectSet& objects, const Light& light);
  void Add(size_t s, const LightSample& sample, const Color& arrived);
  // What hit s has gathered.
  Color sum(size_t s) const {
    const size_t row = order_.row(s);
    return {sum_[0][row], sum_[1][row], sum_[2][row]};
  }
  // Writes the colors.
  void Finish();

 private:
  void AddHighlights(const ObjectSet& objects, const Light& light);

  alignas(64) double diffuse_[3][kRow], sum_[3][kRow];
  // For highlights: smaller cosines leave nothing that a sum would notice; sum of channels.
  alignas(64) double mirror_[3][kRow], least_[kRow], specular_[kRow];
  bool any_shiny_;

  std::span<const SurfaceHit> surfaces_;
  std::span<Color> colors_;
};

}  // namespace rayshade
