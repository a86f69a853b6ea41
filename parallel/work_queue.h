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
// Requests for primary rays that may be unanswered at once: one pyramid in work, one on its way.
inline constexpr int kRequestsAhead = 2;
// Requests for cells that may be unanswered at once.
inline constexpr size_t kCellsAhead = 8;
// Packs that are not full are sent after so many steps.
inline constexpr int kStepsPerFlush = 8;

// Rays that can be traced now, by depth.
class WorkQueue {
 public:
  void Push(const Ray& ray, std::span<const Medium> media, const Travel& travel) {
    if (ray.depth >= by_depth_.size()) by_depth_.resize(ray.depth + 1);
    by_depth_[ray.depth].Push(ray, media, travel);
    ++size_;
  }
  // A full step of rays of one depth, the deepest first; false where there is none.
  bool PopFull(RayQueue* rays) { return PopAtLeast(kRaysPerStep, rays); }
  // The deepest rays, however few.
  bool PopAny(RayQueue* rays) { return PopAtLeast(1, rays); }
  size_t size() const { return size_; }
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
      size_ -= rays->size();
      return true;
    }
    return false;
  }

  std::vector<RayQueue> by_depth_;
  size_t size_ = 0;
};

// A process is short of work when it has less than half a pyramid to trace; what waits for cells
// counts as work up to two pyramids, so that a process does not pile up waiting rays.
inline bool ShortOfWork(size_t ready, size_t waiting, uint32_t pyramid) {
  return ready < (pyramid + 1) / 2 && waiting < 2 * static_cast<size_t>(pyramid);
}

}  // namespace rayshade::parallel
