// Intersections whose secondary rays are on their way. "When all results for an intersection are
// completed, shading is performed and a colour value is returned" [RJ s.2].
//
//   1. A slot exists since its ray was spawned: a result always finds its place.
//   2. The transmitted ray is finished before the reflected one starts, so that one primary ray has
//   one ray on its
//      way at any time, and at most one pending intersection per level.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "parallel/message.h"
#include "rayshade/common/check.h"
#include "rayshade/shade/shade.h"

namespace rayshade::parallel {

struct PendingIntersection {
  ReturnAddress back;
  Ray ray;  // that was shaded
  bool in_air = true;
  double distance = 0;
  Color lights;
  Secondary secondary;
  RayResult transmitted, reflected;
  RayBundle waiting;  // the reflected ray while the transmitted one is on its way; else empty
};

class PendingIntersections {
 public:
  uint32_t Add(PendingIntersection&& pending) {
    if (free_.empty()) {
      slots_.emplace_back(std::move(pending));
      return static_cast<uint32_t>(slots_.size() - 1);
    }
    const uint32_t slot = free_.back();
    free_.pop_back();
    slots_[slot] = std::move(pending);
    return slot;
  }
  // A token that no pending intersection has is a WireError: it came in a message.
  PendingIntersection& at(uint64_t slot) {
    if (slot >= slots_.size() || !slots_[slot]) throw WireError("a result for no intersection");
    return *slots_[slot];
  }
  PendingIntersection Take(uint64_t slot) {
    PendingIntersection pending = std::move(at(slot));
    slots_[slot].reset();
    free_.push_back(static_cast<uint32_t>(slot));
    return pending;
  }
  size_t size() const { return slots_.size() - free_.size(); }
  size_t bytes() const { return size() * sizeof(slots_[0]); }

 private:
  std::vector<std::optional<PendingIntersection>> slots_;
  std::vector<uint32_t> free_;
};

}  // namespace rayshade::parallel
