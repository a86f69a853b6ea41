// Where the rays of a recorded run went from process to process, and which cells lay on their way.
#pragma once

#include <map>
#include <vector>

#include "parallel/cell_walk.h"
#include "tests/support/recorded_run.h"

namespace rayshade::parallel {

// A ray on its way between two processes.
struct RayStep {
  ProcessId from = kHost, to = kHost;
  Ray ray;
  Travel travel;
  size_t at = 0;  // number of its message in run.sent
};

// Every RayTask's rays, each ray's steps in order. A ray is told from others by itself and its
// return address.
inline std::vector<std::vector<RayStep>> RayTrails(const RecordedRun& run) {
  std::map<std::vector<uint8_t>, std::vector<RayStep>> trails;
  for (size_t at = 0; at < run.sent.size(); ++at) {
    const SentMessage& s = run.sent[at];
    if (s.tag != Tag::kRayTask) continue;
    for (const Traveller& t : run.Travellers(s)) {
      ByteWriter name;
      name.Put(t.ray);
      name.Put(t.travel.back);
      trails[name.Take()].push_back({s.from, s.to, t.ray, t.travel, at});
    }
  }
  std::vector<std::vector<RayStep>> list;
  for (auto& [name, steps] : trails) list.push_back(std::move(steps));
  return list;
}

// All cells on a ray's path, in its order.
inline std::vector<CellId> CellsAlong(const CellTree& tree, const Ray& ray) {
  std::vector<CellId> cells;
  CellWalk(&tree).Visit(
      ray.origin, ray.direction, kFar, [](uint32_t) { return false; },
      [&](CellId cell, const RayInterval&) {
        cells.push_back(cell);
        return true;
      });
  return cells;
}

inline bool Touch(const Bounds& a, const Bounds& b) {
  constexpr double kNear = 1e-6;
  for (int axis = 0; axis < 3; ++axis) {
    if (a.low[axis] > b.high[axis] + kNear || b.low[axis] > a.high[axis] + kNear) return false;
  }
  return true;
}

// The box of all cells that a process owns.
inline std::vector<Bounds> Voxels(const CellTree& tree, int processes) {
  std::vector<Bounds> voxels(processes + 1);
  const std::vector<Bounds> boxes = tree.Boxes();
  for (CellId c = 0; c < tree.size(); ++c) {
    voxels[tree.cell(c).owner].Include(boxes[c].low);
    voxels[tree.cell(c).owner].Include(boxes[c].high);
  }
  return voxels;
}

// Small cells, so that small scenes have many.
inline RunOptions ManyCells(Schedule schedule, int processes) {
  RunOptions options;
  options.schedule = schedule;
  options.processes = static_cast<uint16_t>(processes);
  options.cell_bytes = 2000;
  options.pyramid = 64;
  return options;
}

}  // namespace rayshade::parallel
