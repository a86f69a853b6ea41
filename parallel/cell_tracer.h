// A bundle against what this process holds: own cells and resident set in one hierarchy, cached
// cells one by one. The one rule for every ray (DESIGN, "Cells, and one rule for every ray"):
//
//   The answer is conclusive up to T, the entry of the first cell on the ray's path that is not
//   held. A hit strictly nearer than T ends the ray; else it has to go on in that cell, with its
//   best hit so far.
//
// Bundles that form a pyramid get one clip list (PyraClip); the rays of others walk the subdivision
// one by one. Both give the same answers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parallel/cell_tree.h"
#include "parallel/cell_walk.h"
#include "parallel/message.h"
#include "parallel/object_cache.h"
#include "parallel/pyraclip.h"
#include "parallel/pyramid.h"
#include "parallel/ray_rows.h"
#include "rayshade/accel/object_set.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/common/ray.h"
#include "rayshade/shade/crossing.h"
#include "rayshade/shade/shade.h"

namespace rayshade::parallel {

// Where a ray had to stop.
struct Halt {
  CellId cell = kNoCell;  // kNoCell: the answer is conclusive
  double entry = kFar;
};

class CellTracer {
 public:
  // own: own and resident objects; all outlive the tracer.
  CellTracer(const Scene* scene, const CellTree* tree, ProcessId self, const ObjectSet* own,
             ObjectCache* cache);

  // Whether Nearest looks at cached cells (Shadows always does); as made, it does.
  void set_searches_cache(bool on) { searches_cache_ = on; }

  // Held for good: own or resident.
  bool owns(CellId cell) const { return owned_[cell]; }
  bool owns_all() const { return all_owned_[0]; }
  bool holds(CellId cell) const { return owned_[cell] || cache_->Holds(cell); }

  // Nearest hits. travel[i]: where ray i resumes and its best hit so far, which hits[i] starts
  // from. Where a carried best hit stands, hits[i].set is null unless the object was met again
  // here.
  void Nearest(std::span<const Ray> rays, std::span<const Travel> travel, std::span<Hit> hits,
               std::span<Halt> halts, OpCounts* counts);

  // A shadow ray on its way: blocked, or what it has crossed so far.
  struct Shadow {
    const Ray* ray = nullptr;
    double limit = 0;
    std::vector<ShadowCrossing>* crossings =
        nullptr;  // null unless the scene has transparent surfaces
    CellId resume = kNoCell;
    bool own_done = false;
    bool blocked = false;
    Halt halt;
  };
  // Follows each to its limit, to an opaque object, or to a cell that is not held.
  void Shadows(std::span<Shadow> shadows, OpCounts* counts);
  // foreign[i] becomes 1 where shadow ray i of the rows is not blocked and meets a cell before its
  // limit that is not held for good, or nearly; else 0, and the objects that are held for good say
  // all about it.
  void FindForeign(const ShadowRows& rows, uint8_t* foreign, OpCounts* counts);

  // A hit known by (distance, rank) found again among the held objects of the cell in which it
  // lies; set is null where that cell is not held.
  Hit Locate(const Ray& ray, double distance, Rank rank, OpCounts* counts);

  // The same for a hit that is known to be on an object held here. CHECKs that it is.
  Hit LocateHeld(const Ray& ray, double distance, Rank rank, OpCounts* counts);

  // The owner of the place of a hit; kHost outside of the subdivision.
  ProcessId OwnerAt(const Ray& ray, double distance);

  const Bounds& box(CellId cell) const { return boxes_[cell]; }
  uint64_t cache_hits() const { return cache_hits_; }
  uint64_t cache_misses() const { return cache_misses_; }
  size_t bytes() const;

 private:
  struct Candidate {  // a cell on a ray's path that is not owned
    CellId cell;
    RayInterval interval;
  };
  bool Before(const RayInterval& interval, CellId cell, const Ray& ray, CellId resume) const;
  std::vector<ClippedCell> ClipList(const Pyramid& pyramid, double limit) const;
  template <class Visit>
  void Walk(const Ray& ray, double limit, Visit visit, OpCounts* counts);
  void NearestByClipList(const Pyramid& pyramid, std::span<const Ray> rays,
                         std::span<const Travel> travel, std::span<Hit> hits, std::span<Halt> halts,
                         OpCounts* counts);
  void NearestByWalk(const Ray& ray, const Travel& travel, Hit* hit, Halt* halt, OpCounts* counts);
  const ObjectSet* Searched(CellId cell) { return searches_cache_ ? cache_->Find(cell) : nullptr; }
  // Rays are traced together through the hierarchy of a fetched cell.
  void CountTrace(size_t rays, OpCounts* counts) {
    cache_hits_ += rays;
    ++counts->cell_traces;
  }
  void Cross(const ObjectSet& set, std::span<Shadow*> shadows, OpCounts* counts);
  void ShadowsByClipList(const Pyramid& pyramid, std::span<Shadow*> shadows, OpCounts* counts);
  void ShadowByWalk(Shadow* shadow, OpCounts* counts);

  const Scene* scene_;
  const CellTree* tree_;
  const ObjectSet* own_;
  ObjectCache* cache_;
  bool searches_cache_ = true;
  std::vector<uint8_t> owned_;      // by cell
  std::vector<uint8_t> all_owned_;  // by node: nothing below is foreign
  std::vector<ProcessId> owners_;   // by node: of all cells below; kHost where they differ
  std::vector<Bounds> boxes_;       // by cell
  // The node that OwnerAt came to the last time, and its box; empty at first.
  uint32_t last_node_ = 0;
  Bounds last_region_;
  uint64_t cache_hits_ = 0, cache_misses_ = 0;
  // Scratch, to spare allocations.
  CellWalk walk_;
  RayRows rows_;
  std::vector<Ray> some_rays_;
  std::vector<Hit> some_hits_;
  std::vector<uint32_t> some_;
  std::vector<double> limits_;
  std::vector<uint8_t> blocked_;
  std::vector<uint8_t> crossed_;
};

}  // namespace rayshade::parallel
