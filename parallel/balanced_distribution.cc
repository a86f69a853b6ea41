// Prediction and sharing out; see balanced_distribution.h.
#include "parallel/balanced_distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rayshade::parallel {

namespace {

constexpr int kRaysAcross = 128;
constexpr double kShareOfBytes = 0.02;  // of the weight of all cells

Vector Scaled(const Vector& v, const Vector& by) { return {v.x * by.x, v.y * by.y, v.z * by.z}; }

// Rays to a grid of pixels, and how far each is clear.
class RayGrid {
 public:
  // reach: pixels that a ray can be off the corner of its pixel.
  RayGrid(const Camera& camera, double reach) : camera_(camera), reach_(reach) {
    const PictureWindow& window = camera.window();
    for (int i = 0; i < kRaysAcross * kRaysAcross; ++i) {
      rays_[i] = camera.PrimaryRay({i % kRaysAcross * window.width() / kRaysAcross,
                                    i / kRaysAcross * window.height() / kRaysAcross, 0, true});
    }
  }

  // Cuts the rays off where they meet the ellipsoid in a box.
  void Put(const Bounds& box);

  const Ray& ray(int i) const { return rays_[i]; }
  double distance(int i) const { return distances_[i]; }

 private:
  struct Range {
    int low = kRaysAcross, high = -1;
    void Add(double place, double reach) {
      constexpr double kLast = kRaysAcross - 1;
      low = std::min(low, static_cast<int>(std::clamp(std::floor(place - reach), 0.0, kLast)));
      high = std::max(high, static_cast<int>(std::clamp(std::ceil(place + reach), 0.0, kLast)));
    }
  };

  // The columns and rows of rays that can meet the box; false where none can.
  bool Over(const Bounds& box, Range* columns, Range* rows) const;

  const Camera& camera_;
  double reach_;
  std::vector<Ray> rays_ = std::vector<Ray>(kRaysAcross * kRaysAcross);
  std::vector<double> distances_ = std::vector<double>(kRaysAcross * kRaysAcross, kFar);
};

bool RayGrid::Over(const Bounds& box, Range* columns, Range* rows) const {
  const double across = double(kRaysAcross) / camera_.window().width();
  const double down = double(kRaysAcross) / camera_.window().height();
  int in_front = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector at =
        camera_.Project({(corner & 1 ? box.high : box.low).x, (corner & 2 ? box.high : box.low).y,
                         (corner & 4 ? box.high : box.low).z});
    if (!(at.z > 0)) continue;
    ++in_front;
    columns->Add(at.x * across, reach_ * across);
    rows->Add(at.y * down, reach_ * down);
  }
  if (in_front == 0) return false;
  if (in_front < 8) *columns = *rows = {0, kRaysAcross - 1};
  return true;
}

void RayGrid::Put(const Bounds& box) {
  Range columns, rows;
  if (!Over(box, &columns, &rows)) return;
  const Vector middle = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
  const double least = 1e-6 * std::max({half.x, half.y, half.z});
  const Vector scale{1 / std::max(half.x, least), 1 / std::max(half.y, least),
                     1 / std::max(half.z, least)};
  for (int row = rows.low; row <= rows.high; ++row) {
    for (int column = columns.low; column <= columns.high; ++column) {
      const int i = row * kRaysAcross + column;
      const Vector o = Scaled(rays_[i].origin - middle, scale);
      const Vector d = Scaled(rays_[i].direction, scale);
      const double a = Dot(d, d), b = Dot(o, d), c = Dot(o, o) - 1;
      const double root = b * b - a * c;
      if (!(root >= 0)) continue;
      double t = (-b - std::sqrt(root)) / a;
      if (t <= 0) t = (-b + std::sqrt(root)) / a;
      if (t > 0 && t < distances_[i]) distances_[i] = t;
    }
  }
}

void AddShare(double share, const std::vector<double>& of_cells, std::vector<double>* sum) {
  const double all = std::accumulate(of_cells.begin(), of_cells.end(), 0.0);
  for (size_t c = 0; all > 0 && c < of_cells.size(); ++c) (*sum)[c] += share * of_cells[c] / all;
}

}  // namespace

PredictedHits PredictHits(const Camera& camera, const CellTree& tree, ObjectSpool* spool) {
  RayGrid grid(camera, spool->scene().settings.filter_width_used());
  SpooledObject object;
  for (spool->Rewind(); spool->Next(false, &object);) {
    if (object.bounded) grid.Put(object.bounds);
  }
  constexpr int kRays = kRaysAcross * kRaysAcross;
  PredictedHits hits;
  hits.by_cell.resize(tree.size());
  hits.across = kRaysAcross;
  hits.cells.assign(kRays, kNoCell);
  for (int i = 0; i < kRays; ++i) {
    if (grid.distance(i) == kFar) continue;
    hits.cells[i] = tree.At(grid.ray(i).origin + grid.distance(i) * grid.ray(i).direction);
    hits.by_cell[hits.cells[i]] += 1.0 / kRays;
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
