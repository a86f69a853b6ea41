// Intersections whose secondary rays are on their way. "When all results for an intersection are
// completed, shading is performed and a colour value is returned" [RJ s.2].
//
//   1. A slot exists since its ray was spawned: a result always finds its place.
//   2. The transmitted ray is finished before the reflected one starts, so that one primary ray has
//   one ray on its way at any time, and at most one pending intersection per level.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "parallel/message.h"
#include "rayshade/shade/shade.h"

namespace rayshade::parallel {

struct PendingIntersection {
  bool in_use = false;
  bool in_air = true;
  ReturnAddress back;
  Ray ray;  // that was shaded
  double distance = 0;
  Color lights;
  Secondary secondary;
  RayResult transmitted, reflected;
  RayBundle waiting;  // the reflected ray while the transmitted one is on its way; else empty
};

class PendingIntersections {
 public:
  // A free slot, now in use; what stands in it is left over. Slots never move.
  uint32_t Allocate() {
    if (free_.empty()) {
      free_.push_back(static_cast<uint32_t>(slots_.size()));
      slots_.emplace_back();
    }
    const uint32_t slot = free_.back();
    free_.pop_back();
    slots_[slot].in_use = true;
    return slot;
  }
  // A slot that is not in use is a WireError: its number came in a message.
  PendingIntersection& at(uint64_t slot) {
    if (slot >= slots_.size() || !slots_[slot].in_use) {
      throw WireError("a result for no intersection");
    }
    return slots_[slot];
  }
  void Free(uint64_t slot) {
    at(slot).in_use = false;
    free_.push_back(static_cast<uint32_t>(slot));
  }
  size_t size() const { return slots_.size() - free_.size(); }
  size_t bytes() const { return slots_.size() * sizeof(PendingIntersection); }

 private:
  std::deque<PendingIntersection> slots_;
  std::vector<uint32_t> free_;
};

}  // namespace rayshade::parallel
