// Building and sharing out the subdivision; see voxel_distribution.h.
#include "parallel/voxel_distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rayshade/common/check.h"

namespace rayshade::parallel {

namespace {

int LongestAxis(const Bounds& box) {
  const Vector d = box.high - box.low;
  return d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
}

Bounds SceneBounds(ObjectSpool* spool) {
  Bounds bounds;
  SpooledObject object;
  for (spool->Rewind(); spool->Next(false, &object);) {
    if (object.bounded) bounds.Include(object.bounds);
  }
  if (bounds.empty())
    bounds = {{0, 0, 0}, {0, 0, 0}};  // unbounded objects only: one cell with nothing in it
  // Hit points may lie outside of an object's box by rounding; see CellTree::margin.
  CellTree tree(bounds);
  bounds.Grow(2 * tree.margin());
  return bounds;
}

// Cuts a block of voxels in two until each is a cell of its own.
void CutVoxels(CellTree* tree, CellId cell, std::array<int, 3> from, std::array<int, 3> to,
               const std::array<int, 3>& counts) {
  int axis = 0;
  for (int a = 1; a < 3; ++a) {
    if (to[a] - from[a] > to[axis] - from[axis]) axis = a;
  }
  if (to[axis] - from[axis] == 1) {
    tree->cell(cell).owner =
        static_cast<ProcessId>(1 + from[0] + counts[0] * (from[1] + counts[1] * from[2]));
    return;
  }
  const int middle = (from[axis] + to[axis]) / 2;
  const Bounds& b = tree->bounds();
  const double plane = b.low[axis] + (b.high[axis] - b.low[axis]) * middle / counts[axis];
  const CellId high = tree->Cut(cell, axis, plane);
  auto low_to = to, high_from = from;
  low_to[axis] = high_from[axis] = middle;
  CutVoxels(tree, cell, from, low_to, counts);
  CutVoxels(tree, high, high_from, to, counts);
}

// Three levels of cuts tried on a cell that is too full. Node 1 is the cell; node i is cut into 2 i
// and 2 i + 1.
struct Trial {
  CellId cell;
  struct Node {
    Bounds box;
    int axis = 0;
    double plane = 0;
    uint32_t objects = 0;
    uint64_t bytes = 0;
  } nodes[16];

  Trial(CellId id, const Bounds& box) : cell(id) {
    nodes[1].box = box;
    for (int i = 1; i < 8; ++i) {
      Node& n = nodes[i];
      n.axis = LongestAxis(n.box);
      n.plane = 0.5 * (n.box.low[n.axis] + n.box.high[n.axis]);
      nodes[2 * i].box = nodes[2 * i + 1].box = n.box;
      nodes[2 * i].box.high[n.axis] = n.plane;
      nodes[2 * i + 1].box.low[n.axis] = n.plane;
    }
  }
  void Count(int i, const Bounds& object, uint64_t bytes) {
    ++nodes[i].objects;
    nodes[i].bytes += bytes;
    if (i >= 8) return;
    if (object.low[nodes[i].axis] <= nodes[i].plane) Count(2 * i, object, bytes);
    if (object.high[nodes[i].axis] >= nodes[i].plane) Count(2 * i + 1, object, bytes);
  }
};

constexpr int kMaxPasses = 16;       // of three levels each
constexpr double kWorthwhile = 0.8;  // a cut that leaves more than this in one part does not help

class TreeBuilder {
 public:
  TreeBuilder(const RunOptions& options, ObjectSpool* spool)
      : options_(options), spool_(spool), tree_(SceneBounds(spool)) {}

  CellTree Build() {
    const auto counts = GridCounts(options_.processes, SeenExtent());
    CutVoxels(&tree_, 0, {0, 0, 0}, counts, counts);
    std::vector<CellId> full(tree_.size());
    std::iota(full.begin(), full.end(), 0);
    for (int pass = 0; pass < kMaxPasses && !full.empty(); ++pass) full = CutOnce(full);
    CountAll();
    return std::move(tree_);
  }

 private:
  // The extent of the scene, shortened along the view: voxels side by side share what is seen,
  // voxels one behind the other do not.
  Vector SeenExtent() const {
    const Settings& settings = spool_->scene().settings;
    const Vector view = Normalized(settings.look - settings.eye);
    Vector extent = tree_.bounds().high - tree_.bounds().low;
    for (int axis = 0; axis < 3; ++axis) extent[axis] *= 1 - 0.5 * std::abs(view[axis]);
    return extent;
  }

