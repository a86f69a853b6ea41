// What messages carry (message.h): rays with how far they have come, and objects with what they
// refer to. Values, in the order of their fields (wire.h).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "parallel/cell_tree.h"
#include "parallel/process_id.h"
#include "parallel/sample_runs.h"
#include "parallel/scene_codec.h"
#include "parallel/wire.h"
#include "rayshade/accel/object_set.h"
#include "rayshade/shade/crossing.h"

namespace rayshade::parallel {

// Where the result of a ray goes: a pixel sample at the host, or a slot of an intersection at its
// spawner.
struct ReturnAddress {
  ProcessId process = kHost;
  uint64_t token = 0;

  template <class A>
  void Fields(A& a) {
    a("process", process);
    a("token", token);
  }
};

// The part of a ray's state that is not the ray: how far it has been traced, and the best hit so
// far.
struct Travel {
  ReturnAddress back;
  CellId resume = kNoCell;  // cells before this one (in the ray's order) are done; kNoCell: none is
  double best_distance = kFar;
  Rank best_rank = kNoRank;
  bool own_done = false;  // not sent: this process has tested what it holds for good

  template <class A>
  void Fields(A& a) {
    a("back", back);
    a("resume", resume);
    a("best_distance", best_distance);
    a("best_rank", best_rank);
  }
};

// A primary ray on its way: it is a pure function of its sample, so the sample stands for it.
struct PrimaryTravel {
  static constexpr bool kPacked = true;
  uint64_t token = 0;  // of its return address at the host
  double best_distance = kFar;
  Rank best_rank = kNoRank;
  CellId resume = kNoCell;

  template <class A>
  void Fields(A& a) {
    a("token", token);
    a("best_distance", best_distance);
    a("best_rank", best_rank);
    a("resume", resume);
  }
};

// Rays on their way between processes: primary ones by their samples, all others with everything
// that they are.
struct TravellingRays {
  std::vector<PrimaryTravel> primary;
  RayBundle bundle;
  std::vector<Travel> travel;  // one for each ray of the bundle

  template <class A>
  void Fields(A& a) {
    a("primary", primary);
    a("bundle", bundle);
    a("travel", travel);
    if constexpr (A::kReading) {
      if (travel.size() != bundle.size()) throw WireError("rays and their travel differ in number");
    }
  }
};

// A shadow ray on its way, with what it has crossed so far.
struct ShadowTravel {
  ReturnAddress back;  // a waiting hit of its spawner, and which of its shadow rays
  CellId resume = 0;   // as in Travel
  Ray ray;
  double limit = 0;  // nothing at or beyond this distance matters
  Color color;       // of the light
  std::vector<ShadowCrossing> crossings;

  template <class A>
  void Fields(A& a) {
    a("back", back);
    a("resume", resume);
    a("ray", ray);
    a("limit", limit);
    a("color", color);
    a("crossings", crossings);
  }
};

// A placed object. A member of a definition carries the number of the member, so that a process
// keeps it once.
struct WireObject {
  Rank rank = 0;
  uint32_t placement = 0;  // number in the whole run
  uint32_t member = 0;     // 0: placed once
  GeomSpec geom;

  template <class A>
  void Fields(A& a) {
    a("rank", rank);
    a("placement", placement);
    a("member", member);
    a("geom", geom);
  }
};
struct WirePlacement {
  uint32_t number = 0;
  Placement placement;

  template <class A>
  void Fields(A& a) {
    a("number", number);
    a("placement", placement);
  }
};
struct WireImage {
  uint32_t number = 0;  // image_table.h
  std::shared_ptr<const ImageData> image;

  template <class A>
  void Fields(A& a) {
    a("number", number);
    a("image", image);
  }
};
// Objects together with the placements that they refer to and the images that they show, of which
// those that the sender has sent to the same receiver before are left out.
struct ObjectParcel {
  std::vector<WireImage> images;
  std::vector<WirePlacement> placements;
  std::vector<WireObject> objects;

  template <class A>
  void Fields(A& a) {
    a("images", images);
    a("placements", placements);
    a("objects", objects);
  }
};

}  // namespace rayshade::parallel
