// What trace processes in one address space were sent before tracing, kept once: those that were
// sent the same messages Objects, in the same order, share the decoded objects and the hierarchy
// over them. Each counts them as its own; what is spared is the simulator's memory, so that it can
// run a thousand processes.
//
//   1. Nothing that a process says or costs depends on it: the same bytes are the same objects.
//   2. What is shared is never changed.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parallel/message.h"
#include "parallel/rank_index.h"
#include "rayshade/accel/object_set.h"
#include "rayshade/geom/geom.h"
#include "rayshade/scene/scene.h"

namespace rayshade::parallel {

// A member of a definition, which several placed objects share.
struct Member {
  GeomSpec spec;
  std::shared_ptr<const Geom> geom;
};

// What the objects of a process refer to, by the numbers of the run.
struct ObjectNumbers {
  std::map<uint32_t, PlacementId> placements;
  std::vector<uint32_t> placement_numbers;  // by PlacementId
  std::map<uint32_t, Member> members;
  std::map<const Geom*, uint32_t> member_numbers;  // looked up only, never walked
};

// The objects of a process, as they stand before its first ray.
struct Holding {
  std::shared_ptr<ObjectSet> own;          // built
  std::shared_ptr<const RankIndex> ranks;  // null where memory is short
  std::shared_ptr<const Scene> scene;      // which `own` refers to
  std::vector<Placement> placements;       // by PlacementId
  ObjectNumbers numbers;
  std::vector<WireImage> images;
};

class SharedObjects {
 public:
  struct Parcel {
    uint32_t number = 0;  // the same for the same bytes
    size_t objects = 0;
  };
  // message: a whole Objects, encoded; a malformed one is a WireError.
  Parcel Keep(std::span<const uint8_t> message);
  // An Objects that was kept, decoded.
  Objects At(uint32_t number) const;
  // Of whoever was sent these, in this order; null until somebody has put it there.
  std::shared_ptr<const Holding>& Of(const std::vector<uint32_t>& parcels) {
    return holdings_[parcels];
  }

 private:
  struct Hash {
    using is_transparent = void;
    size_t operator()(std::string_view s) const { return std::hash<std::string_view>()(s); }
  };
  std::unordered_map<std::string, Parcel, Hash, std::equal_to<>> parcels_;  // looked up only
  std::vector<const std::string*> by_number_;
  std::map<std::vector<uint32_t>, std::shared_ptr<const Holding>> holdings_;
};

}  // namespace rayshade::parallel
