// The hits of a bundle in rows (accel/trace_view.h), for lights that shine from one point: where
// the light stands and what is in its way is found for eight hits at a time, without a ray for
// each.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "rayshade/accel/object_set.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/shade/hit_order.h"
#include "rayshade/shade/shade.h"

namespace rayshade {

class PointLightRows {
 public:
  static constexpr size_t kMost = HitOrder::kMost;  // hits
  // A row's length: rows whose beginnings lie a multiple of 4 kB apart would share one set of the
  // first cache.
  static constexpr size_t kRow = kMost + 8;

  // Whether the rows can do a light as SampleLight would.
  static bool Suit(const Scene& scene, const Light& light);

  // The hits: hit s belongs to rays[owners[s]]. REQUIRES: at most kMost.
  void Set(const Scene& scene, std::span<const Ray> rays, std::span<const SurfaceHit> surfaces,
           std::span<const uint32_t> owners);
  // One light for the hits of Set: samples it and traces the shadow rays of those that the rows can
  // do, and counts all of this. REQUIRES: Suit(scene, light).
  void Trace(const Scene& scene, const ObjectSet& objects, const Light& light, OpCounts* counts);
  // The shadow rays of the last Trace, row by row.
  ShadowRows shadow_rays(const Light& light);
  // No light: none of the hits is done.
  void Clear();

  // What Trace found for hit s. Not done: the hit goes the general way, through SampleLight.
  bool done(size_t s) const { return done_[order_.row(s)] != 0; }
  bool all_done() const { return done_count_ == count_; }
  // By an opaque object, or does not face the light, or is not done.
  bool blocked(size_t s) const { return blocked_[order_.row(s)] != 0; }
  // Maybe by something transparent.
  bool crossed(size_t s) const { return crossed_[order_.row(s)] != 0; }
  // The light's sample of a hit that faces it; color: all that it sends.
  LightSample Sample(const Light& light, uint32_t number, size_t s) const;

 protected:
  // Eight flags from a row on that is a multiple of eight; those behind the last hit are 0.
  uint64_t EightOf(const uint8_t* flags, size_t row) const {
    uint64_t eight = 0;
    if (row + 8 <= count_) {
      std::memcpy(&eight, flags + row, 8);
    } else {
      std::memcpy(&eight, flags + row, count_ - row);
    }
    return eight;
  }

  // Calls visit(row) for each row whose flag is set; eight(row): the flags of eight rows.
  template <class Eight, class Visit>
  void ForEachRow(Eight eight, Visit visit) const {
    for (size_t begin = 0; begin < count_; begin += 8) {
      for (uint64_t left = eight(begin); left != 0; left &= left - 1) {
        visit(begin + static_cast<size_t>(std::countr_zero(left)) / 8);
      }
    }
  }

  // Rows are filled up to groups of eight with the last of them.
  size_t count_ = 0;
  HitOrder order_;
  alignas(64) double toward_[3][kRow];
  alignas(64) double distance_[kRow], cosine_[kRow];
  uint8_t blocked_[kMost], crossed_[kMost];

 private:
  void Aim(const Vector& position, const ObjectSet& objects);
  size_t CountOf(const uint8_t* flags) const;

  alignas(64) double point_[3][kRow];
  alignas(64) double normal_[3][kRow], face_[3][kRow];
  alignas(64) double slack_[kRow];  // infinite where the general way is the only one
  alignas(64) double time_[kRow];
  uint8_t done_[kMost];
  size_t done_count_ = 0;
  double reach_ = 0;  // of the points
};

}  // namespace rayshade
