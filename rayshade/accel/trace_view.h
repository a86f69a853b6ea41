// What the kernels see of an object set: plain pointers into its arrays. The kernels are compiled
// once per instruction set, so this header and what it includes must define no inline function that
// the linker could take from the wrong one.
//
//   1. Boxes of the nodes are relative to `center` and rounded outwards: they contain the object's
//   world bounds, and so does every computed hit.
//   2. Leaves hold at most kLeafSize objects of one kind. The spheres of a leaf lie as rows: all x,
//   all y, all z, all radii.
//   3. A hit counts if its kind's own test finds it and, where that test could find it outside of
//   the object's world box, if the ray meets this box by the plain slab test, not behind the hit: a
//   definition that no hierarchy enters into, and nearly Rayshade's own [rayshade4/2 s.2.4]. This
//   concerns hits farther than kSureDistance, rays whose direction is not of unit length, polygons
//   that are not planar, and all that goes through Geom.
#pragma once

#include <cstdint>

namespace rayshade {

struct OpCounts;
struct Ray;
struct Hit;
struct FlatObjects;
class ObjectSet;

inline constexpr int kNodeWidth = 8;
inline constexpr int kLeafSize = 8;
inline constexpr int kDepthMax = 56;  // of the hierarchy
inline constexpr int kStackSize = (kNodeWidth - 1) * kDepthMax + kNodeWidth;
inline constexpr double kSureDistance = 1e6;
inline constexpr double kUnitTolerance = 1e-9;  // of the square of a unit direction's length

enum LeafKind : uint8_t {
  kEmptySlot,
  kInnerNode,
  kSphereLeaf,
  kTriangleLeaf,
  kPolygonLeaf,
  kOtherLeaf
};

// GeomSpec::index() of what leaves of their own hold, and of what has members.
inline constexpr int kSphereGeom = 0, kTriangleGeom = 4, kPolygonGeom = 7, kCompositeGeom = 13;

struct alignas(64) Node {
  float plane[6][kNodeWidth];   // low x, y, z, high x, y, z of each child
  uint64_t branch[kNodeWidth];  // of each child; see MakeBranch
};
static_assert(sizeof(Node) == 256);

// What a node's child is: an inner node's number, or the first object of a leaf and their count.
inline constexpr int kKindShift = 32, kCountShift = 40;
#define RAYSHADE_BRANCH static inline __attribute__((always_inline))
RAYSHADE_BRANCH uint64_t MakeBranch(LeafKind kind, uint32_t child, uint32_t count) {
  return child | uint64_t{kind} << kKindShift | uint64_t{count} << kCountShift;
}
RAYSHADE_BRANCH uint32_t ChildOf(uint64_t branch) { return static_cast<uint32_t>(branch); }
RAYSHADE_BRANCH LeafKind KindOf(uint64_t branch) {
  return static_cast<LeafKind>(branch >> kKindShift & 0xff);
}
RAYSHADE_BRANCH uint32_t CountOf(uint64_t branch) {
  return static_cast<uint32_t>(branch >> kCountShift);
}
#undef RAYSHADE_BRANCH

struct ObjectKey {
  uint32_t placement;
  uint32_t rank;
};

// What a shadow ray meets.
enum class Meeting : uint8_t { kNothing, kOpaque, kTransparent };

// The set's own answers, for what is not done in the kernels.
struct TraceCallbacks {
  // Objects that go through Geom, and the unbounded ones: improves *hit, or says what is in the
  // way within the limit.
  void (*nearest_other)(const void* set, const Ray& ray, uint32_t object, double limit, Hit* hit);
  Meeting (*meets_other)(const void* set, const Ray& ray, uint32_t object, double limit);
  // Does the ray meet the object's world box, and not only beyond this distance?
  bool (*meets_box)(const void* set, const Ray& ray, uint32_t object, double distance);
};

struct TraceView {
  const void* set = nullptr;         // for the callbacks
  const ObjectSet* owner = nullptr;  // for the hits
  const Node* nodes = nullptr;
  uint32_t node_count = 0;
  double center[8] = {0, 0, 0};  // x, y, z, and what a kernel may load behind them
  const double* spheres = nullptr;
  uint32_t sphere_count = 0;
  const FlatObjects* flat = nullptr;
  const ObjectKey* keys = nullptr;  // of all objects
  const uint32_t* unbounded = nullptr;
  uint32_t unbounded_count = 0;
  const uint8_t* opaque = nullptr;  // by placement
  bool all_opaque = false;
  TraceCallbacks callbacks;
};

// Places on a screen as their eye sees them, corner + place[0] * step[0] + place[1] * step[1] from
// it. Rows as in AimRows.
struct ScreenRows {
  const double* place[2];
  uint32_t count;
  double corner[3], step[2][3];
  double* direction[3];  // as Normalize leaves it
};

// Points and where something stands as seen from them. Rows are read and written in groups of
// eight: there must be room, and in the last group numbers that can be computed with.
struct AimRows {
  const double* point[3];
  const double* normal[3];
  uint32_t count;
  double position[3];
  double* toward[3];  // from point to position, as Normalize leaves it
  double* distance;
  double* cosine;  // of toward with the normal
};

// Shadow rays that all end at one position; rows as in AimRows. blocked, crossed as in
// ObjectSet::Block; crossed may be null. reach: at least the size of every coordinate.
struct ShadowRows {
  const double* origin[3];
  const double* direction[3];  // unit
  const double* limits;
  const double* times;
  double position[3];
  double reach;
  uint8_t* blocked;
  uint8_t* crossed;
  uint32_t count;
};

// Rays and a box. Rows as in AimRows; inverse: of the directions' components, none of which is 0.
struct BoxRows {
  const double* origin[3];
  const double* inverse[3];
  const double* limit;
  uint32_t count;  // at most 64
  double low[3], high[3];
};
// Intervals are taken for so much wider.
inline constexpr double kWiderBox = 1 + 4e-9;

// Which hits a light concerns, in rows as in AimRows; all bytes become 0 or 1, eight at a time.
struct SortRows {
  const double* toward[3];
  const double* cosine;  // with the shading normal
  const double* face[3];
  const double* slack;
  uint32_t count;
  uint8_t* by_row;  // slack is no reason to begin its shadow ray farther away than kShadowEpsilon
  uint8_t* dark;    // not so, or not before the light
};

// sum += cosine * diffuse * arrived, in this order, where dark is 0.
struct DiffuseRows {
  const uint8_t* dark;
  const double* cosine;
  const double* diffuse[3];
  double arrived[3];
  double* sum[3];
  uint32_t count;
};

// Which rows have a highlight that changes their sums: not where dark is 1, and not where the
// cosine of mirror and toward is below `least` and specular * arrived below kFaint times each sum.
inline constexpr double kFaint = 1000;
struct ShineRows {
  const uint8_t* dark;
  const double* toward[3];
  const double* mirror[3];
  const double* least;
  const double* specular;
  const double* sum[3];
  double arrived;
  uint32_t count;
  uint8_t* shines;
};

// One instruction set's kernels; blocked and crossed as in ObjectSet::Block, crossed may be null.
// All give the same bits.
struct Kernels {
  const char* name;
  void (*nearest)(const TraceView& view, const Ray* rays, Hit* hits, uint32_t count,
                  OpCounts* counts);
  void (*block)(const TraceView& view, const Ray* rays, const double* limits, uint8_t* blocked,
                uint8_t* crossed, uint32_t count, OpCounts* counts);
  void (*block_rows)(const TraceView& view, const ShadowRows& rows, OpCounts* counts);
  // Which rays are in the box somewhere between 0 and their limit: bits.
  uint64_t (*meet_box)(const BoxRows& rows);
  void (*look)(const ScreenRows& rows);
  void (*aim)(const AimRows& rows);
  void (*sort)(const SortRows& rows);
  void (*add_diffuse)(const DiffuseRows& rows);
  void (*shine)(const ShineRows& rows);
};

extern const Kernels kPlainKernels;
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;

// The best that this processor has, or what the environment variable RAYSHADE_SIMD (plain, avx2,
// avx512) names.
const Kernels& ChooseKernels();

}  // namespace rayshade
