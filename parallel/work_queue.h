// The scheduling policy, all of it: what the schedules do differently, what a process does next,
// and when it asks for more work [RJ s.2-4].
#pragma once

#include <cstdint>
#include <vector>

#include "parallel/ray_queue.h"
#include "parallel/run_options.h"

namespace rayshade::parallel {

// A ray that must go on in a cell that is not held: handed to the cell's owner, or put aside until
// the cell is fetched.
inline bool ForwardsRays(Schedule schedule) { return schedule != Schedule::kDemandDriven; }
// A hit: shaded by the owner of the cell in which it lies, or where it was found.
inline bool TransfersHits(Schedule schedule) { return schedule != Schedule::kDemandDriven; }
// Rays meet the cells that were fetched for shadow rays as well; else the voxel alone, so that
// which rays are handed on does not depend on what was fetched before.
inline bool SearchesCache(Schedule schedule) { return schedule != Schedule::kDataParallel; }
// Primary rays: on request, or pushed to the voxels that they enter.
inline bool AsksForWork(Schedule schedule) { return schedule != Schedule::kDataParallel; }

// Most rays traced in one step; small enough that arriving messages do not wait long.
inline constexpr size_t kRaysPerStep = 512;
// So many are worth a step of their own: fewer are traced badly, but what waits for their results
// would leave the processor's cache.
inline constexpr size_t kRaysWorthAStep = 64;
// Requests for primary rays that may be unanswered at once.
inline constexpr int kRequestsAhead = 1;
// Requests for cells that may be unanswered at once.
inline constexpr size_t kCellsAhead = 8;
// Packs for other trace processes that are not full are sent after so many steps.
inline constexpr int kStepsPerFlush = 32;

// Rays that can be traced now, by depth.
class WorkQueue {
 public:
  void Push(const Ray& ray, std::span<const Medium> media, const Travel& travel) {
    OfDepth(ray.depth).Push(ray, media, travel);
  }
  // Those of one depth, for more of them to be added.
  RayQueue& OfDepth(size_t depth) {
    if (depth >= by_depth_.size()) by_depth_.resize(depth + 1);
    return by_depth_[depth];
  }
  // A step of rays of one depth, the deepest of which there are enough; false where there is none.
  bool PopEnough(RayQueue* rays) { return PopAtLeast(kRaysWorthAStep, rays); }
  // The deepest rays, however few.
  bool PopAny(RayQueue* rays) { return PopAtLeast(1, rays); }
  size_t size() const {
    size_t size = 0;
    for (const RayQueue& q : by_depth_) size += q.size();
    return size;
  }
  size_t bytes() const {
    size_t bytes = 0;
    for (const RayQueue& q : by_depth_) bytes += q.bytes();
    return bytes;
  }

 private:
  bool PopAtLeast(size_t least, RayQueue* rays) {
    for (size_t d = by_depth_.size(); d-- > 0;) {
      if (by_depth_[d].size() < least) continue;
      by_depth_[d].Pop(kRaysPerStep, rays);
      return true;
    }
    return false;
  }

  std::vector<RayQueue> by_depth_;
};

// A process is short of work when it has less than two pyramids to trace, so that it does not stand
// still until the host has answered; what waits for cells counts as work as well, so that waiting
// rays do not pile up.
inline bool ShortOfWork(size_t ready, size_t waiting, uint32_t pyramid) {
  const size_t enough = 2 * static_cast<size_t>(pyramid);
  return ready < enough && waiting < enough;
}

}  // namespace rayshade::parallel
