#include "rayshade/accel/build.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayshade {

namespace {

using F4 = float __attribute__((vector_size(16)));
using I4 = int32_t __attribute__((vector_size(16)));
using D4 = double __attribute__((vector_size(32), aligned(8)));

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kBinsMax = 16;
constexpr int kDepthOfHeuristic =
    40;  // below, halves are taken: at most 2^32 objects, 11 levels of eight
// The cost of looking into a node, and of testing an object of a leaf, in units of each other.
constexpr float kSplitCost = 1.0f;
constexpr float kObjectCost = 0.35f;
constexpr uint32_t kSmallLeaf = 6;
// A sphere's computed hits lie on a sphere whose radius is off by rounding: by less than this part
// of its coordinates.
constexpr double kRoundingOfSpheres = 1e-14;

F4 Min(F4 a, F4 b) { return a < b ? a : b; }
F4 Max(F4 a, F4 b) { return a > b ? a : b; }

struct Box {
  F4 low{kInfinity, kInfinity, kInfinity, kInfinity};
  F4 high{-kInfinity, -kInfinity, -kInfinity, -kInfinity};

  void Include(const Box& b) {
    low = Min(low, b.low);
    high = Max(high, b.high);
  }
  void Include(F4 p) {
    low = Min(low, p);
    high = Max(high, p);
  }
  float HalfArea() const {
    const F4 d = high - low;
    return d[0] < 0 ? 0 : d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

// Objects that still have to be divided: a range of spheres and one of refs.
struct Range {
  uint32_t sphere_begin = 0, sphere_end = 0, ref_begin = 0, ref_end = 0;
  Box box;        // of the objects, not rounded outwards
  Box centroids;  // doubled

  uint32_t count() const { return (sphere_end - sphere_begin) + (ref_end - ref_begin); }
};

struct Bin {
  Box box;
  uint32_t count = 0;
};

struct Split {
  float cost = kInfinity;
  int axis = -1;
  int last_left_bin = 0;
  F4 base{}, scale{};
  int bins = 0;
};

class Builder {
 public:
  explicit Builder(const BuildInput& input) : in_(input) {
    center_ = D4{in_.center[0], in_.center[1], in_.center[2], 0};
  }

  BuildOutput Run() {
    Range all;
    all.sphere_end = static_cast<uint32_t>(in_.spheres.size());
    all.ref_end = static_cast<uint32_t>(in_.refs.size());
    out_.leaf_begins.resize((in_.spheres.size() + 63) / 64);
    if (all.count() == 0) return std::move(out_);
    for (uint32_t i = 0; i < all.sphere_end; ++i) Enclose(BoxOfSphere(i), &all);
    for (uint32_t i = 0; i < all.ref_end; ++i) Enclose(BoxOfRef(i), &all);
    out_.nodes.push_back(Node{});
    FillNode(0, all, 0);
    out_.nodes.ShrinkToFit();
    return std::move(out_);
  }

 private:
  static void Enclose(const Box& box, Range* range) {
    range->box.Include(box);
    range->centroids.Include(box.low + box.high);
  }

  // Not rounded outwards: for the heuristic only.
  Box BoxOfSphere(uint32_t i) const {
    const SphereRecord& s = in_.spheres[i];
    const F4 c = __builtin_convertvector(D4{s.x, s.y, s.z, 0} - center_, F4);
    const float r = static_cast<float>(s.radius);
    const F4 radius{r, r, r, 0};
    return {c - radius, c + radius};
  }
  Box BoxOfRef(uint32_t i) const {
    const BuildRef& r = in_.refs[i];
    return {F4{r.low[0], r.low[1], r.low[2], 0}, F4{r.high[0], r.high[1], r.high[2], 0}};
  }
  // Contains every hit on the sphere.
  Box SafeBoxOfSphere(uint32_t i) const {
    const SphereRecord& s = in_.spheres[i];
    const double largest = std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)}) + s.radius;
    const double r = s.radius + in_.growth[in_.keys[i].placement] + kRoundingOfSpheres * largest;
    const double c[3] = {s.x - in_.center[0], s.y - in_.center[1], s.z - in_.center[2]};
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = RoundedDown(c[axis] - r);
      box.high[axis] = RoundedUp(c[axis] + r);
    }
    box.low[3] = box.high[3] = 0;
    return box;
  }

  static I4 BinsOf(const Box& box, const Split& split) {
    return __builtin_convertvector((box.low + box.high - split.base) * split.scale, I4);
  }

  Split FindSplit(const Range& range) const {
    Split best;
    best.bins = std::min<int>(kBinsMax, 4 + static_cast<int>(range.count() / 8));
    const F4 extent = range.centroids.high - range.centroids.low;
    best.base = range.centroids.low;
    for (int axis = 0; axis < 3; ++axis) {
      // Slightly less than bins / extent: the last bin is not left.
      const float scale = static_cast<float>(best.bins) * 0.9999f / extent[axis];
      best.scale[axis] = extent[axis] > 0 && std::isfinite(scale) ? scale : 0;
    }
    best.scale[3] = 0;
    Bin bins[3][kBinsMax];
    const auto count = [&](const Box& box) {
      const I4 bin = BinsOf(box, best);
      for (int axis = 0; axis < 3; ++axis) {
        if (best.scale[axis] == 0) continue;  // there are no bins: all in a plane, or too far apart
        Bin& b = bins[axis][bin[axis]];
        b.box.Include(box);
        ++b.count;
      }
    };
    for (uint32_t i = range.sphere_begin; i < range.sphere_end; ++i) count(BoxOfSphere(i));
    for (uint32_t i = range.ref_begin; i < range.ref_end; ++i) count(BoxOfRef(i));
    for (int axis = 0; axis < 3; ++axis) {
      if (best.scale[axis] != 0) Sweep(bins[axis], axis, range.count(), &best);
    }
    best.cost = kSplitCost * range.box.HalfArea() + kObjectCost * best.cost;
    return best;
  }

  // The best border between two bins.
  static void Sweep(const Bin* bins, int axis, uint32_t total, Split* best) {
    float area_right[kBinsMax];
    Box box;
    for (int i = best->bins - 1; i > 0; --i) {
      box.Include(bins[i].box);
      area_right[i] = box.HalfArea();
    }
    box = Box();
    uint32_t left = 0;
    for (int i = 0; i + 1 < best->bins; ++i) {
      box.Include(bins[i].box);
      left += bins[i].count;
      if (left == 0 || left == total) continue;
      const float cost = box.HalfArea() * static_cast<float>(left) +
                         area_right[i + 1] * static_cast<float>(total - left);
      if (cost < best->cost) {
        best->cost = cost;
        best->axis = axis;
        best->last_left_bin = i;
      }
    }
  }

  void SwapSpheres(uint32_t i, uint32_t j) {
    std::swap(in_.spheres[i], in_.spheres[j]);
    std::swap(in_.keys[i], in_.keys[j]);
  }

  // Moves what belongs to the left to the front of [begin, end); returns where the right begins.
  template <typename BoxOf, typename Swap>
  static uint32_t Partition(uint32_t begin, uint32_t end, const Split& split, const BoxOf& box_of,
                            const Swap& swap, Range* left, Range* right) {
    while (begin < end) {
      const Box box = box_of(begin);
      if (BinsOf(box, split)[split.axis] <= split.last_left_bin) {
        Enclose(box, left);
        ++begin;
      } else {
        Enclose(box, right);
        --end;
        swap(begin, end);
      }
    }
    return begin;
  }

  void Divide(const Range& range, const Split& split, Range* left, Range* right) {
    const uint32_t sphere_middle = Partition(
        range.sphere_begin, range.sphere_end, split, [&](uint32_t i) { return BoxOfSphere(i); },
        [&](uint32_t i, uint32_t j) { SwapSpheres(i, j); }, left, right);
    const uint32_t ref_middle = Partition(
        range.ref_begin, range.ref_end, split, [&](uint32_t i) { return BoxOfRef(i); },
        [&](uint32_t i, uint32_t j) { std::swap(in_.refs[i], in_.refs[j]); }, left, right);
    SetRanges(range, sphere_middle, ref_middle, left, right);
  }

  static void SetRanges(const Range& range, uint32_t sphere_middle, uint32_t ref_middle,
                        Range* left, Range* right) {
    left->sphere_begin = range.sphere_begin;
    left->sphere_end = right->sphere_begin = sphere_middle;
    right->sphere_end = range.sphere_end;
    left->ref_begin = range.ref_begin;
    left->ref_end = right->ref_begin = ref_middle;
    right->ref_end = range.ref_end;
  }

  // Where the heuristic finds nothing: spheres from refs, refs by kind, then halves of what there
  // is.
  void DivideAnyhow(const Range& range, Range* left, Range* right) {
    const uint32_t spheres = range.sphere_end - range.sphere_begin;
    const uint32_t refs = range.ref_end - range.ref_begin;
    uint32_t sphere_middle = range.sphere_end, ref_middle = range.ref_begin;
    if (spheres == 0) {
      ref_middle = range.ref_begin + refs / 2;
      if (range.count() <= kLeafSize) {
        const LeafKind kind = in_.refs[range.ref_begin].kind;
        const auto begin = in_.refs.begin();
        ref_middle = static_cast<uint32_t>(
            std::partition(begin + range.ref_begin, begin + range.ref_end,
                           [&](const BuildRef& r) { return r.kind == kind; }) -
            begin);
      }
    } else if (refs == 0) {
      sphere_middle = range.sphere_begin + spheres / 2;
    }
    SetRanges(range, sphere_middle, ref_middle, left, right);
    for (Range* part : {left, right}) {
      for (uint32_t i = part->sphere_begin; i < part->sphere_end; ++i) {
        Enclose(BoxOfSphere(i), part);
      }
      for (uint32_t i = part->ref_begin; i < part->ref_end; ++i) Enclose(BoxOfRef(i), part);
    }
  }

  bool OneKind(const Range& range) const {
    if (range.ref_begin == range.ref_end) return true;
    if (range.sphere_begin != range.sphere_end) return false;
    for (uint32_t i = range.ref_begin; i < range.ref_end; ++i) {
      if (in_.refs[i].kind != in_.refs[range.ref_begin].kind) return false;
    }
    return true;
  }

  // Divides the range, or says that it is to be a leaf.
  bool TryDivide(const Range& range, int depth, Range* left, Range* right) {
    const uint32_t count = range.count();
    if (count <= 1) return false;
    const bool may_be_leaf = count <= kLeafSize && OneKind(range);
    Split split;
    if (depth < kDepthOfHeuristic) split = FindSplit(range);
    const float leaf_cost = kObjectCost * static_cast<float>(count) * range.box.HalfArea();
    if (may_be_leaf && (split.axis < 0 || leaf_cost <= split.cost)) return false;
    if (split.axis >= 0) {
      Divide(range, split, left, right);
    } else {
      DivideAnyhow(range, left, right);
    }
    return true;
  }

  Box FillNode(uint32_t index, const Range& range, int depth) {
    // Divide the largest branch until there are eight, or none can be divided.
    Range parts[kNodeWidth] = {range};
    bool leaf[kNodeWidth] = {};
    int count = 1;
    while (count < kNodeWidth) {
      int largest = -1;
      float largest_size = 0;
      for (int i = 0; i < count; ++i) {
        if (leaf[i]) continue;
        const float size = depth < kDepthOfHeuristic ? parts[i].box.HalfArea()
                                                     : static_cast<float>(parts[i].count());
        if (largest < 0 || size > largest_size) {
          largest = i;
          largest_size = size;
        }
      }
      if (largest < 0) break;
      Range left, right;
      if (TryDivide(parts[largest], depth, &left, &right)) {
        parts[largest] = left;
        parts[count++] = right;
      } else {
        leaf[largest] = true;
      }
    }
    // Branches left over when the node was full are leaves where they are small.
    for (int i = 0; i < count; ++i) {
      if (!leaf[i]) leaf[i] = parts[i].count() <= kSmallLeaf && OneKind(parts[i]);
    }
    return WriteNode(index, parts, leaf, count, depth);
  }

  Box WriteNode(uint32_t index, const Range* parts, const bool* leaf, int count, int depth) {
    uint32_t child = static_cast<uint32_t>(out_.nodes.size());
    Node node{};
    for (int i = 0; i < count; ++i) {
      if (leaf[i]) {
        const bool spheres = parts[i].sphere_begin != parts[i].sphere_end;
        node.branch[i] =
            MakeBranch(spheres ? kSphereLeaf : in_.refs[parts[i].ref_begin].kind,
                       spheres ? parts[i].sphere_begin : parts[i].ref_begin, parts[i].count());
      } else {
        node.branch[i] = MakeBranch(kInnerNode, child++, 0);
        out_.nodes.push_back(Node{});
      }
    }
    Box all;
    for (int i = 0; i < kNodeWidth; ++i) {
      Box box;
      if (i < count) {
        box = leaf[i] ? MakeLeaf(parts[i]) : FillNode(ChildOf(node.branch[i]), parts[i], depth + 1);
        all.Include(box);
      }
      for (int axis = 0; axis < 3; ++axis) {
        node.plane[axis][i] = box.low[axis];
        node.plane[3 + axis][i] = box.high[axis];
      }
    }
    out_.nodes[index] = node;
    return all;
  }

  // Returns the leaf's box, rounded outwards, and lays its spheres down as rows.
  Box MakeLeaf(const Range& range) {
    Box box;
    for (uint32_t i = range.ref_begin; i < range.ref_end; ++i) box.Include(BoxOfRef(i));
    const uint32_t count = range.sphere_end - range.sphere_begin;
    if (count == 0) return box;
    SphereRecord copy[kLeafSize];
    double* rows = &in_.spheres[range.sphere_begin].x;
    out_.leaf_begins[range.sphere_begin / 64] |= uint64_t{1} << (range.sphere_begin % 64);
    for (uint32_t i = 0; i < count; ++i) {
      copy[i] = in_.spheres[range.sphere_begin + i];
      box.Include(SafeBoxOfSphere(range.sphere_begin + i));
    }
    for (uint32_t i = 0; i < count; ++i) {
      rows[i] = copy[i].x;
      rows[count + i] = copy[i].y;
      rows[2 * count + i] = copy[i].z;
      rows[3 * count + i] = copy[i].radius;
    }
    return box;
  }

  BuildInput in_;
  D4 center_;
  BuildOutput out_;
};

}  // namespace

float RoundedDown(double x) {
  const float f = static_cast<float>(x);
  if (!(std::abs(f) < 1e38f)) return x < 0 ? -kInfinity : 1e38f;
  return f - std::abs(f) * 2.4e-7f - 1e-37f;
}

float RoundedUp(double x) { return -RoundedDown(-x); }

BuildOutput BuildHierarchy(const BuildInput& input) { return Builder(input).Run(); }

}  // namespace rayshade
