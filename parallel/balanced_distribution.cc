// Prediction and sharing out; see balanced_distribution.h.
#include "parallel/balanced_distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parallel/cell_walk.h"

namespace rayshade::parallel {

namespace {

constexpr int kRaysAcross = 64;
constexpr double kShareOfBytes = 0.2;  // of the weight of all cells

Bounds Common(const Bounds& a, const Bounds& b) {
  Bounds common;
  for (int axis = 0; axis < 3; ++axis) {
    common.low[axis] = std::max(a.low[axis], b.low[axis]);
    common.high[axis] = std::max(common.low[axis], std::min(a.high[axis], b.high[axis]));
  }
  return common;
}

// Cross-section per volume of each cell's content: a convex body shows a quarter of its surface on
// the average.
std::vector<double> Densities(const CellTree& tree, ObjectSpool* spool) {
  const std::vector<Bounds> boxes = tree.Boxes();
  std::vector<double> densities(tree.size());
  SpooledObject object;
  for (spool->Rewind(); spool->Next(false, &object);) {
    if (!object.bounded) continue;
    tree.ForEachOver(object.bounds,
                     [&](CellId c) { densities[c] += Common(object.bounds, boxes[c]).area() / 4; });
  }
  for (CellId c = 0; c < tree.size(); ++c) {
    const Vector d = boxes[c].high - boxes[c].low;
    const double volume = d.x * d.y * d.z;
    densities[c] = volume > 0 ? densities[c] / volume : 0;
  }
  return densities;
}

void AddShare(double share, const std::vector<double>& of_cells, std::vector<double>* sum) {
  const double all = std::accumulate(of_cells.begin(), of_cells.end(), 0.0);
  for (size_t c = 0; all > 0 && c < of_cells.size(); ++c) (*sum)[c] += share * of_cells[c] / all;
}

}  // namespace

std::vector<double> PredictHits(const Camera& camera, const CellTree& tree, ObjectSpool* spool) {
  const std::vector<double> densities = Densities(tree, spool);
  std::vector<double> hits(tree.size());
  const PictureWindow& window = camera.window();
  for (int i = 0; i < kRaysAcross * kRaysAcross; ++i) {
    const Sample sample{i % kRaysAcross * window.width() / kRaysAcross,
                        i / kRaysAcross * window.height() / kRaysAcross, 0, true};
    const Ray ray = camera.PrimaryRay(sample);
    double left = 1.0 / (kRaysAcross * kRaysAcross);
    WalkCells(
        tree, ray.origin, ray.direction, kFar,
        [&](uint32_t node) {
          const CellNode& n = tree.nodes()[node];
          return n.axis == 3 && densities[n.low] == 0;
        },
        [&](CellId cell, const RayInterval& interval) {
          const double length = interval.exit - std::max(interval.entry, 0.0);
          const double passed = left * std::exp(-densities[cell] * std::max(length, 0.0));
          hits[cell] += left - passed;
          left = passed;
          return left > 1e-9;
        });
  }
  return hits;
}

std::vector<double> WorkByCell(const std::vector<double>& hits, const CellTree& tree) {
  std::vector<double> work(tree.size());
  AddShare(1 - kShareOfBytes, hits, &work);
  AddShare(kShareOfBytes, BytesByCell(tree), &work);
  return work;
}

std::vector<double> BytesByCell(const CellTree& tree) {
  std::vector<double> bytes(tree.size());
  for (CellId c = 0; c < tree.size(); ++c) bytes[c] = static_cast<double>(tree.cell(c).bytes);
  return bytes;
}

void ShareOut(const std::vector<double>& weights, int processes, CellTree* tree) {
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  double before = 0;
  std::vector<uint32_t> nodes{0};
  while (!nodes.empty()) {
    const CellNode& n = tree->nodes()[nodes.back()];
    nodes.pop_back();
    if (n.axis != 3) {
      nodes.push_back(n.high);
      nodes.push_back(n.low);
      continue;
    }
    const double middle = all > 0 ? (before + weights[n.low] / 2) / all : 0;
    before += weights[n.low];
    tree->cell(n.low).owner =
        static_cast<ProcessId>(1 + std::min(processes - 1, static_cast<int>(middle * processes)));
  }
}

}  // namespace rayshade::parallel
