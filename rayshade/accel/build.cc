#include "rayshade/accel/build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "rayshade/accel/pieces.h"
#include "rayshade/accel/split.h"

namespace rayshade {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Divided pieces that together hold no more than this are built on as one: where pieces meet, nodes
// are not full.
constexpr uint32_t kJoinedMax = 4 * kPieceMax;
// Below, halves are taken: at most kJoinedMax objects, six levels of eight.
constexpr int kDepthOfHeuristic = kPieceDepth;
static_assert(kDepthOfHeuristic + 7 <= kDepthMax);
// The cost of looking into a node, and of testing an object of a leaf, in units of each other.
constexpr float kSplitCost = 1.0f;
constexpr float kObjectCost = 0.2f;
// A sphere's computed hits lie on a sphere whose radius is off by rounding: by less than this part
// of its coordinates.
constexpr double kRoundingOfSpheres = 1e-14;

// Objects that still have to be divided: boxes of one of the two arrays of a piece.
struct Range {
  uint32_t begin = 0, end = 0;
  int array = 0;
  Box box = Box::Empty();

  uint32_t count() const { return end - begin; }
};

class Builder {
 public:
  explicit Builder(const BuildInput& input) : objects_(input), in_(objects_.input()) {}

  BuildOutput Run() {
    if (objects_.sphere_count() + objects_.ref_count() == 0) return std::move(out_);
    if (objects_.sphere_count() > 0) {
      out_.leaf_begins.resize(in_.spheres.size() / 64 + 2);
      BeginLeaf(static_cast<uint32_t>(in_.spheres.size()));
    }
    pieces_ = DivideIntoPieces(&objects_);
    out_.nodes.push_back(Node{});
    FillUpperNode(0, 0, 0);
    out_.nodes.ShrinkToFit();
    return std::move(out_);
  }

