// Intersections whose secondary rays are on their way. "When all results for an intersection are
// completed, shading is performed and a colour value is returned" [RJ s.2].
//
//   1. A slot exists since its ray was spawned: a result always finds its place.
//   2. The transmitted ray is finished before the reflected one starts, so that one primary ray has
//   one ray on its way at any time, and at most one pending intersection per level.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "parallel/message.h"
#include "rayshade/shade/shade.h"

namespace rayshade::parallel {

// What only some intersections need.
struct PendingRest {
  Ray ray;                 // that was shaded; where there is an atmosphere
  SecondaryRay reflected;  // where reflected_waits has been set
  RayBundle waiting;       // that ray
};

// What all need fits into two cache lines: many are pending, and each line is fetched from memory
// twice.
struct alignas(64) PendingIntersection {
  ReturnAddress back;
  bool in_use = false;
  bool in_air = true;
  bool reflected_waits = false;      // for the transmitted ray
  RayKind kind = RayKind::kPrimary;  // of the ray that was shaded
  double distance = 0;
  Color color;       // folded so far
  SecondaryRay way;  // of the ray that is on its way
  std::unique_ptr<PendingRest> rest;
};
static_assert(sizeof(PendingIntersection) == 128);

class PendingIntersections {
 public:
  // Who is to need a slot fetches it from memory so many slots before.
  static constexpr size_t kAhead = 8;
  // A free slot, now in use; what stands in it is left over. Slots never move.
  uint32_t Allocate() {
    if (free_.empty()) {
      const uint32_t first = static_cast<uint32_t>(chunks_.size() * kChunk);
      chunks_.push_back(std::make_unique<PendingIntersection[]>(kChunk));
      for (uint32_t i = kChunk; i-- > 0;) free_.push_back(first + i);
    }
    const uint32_t slot = free_.back();
    free_.pop_back();
    if (free_.size() >= kAhead) Fetch(free_[free_.size() - kAhead]);
    Slot(slot).in_use = true;
    return slot;
  }
  // A slot that is not in use is a WireError: its number came in a message.
  PendingIntersection& at(uint64_t slot) {
    if (slot >= chunks_.size() * kChunk || !Slot(slot).in_use) {
      throw WireError("a result for no intersection");
    }
    return Slot(slot);
  }
  // Into the processor's cache. Always inline: a function that only fetches counts as one without
  // effect, and calls of it would be left out.
  [[gnu::always_inline]] void Fetch(uint64_t slot) {
    if (slot >= chunks_.size() * kChunk) return;
    const char* at = reinterpret_cast<const char*>(&Slot(slot));
    __builtin_prefetch(at, 1);
    __builtin_prefetch(at + 64, 1);
  }
  // The rest of a slot; what stands in it is left over, too.
  PendingRest& rest(PendingIntersection* pending) {
    if (pending->rest == nullptr) {
      pending->rest = std::make_unique<PendingRest>();
      ++rests_;
    }
    return *pending->rest;
  }
  void Free(uint64_t slot) {
    at(slot).in_use = false;
    free_.push_back(static_cast<uint32_t>(slot));
  }
  size_t size() const { return chunks_.size() * kChunk - free_.size(); }
  // Of the first few slots, which come together.
  static constexpr size_t kLeastBytes = 48 * sizeof(PendingIntersection);
  size_t bytes() const {
    return chunks_.size() * kChunk * sizeof(PendingIntersection) + rests_ * sizeof(PendingRest);
  }

 private:
  static constexpr size_t kChunk = kLeastBytes / sizeof(PendingIntersection);
  PendingIntersection& Slot(uint64_t slot) { return chunks_[slot / kChunk][slot % kChunk]; }

  std::vector<std::unique_ptr<PendingIntersection[]>> chunks_;
  std::vector<uint32_t> free_;
  size_t rests_ = 0;
};

}  // namespace rayshade::parallel