  // One pass over the spool: cuts these cells by up to three levels; returns the cells that are
  // still too full.
  std::vector<CellId> CutOnce(const std::vector<CellId>& cells) {
    const std::vector<Bounds> boxes = tree_.Boxes();
    constexpr uint32_t kNone = ~uint32_t{0};
    std::vector<uint32_t> trial_of(tree_.size(), kNone);
    std::vector<Trial> trials;
    for (CellId cell : cells) {
      trial_of[cell] = static_cast<uint32_t>(trials.size());
      trials.emplace_back(cell, boxes[cell]);
    }
    SpooledObject object;
    for (spool_->Rewind(); spool_->Next(false, &object);) {
      if (!object.bounded) continue;
      Bounds grown = object.bounds;
      grown.Grow(tree_.margin());
      tree_.ForEachOver(object.bounds, [&](CellId cell) {
        if (trial_of[cell] != kNone) trials[trial_of[cell]].Count(1, grown, object.bytes);
      });
    }
    std::vector<CellId> full;
    for (const Trial& trial : trials) Apply(trial, 1, trial.cell, &full);
    return full;
  }

  void Apply(const Trial& trial, int i, CellId cell, std::vector<CellId>* full) {
    const Trial::Node& n = trial.nodes[i];
    if (n.bytes <= options_.cell_bytes || n.objects <= 1) return;
    if (i >= 8) {
      if (n.bytes <= kWorthwhile * trial.nodes[1].bytes) full->push_back(cell);
      return;
    }
    const CellId high = tree_.Cut(cell, n.axis, n.plane);
    Apply(trial, 2 * i, cell, full);
    Apply(trial, 2 * i + 1, high, full);
  }

  void CountAll() {
    SpooledObject object;
    for (spool_->Rewind(); spool_->Next(false, &object);) {
      if (!object.bounded) continue;
      tree_.ForEachOver(object.bounds, [&](CellId cell) {
        ++tree_.cell(cell).objects;
        tree_.cell(cell).bytes += object.bytes;
      });
    }
  }

  const RunOptions& options_;
  ObjectSpool* spool_;
  CellTree tree_;
};

}  // namespace

std::array<int, 3> GridCounts(int n, const Vector& extent) {
  std::array<int, 3> best{n, 1, 1};
  for (int a = 1; a <= n; ++a) {
    if (n % a != 0) continue;
    for (int b = 1; b <= a && b <= n / a; ++b) {
      if (n / a % b != 0) continue;
      const int c = n / a / b;
      if (c <= b && a + b + c < best[0] + best[1] + best[2]) best = {a, b, c};
    }
  }
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return extent[a] > extent[b]; });
  std::array<int, 3> counts;
  for (int i = 0; i < 3; ++i) counts[axes[i]] = best[i];
  return counts;
}

CellTree BuildTree(const RunOptions& options, ObjectSpool* spool) {
  return TreeBuilder(options, spool).Build();
}

void ChooseResidentSet(const Vector& eye, uint64_t budget, CellTree* tree) {
  struct Candidate {
    double distance2;
    CellId cell;
  };
  std::vector<Candidate> candidates;
  const std::vector<Bounds> boxes = tree->Boxes();
  for (CellId c = 0; c < tree->size(); ++c) {
    double distance2 = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double d =
          std::max({boxes[c].low[axis] - eye[axis], eye[axis] - boxes[c].high[axis], 0.0});
      distance2 += d * d;
    }
    candidates.push_back({distance2, c});
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.cell < b.cell);
  });
  uint64_t used = 0;
  for (const Candidate& c : candidates) {
    Cell& cell = tree->cell(c.cell);
    if (used + cell.bytes > budget)
      break;  // nearer cells first: no smaller one behind is taken instead
    used += cell.bytes;
    cell.resident = true;
  }
}

std::vector<uint64_t> BytesHeld(const RunOptions& options, const CellTree& tree,
                                ObjectSpool* spool) {
  std::vector<uint64_t> bytes(options.processes);
  std::vector<uint64_t> counted(
      options.processes);  // number of the object last counted for a process
  uint64_t number = 0;
  SpooledObject object;
  for (spool->Rewind(); spool->Next(false, &object);) {
    ++number;
    bool everywhere = !object.bounded;
    if (object.bounded) {
      tree.ForEachOver(object.bounds, [&](CellId c) {
        everywhere = everywhere || tree.cell(c).resident;
        const size_t p = tree.cell(c).owner - 1u;
        if (counted[p] != number) bytes[p] += object.bytes;
        counted[p] = number;
      });
    }
    for (size_t p = 0; everywhere && p < bytes.size(); ++p) {
      if (counted[p] != number) bytes[p] += object.bytes;
    }
  }
  return bytes;
}

int ProcessesThatWouldDo(uint64_t memory, uint64_t spare, ObjectSpool* spool) {
  if (spare >= memory) return 0;
  for (int n = 2; n <= 4096; n = n < 4 ? n + 1 : n + n / 4) {
    RunOptions options;
    options.processes = static_cast<uint16_t>(n);
    options.cell_bytes = ~uint32_t{0};  // voxels only
    const CellTree tree = BuildTree(options, spool);
    const auto held = BytesHeld(options, tree, spool);
    if (*std::max_element(held.begin(), held.end()) + spare <= memory) return n;
  }
  return 0;
}

}  // namespace rayshade::parallel
