// The hits of a level in rows (accel/trace_view.h), for lights that shine from one point: such a
// light is done for eight hits at a time. Hits that it may do something unusual to go the general
// way (sequential_tracer.cc), with the same results to the bit.
//
//   1. Rows are filled up to groups of eight with the last hit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rayshade/render/sequential_tracer.h"

namespace rayshade {

inline constexpr size_t kHitRowsSize = 512;

class HitRows {
 public:
  // Takes the hits of rays[owners[s]]; colors: what they gather, ambient light so far. All must
  // outlive the lights.
  void Set(const Scene& scene, std::span<const Ray> rays, std::span<const SurfaceHit> surfaces,
           std::span<const uint32_t> owners, std::span<Color> colors);

  // Whether a light can be done by rows at all.
  static bool Suits(const Scene& scene, const Light& light);
  // Does what it can of a light; the hits that are left have done[s] 0. REQUIRES: Suits.
  void Illuminate(const Light& light, const ObjectSet& objects, ShadowTracer* shadows,
                  OpCounts* counts);
  // No hit is done.
  void SkipLight();
  bool done(size_t s) const { return by_row_[s] != 0; }
  bool all_done() const { return done_ == surfaces_.size(); }

  // For the hits that are left.
  void Add(size_t s, const LightSample& sample, const Color& arrived);
  // Writes the colors.
  void Finish();

 private:
  void Aim(const Vector& position, const ObjectSet& objects, OpCounts* counts);
  void Trace(const Vector& position, const ObjectSet& objects, OpCounts* counts);
  void AddByRows(const Light& light, const ObjectSet& objects, ShadowTracer* shadows,
                 OpCounts* counts);

  alignas(64) double point_[3][kHitRowsSize];
  alignas(64) double normal_[3][kHitRowsSize], face_[3][kHitRowsSize];
  alignas(64) double diffuse_[3][kHitRowsSize], sum_[3][kHitRowsSize];
  alignas(64) double slack_[kHitRowsSize];  // infinite where the general way is the only one
  alignas(64) double toward_[3][kHitRowsSize];
  alignas(64) double distance_[kHitRowsSize], cosine_[kHitRowsSize], time_[kHitRowsSize];
  uint8_t by_row_[kHitRowsSize];
  uint8_t blocked_[kHitRowsSize];  // or not lit by the light
  uint8_t crossed_[kHitRowsSize];  // something transparent may be in the way
  double reach_ = 0;               // of the points
  size_t done_ = 0, traced_ = 0;   // of the light at hand
  bool transparent_ = false;
  std::vector<uint32_t> shiny_;  // hits that have highlights

  std::span<const Ray> rays_;
  std::span<const SurfaceHit> surfaces_;
  std::span<const uint32_t> owners_;
  std::span<Color> colors_;
};

}  // namespace rayshade