 private:
  // Contains every hit on the sphere.
  Box SafeBoxOf(const SphereRecord& s, uint32_t placement) const {
    const double largest = std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)}) + s.radius;
    const double r = s.radius + in_.growth[placement] + kRoundingOfSpheres * largest;
    const double c[3] = {s.x - in_.center[0], s.y - in_.center[1], s.z - in_.center[2]};
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = RoundedDown(c[axis] - r);
      box.high[axis] = RoundedUp(c[axis] + r);
    }
    box.low[3] = box.high[3] = 0;
    return box;
  }
  static Box SafeBoxOf(const BuildRef& r) {
    return {F4{r.low[0], r.low[1], r.low[2], 0}, F4{r.high[0], r.high[1], r.high[2], 0}};
  }

  bool IsBuiltOn(const Piece& piece) const {
    return !piece.divided() || piece.count() <= kJoinedMax;
  }

  // A node whose branches are pieces.
  Box FillUpperNode(uint32_t index, uint32_t piece, int depth) {
    if (IsBuiltOn(pieces_[piece])) return FillNode(index, Load(pieces_[piece]), depth);
    uint32_t parts[kNodeWidth] = {pieces_[piece].parts[0], pieces_[piece].parts[1]};
    int count = 2;
    for (int largest = 0; count < kNodeWidth && largest >= 0;) {
      largest = -1;
      float largest_area = -1;
      for (int i = 0; i < count; ++i) {
        const float area = pieces_[parts[i]].box.HalfArea();
        if (IsBuiltOn(pieces_[parts[i]]) || area <= largest_area) continue;
        largest = i;
        largest_area = area;
      }
      if (largest < 0) break;
      const Piece& opened = pieces_[parts[largest]];
      parts[largest] = opened.parts[0];
      parts[count++] = opened.parts[1];
    }
    const uint32_t first = static_cast<uint32_t>(out_.nodes.size());
    out_.nodes.resize(out_.nodes.size() + count);
    Node node{};
    Box all = Box::Empty();
    for (int i = 0; i < kNodeWidth; ++i) {
      Box box = Box::Empty();
      if (i < count) {
        node.branch[i] = MakeBranch(kInnerNode, first + i, 0);
        box = FillUpperNode(first + i, parts[i], depth + 1);
      }
      SetChild(i, box, &node, &all);
    }
    out_.nodes[index] = node;
    return all;
  }

  static void SetChild(int i, const Box& box, Node* node, Box* all) {
    all->Include(box);
    for (int axis = 0; axis < 3; ++axis) {
      node->plane[axis][i] = box.low[axis];
      node->plane[3 + axis][i] = box.high[axis];
    }
  }

  // Copies a piece's objects. Leaves write them back as they are made, each kind from its
  // beginning.
  Range Load(const Piece& piece) {
    const auto spheres = in_.spheres.begin();
    const auto keys = in_.keys.begin();
    const auto refs = in_.refs.begin();
    next_sphere_ = piece.sphere_begin;
    next_ref_ = piece.ref_begin;
    spheres_.assign(spheres + piece.sphere_begin, spheres + piece.sphere_end);
    keys_.assign(keys + piece.sphere_begin, keys + piece.sphere_end);
    refs_.assign(refs + piece.ref_begin, refs + piece.ref_end);
    for (auto& array : boxes_) array.resize(piece.count());
    Range all;
    all.end = piece.count();
    all.box = piece.box;
    for (uint32_t i = 0; i < all.end; ++i) {
      Box box = i < spheres_.size() ? objects_.BoxOfSphere(spheres_[i])
                                    : objects_.BoxOfRef(refs_[i - spheres_.size()]);
      box.low[3] = box.high[3] = static_cast<float>(i);
      boxes_[0][i] = box;
    }
    return all;
  }

  // What a box is the box of: a sphere, or after all spheres a ref, as copied.
  static uint32_t ObjectOf(const Box& box) { return static_cast<uint32_t>(box.low[3]); }
  LeafKind KindOfBox(const Box& box) const {
    const uint32_t object = ObjectOf(box);
    return object < spheres_.size() ? kSphereLeaf : refs_[object - spheres_.size()].kind;
  }
  const Box* BoxesOf(const Range& range) const { return boxes_[range.array].data() + range.begin; }

  bool OneKind(const Range& range) const {
    if (refs_.empty()) return true;
    const Box* boxes = BoxesOf(range);
    return std::all_of(boxes + 1, boxes + range.count(),
                       [&](const Box& box) { return KindOfBox(box) == KindOfBox(boxes[0]); });
  }

  // Divides the range, or says that it is to be a leaf.
  bool TryDivide(const Range& range, int depth, Range* left, Range* right) {
    const uint32_t count = range.count();
    if (count <= 1) return false;
    const bool may_be_leaf = count <= kLeafSize && OneKind(range);
    Split split;
    Box* to = boxes_[1 - range.array].data() + range.begin;
    if (depth < kDepthOfHeuristic) split = Divide(BoxesOf(range), count, to);
    const float area = range.box.HalfArea();
    const float leaf_cost = kObjectCost * static_cast<float>(count) * area;
    if (may_be_leaf &&
        (!split.found() || leaf_cost <= kSplitCost * area + kObjectCost * split.cost))
      return false;
    *left = *right = range;
    left->array = right->array = 1 - range.array;
    if (!split.found()) split = DivideAnyhow(range, to);
    left->box = split.left;
    right->box = split.right;
    left->end = right->begin = range.begin + split.left_count;
    return true;
  }

  // Where the heuristic finds nothing: by kind where there are few, or halves.
  Split DivideAnyhow(const Range& range, Box* to) const {
    Box* end = std::copy_n(BoxesOf(range), range.count(), to);
    Box* middle = to + range.count() / 2;
    if (range.count() <= kLeafSize && !OneKind(range)) {
      const LeafKind kind = KindOfBox(to[0]);
      middle = std::partition(to, end, [&](const Box& b) { return KindOfBox(b) == kind; });
    }
    Split split;
    split.left = split.right = Box::Empty();
    split.left_count = static_cast<uint32_t>(middle - to);
    for (Box* box = to; box < end; ++box) (box < middle ? split.left : split.right).Include(*box);
    return split;
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
      if (!leaf[i]) leaf[i] = parts[i].count() <= kLeafSize && OneKind(parts[i]);
    }
    return WriteNode(index, parts, leaf, count, depth);
  }

  Box WriteNode(uint32_t index, const Range* parts, const bool* leaf, int count, int depth) {
    uint32_t child = static_cast<uint32_t>(out_.nodes.size());
    Node node{};
    for (int i = 0; i < count; ++i) {
      if (leaf[i]) continue;
      node.branch[i] = MakeBranch(kInnerNode, child++, 0);
      out_.nodes.push_back(Node{});
    }
    for (int i = 0; i < count; ++i) {
      if (leaf[i]) PrefetchObjects(parts[i]);
    }
    Box all = Box::Empty();
    for (int i = 0; i < kNodeWidth; ++i) {
      Box box = Box::Empty();
      if (i < count) {
        box = leaf[i] ? MakeLeaf(parts[i], &node.branch[i])
                      : FillNode(ChildOf(node.branch[i]), parts[i], depth + 1);
      }
      SetChild(i, box, &node, &all);
    }
    out_.nodes[index] = node;
    return all;
  }

  // Soon they will be laid down as a leaf; they lie anywhere in the piece.
  void PrefetchObjects(const Range& range) const {
    for (uint32_t i = 0; i < range.count(); ++i) {
      const uint32_t object = ObjectOf(BoxesOf(range)[i]);
      if (object >= spheres_.size()) return;
      __builtin_prefetch(spheres_.data() + object);
      __builtin_prefetch(keys_.data() + object);
    }
  }

  // Returns the leaf's box, rounded outwards.
  Box MakeLeaf(const Range& range, uint64_t* branch) {
    const LeafKind kind = KindOfBox(BoxesOf(range)[0]);
    if (kind == kSphereLeaf) return MakeSphereLeaf(range, branch);
    *branch = MakeBranch(kind, next_ref_, range.count());
    Box box = Box::Empty();
    for (uint32_t i = 0; i < range.count(); ++i) {
      const BuildRef& ref = refs_[ObjectOf(BoxesOf(range)[i]) - spheres_.size()];
      box.Include(SafeBoxOf(ref));
      in_.refs[next_ref_++] = ref;
    }
    return box;
  }

  void BeginLeaf(uint32_t sphere) { out_.leaf_begins[sphere / 64] |= uint64_t{1} << (sphere % 64); }

  // Lays the spheres down as rows.
  Box MakeSphereLeaf(const Range& range, uint64_t* branch) {
    const uint32_t count = range.count(), first = next_sphere_;
    *branch = MakeBranch(kSphereLeaf, first, count);
    BeginLeaf(first);
    double* rows = &in_.spheres[first].x;
    Box box = Box::Empty();
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t object = ObjectOf(BoxesOf(range)[i]);
      const SphereRecord& s = spheres_[object];
      box.Include(SafeBoxOf(s, keys_[object].placement));
      rows[i] = s.x;
      rows[count + i] = s.y;
      rows[2 * count + i] = s.z;
      rows[3 * count + i] = s.radius;
      in_.keys[first + i] = keys_[object];
    }
    next_sphere_ += count;
    return box;
  }

  BuildObjects objects_;
  BuildInput& in_;
  BuildOutput out_;
  std::vector<Piece> pieces_;
  // Of the piece at work.
  std::vector<Box> boxes_[2];
  std::vector<SphereRecord> spheres_;
  std::vector<ObjectKey> keys_;
  std::vector<BuildRef> refs_;
  uint32_t next_sphere_ = 0, next_ref_ = 0;  // where the next leaf goes
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
