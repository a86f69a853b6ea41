// Single rays against a hierarchy of nodes with eight children; part of trace.inl.
//
//   1. A child is left out only if no computed hit can lie in it, nearer than or at the best
//   distance so far: planes are rounded outwards, origins are rounded both ways, and distances are
//   compared with kSlack to spare, which covers the rounding of inverse, difference, product and of
//   hits beyond kSureDistance.
//   2. Which children are visited, and in which order, does not change an answer.

constexpr uint32_t kPlaneBytes = kNodeWidth * sizeof(float);
constexpr float kSlack = 1.000001f;
constexpr double kSmallestDirection = 1e-30;

struct Counters {
  uint64_t nodes = 0;
  uint64_t lone_nodes = 0, lone_tests = 0;  // of all: not of a bundle
  uint64_t flat_tests[kOtherLeaf] = {};     // by the kind of the leaf
  KindCounts kinds[kGeomKinds];             // all else
};

// GeomSpec::index() of an object.
RAYSHADE_KERNEL uint32_t GeomOf(const TraceView& view, uint32_t object) {
  return object < view.sphere_count ? kSphereGeom
                                    : view.flat->items[object - view.sphere_count].geom;
}

// So many rays are tested against each object of a leaf. kind: the branch's, which the compiler
// knows where a list holds leaves of one kind.
RAYSHADE_KERNEL void CountTests(const TraceView& view, LeafKind kind, uint64_t branch,
                                uint32_t rays, Counters* counters) {
  const uint32_t first = ChildOf(branch), count = CountOf(branch);
  if (kind != kOtherLeaf) {
    counters->flat_tests[kind] += rays * count;
    return;
  }
  for (uint32_t i = first; i < first + count; ++i) counters->kinds[GeomOf(view, i)].tests += rays;
}
RAYSHADE_KERNEL void CountTest(const TraceView& view, uint32_t object, uint32_t rays,
                               Counters* counters) {
  counters->kinds[GeomOf(view, object)].tests += rays;
}
RAYSHADE_KERNEL void CountHit(const TraceView& view, uint32_t object, Counters* counters) {
  ++counters->kinds[GeomOf(view, object)].hits;
}

// A ray as the nodes see it: single precision, relative to the hierarchy's center.
struct SlabRay {
  float near_origin[3], far_origin[3], inverse[3], least;
  uint32_t near_plane[3], far_plane[3];  // as they lie in Node: bytes
};

// One ray at work.
struct RayWork {
  double o[3], d[3];
  double least;         // hits lie beyond
  double time;          // not used; it lies here in Ray, too
  double strict_limit;  // hits of strict kinds lie before
  double sure;          // hits beyond are checked against the object's box
  const Ray* ray;
  float rounded[8];  // origin, direction, least, time
};

RAYSHADE_KERNEL float FloatBelow(double x) {
  const float f = static_cast<float>(x);
  return f - __builtin_fabsf(f) * 1.2e-7f;
}
RAYSHADE_KERNEL float FloatAbove(double x) {
  const float f = static_cast<float>(x);
  return f + __builtin_fabsf(f) * 1.2e-7f;
}

// near_plane and far_plane, by which components of the direction are negative.
struct PlanesByDirection {
  uint32_t of[8][6];

  constexpr PlanesByDirection() : of() {
    for (uint32_t negative = 0; negative < 8; ++negative) {
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const uint32_t low = axis * kPlaneBytes, high = low + 3 * kPlaneBytes;
        const bool swap = (negative >> axis & 1) != 0;
        of[negative][axis] = swap ? high : low;
        of[negative][3 + axis] = swap ? low : high;
      }
    }
  }
};
constexpr PlanesByDirection kPlanesByDirection;

RAYSHADE_KERNEL void SetUp(const TraceView& view, const Ray& ray, RayWork* w, SlabRay* s) {
  // Origin, direction, least distance and time, as they lie in Ray and in RayWork.
  static_assert(__builtin_offsetof(Ray, time) == 7 * sizeof(double));
  static_assert(__builtin_offsetof(RayWork, time) == 7 * sizeof(double));
  const D8 all = LoadD(&ray.origin.x);
  Store(all, w->o);
  w->sure = kSureDistance;
  const double squared = w->d[0] * w->d[0] + w->d[1] * w->d[1] + w->d[2] * w->d[2];
  if (!(__builtin_fabs(squared - 1) < kUnitTolerance)) w->sure = -1;
  w->ray = &ray;
  Store(Rounded(all), w->rounded);
  const F8 relative = Rounded(all - LoadD(view.center));
  const F8 margin = Size(relative) * SetF(1.2e-7f);
  const F8 above = relative + margin, below = relative - margin;
  // The direction, in the lanes of the origin.
  const D8 direction = LoadD(&ray.direction.x), opposite = SetD(0) - direction;
  const uint32_t negative = Less(direction, SetD(0)) & 7;
  const F8 inverse = Rounded(SetD(1) / Max(SetD(kSmallestDirection), Max(direction, opposite)));
  // Three lanes each: the others are written again by what comes behind.
  static_assert(__builtin_offsetof(SlabRay, inverse) + 32 <= sizeof(SlabRay));
  Store(Choose(negative, below, above), s->near_origin);
  Store(Choose(negative, above, below), s->far_origin);
  Store(Choose(negative, SetF(0) - inverse, inverse), s->inverse);
  __builtin_memcpy(s->near_plane, kPlanesByDirection.of[negative], 6 * sizeof(uint32_t));
  s->least = FloatBelow(ray.min_distance) * (2 - kSlack);
}

// Where the ray enters and leaves the children; those that it does not meet, or farther away than
// `most` (in single precision, with slack), it leaves before it enters.
RAYSHADE_KERNEL void MeetChildren(const Node& node, const SlabRay& s, float most, F8* entry,
                                  F8* end) {
  F8 near = SetF(s.least), far = SetF(__builtin_inff());
  const auto plane = [&](uint32_t bytes) {
    return LoadF(reinterpret_cast<const float*>(reinterpret_cast<const char*>(&node) + bytes));
  };
  for (int axis = 0; axis < 3; ++axis) {
    const F8 inverse = SetF(s.inverse[axis]);
    near = Max((plane(s.near_plane[axis]) - SetF(s.near_origin[axis])) * inverse, near);
    far = Min((plane(s.far_plane[axis]) - SetF(s.far_origin[axis])) * inverse, far);
  }
  *entry = near;
  *end = Min(far * SetF(kSlack), SetF(most));
}

RAYSHADE_KERNEL float Loosened(double distance) { return FloatAbove(distance) * kSlack; }

RAYSHADE_KERNEL bool Counts(const TraceView& view, const RayWork& w, double distance,
                            uint32_t object) {
  return distance <= w.sure || view.callbacks.meets_box(view.set, *w.ray, object, distance);
}

RAYSHADE_KERNEL bool IsOpaque(const TraceView& view, uint32_t object) {
  return view.all_opaque || view.opaque[view.keys[object].placement];
}

// Those of up to eight spheres, one a lane, that a ray with a unit direction may hit in (least,
// most): bits; a look in single precision. A sphere that is hit has |c| <= |b| + radius. c, b and p
// are off by less than 13 roundings of that (c by 1, b by 5), and `off` has 33 of them: it widens
// the sphere by more than twice of what p is off by, so that what is left for the root stays larger
// than the true one, and the distances by what b and the root are off by.
RAYSHADE_KERNEL uint32_t SpheresOnRay(const double* rows, int count, const RayWork& w, float most) {
  const F8 dx = SetF(w.rounded[3]), dy = SetF(w.rounded[4]), dz = SetF(w.rounded[5]);
  const F8 cx = Rounded(LoadD(rows) - SetD(w.o[0]));
  const F8 cy = Rounded(LoadD(rows + count) - SetD(w.o[1]));
  const F8 cz = Rounded(LoadD(rows + 2 * count) - SetD(w.o[2]));
  const F8 radius = Rounded(LoadD(rows + 3 * count));
  const F8 b = cx * dx + cy * dy + cz * dz;
  const F8 px = cx - b * dx, py = cy - b * dy, pz = cz - b * dz;
  const F8 off = (Size(b) + radius) * SetF(2e-6f), reach = radius + off;
  const F8 squared = px * px + py * py + pz * pz, left = reach * reach - squared;
  // Both intersections lie beyond `most`, or before the least distance, where the root of what is
  // left is smaller than what the middle is away from there.
  const F8 beyond = b - SetF(most), before = SetF(w.rounded[6] * 0.999999f) - b;
  const F8 away = Max(Max(beyond, before) - off, SetF(0));
  return ~Less(left, away * away) & ((1u << count) - 1);
}

// A sphere against a ray: the very operations of IntersectSphere (geom/sphere.h), for a hit in
// (least, limit) and not beyond best.
RAYSHADE_KERNEL bool MeetSphere(const double* row, int stride, const RayWork& w, double best,
                                double* distance) {
  const double cx = row[0] - w.o[0], cy = row[stride] - w.o[1], cz = row[2 * stride] - w.o[2];
  const double radius = row[3 * stride];
  const double b = cx * w.d[0] + cy * w.d[1] + cz * w.d[2];
  const double px = cx - b * w.d[0], py = cy - b * w.d[1], pz = cz - b * w.d[2];
  const double discriminant = radius * radius - (px * px + py * py + pz * pz);
  if (!(discriminant >= 0)) return false;
  const double root = __builtin_sqrt(discriminant), first = b - root, second = b + root;
  const double s = first > w.least ? first : second;
  *distance = s;
  return s > w.least && s <= best && s < w.strict_limit;
}

// A ray whose direction is no number comes to empty slots, too.
RAYSHADE_KERNEL bool HasQuads(LeafKind kind) {
  return kind == kTriangleLeaf || kind == kPolygonLeaf;
}

// The objects of a leaf of this kind that the ray may hit not beyond `most` (in single precision,
// with slack): bits.
RAYSHADE_KERNEL uint32_t LookIntoLeaf(const TraceView& view, LeafKind kind, uint64_t branch,
                                      const RayWork& w, float most) {
  const uint32_t count = CountOf(branch);
  if (kind == kSphereLeaf && w.sure > 0) {
    return SpheresOnRay(view.spheres + 4 * static_cast<size_t>(ChildOf(branch)),
                        static_cast<int>(count), w, most);
  }
  if (HasQuads(kind)) return QuadsOnRay(view, branch, w.o, w.d, most);
  return (1u << count) - 1;
}

RAYSHADE_KERNEL void NearestInSpheres(const TraceView& view, const RayWork& w, uint32_t first,
                                      int count, uint32_t bits, Hit* hit) {
  const double* const rows = view.spheres + 4 * static_cast<size_t>(first);
  for (; bits != 0; bits &= bits - 1) {
    const uint32_t lane = static_cast<uint32_t>(__builtin_ctz(bits)), object = first + lane;
    double at;
    if (!MeetSphere(rows + lane, count, w, hit->distance, &at)) continue;
    const uint32_t rank = view.keys[object].rank;
    if (at == hit->distance && rank >= hit->rank) continue;
    if (!Counts(view, w, at, object)) continue;
    hit->distance = at;
    hit->rank = rank;
    hit->object = object;
  }
}

// Does an opaque sphere block the ray? Sets *crossed where a transparent one is met.
RAYSHADE_KERNEL bool SpheresBlock(const TraceView& view, const RayWork& w, uint32_t first,
                                  int count, uint32_t bits, double limit, uint8_t* crossed) {
  const double* const rows = view.spheres + 4 * static_cast<size_t>(first);
  for (; bits != 0; bits &= bits - 1) {
    const uint32_t lane = static_cast<uint32_t>(__builtin_ctz(bits)), object = first + lane;
    double at;
    if (!MeetSphere(rows + lane, count, w, limit, &at)) continue;
    if (!Counts(view, w, at, object)) continue;
    if (IsOpaque(view, object)) return true;
    *crossed = 1;
  }
  return false;
}

// Tests the objects of a leaf whose bits are set.
RAYSHADE_KERNEL void NearestInLeaf(const TraceView& view, LeafKind kind, const RayWork& w,
                                   uint64_t branch, uint32_t bits, Hit* hit) {
  const uint32_t first = ChildOf(branch);
  if (kind == kSphereLeaf) {
    NearestInSpheres(view, w, first, static_cast<int>(CountOf(branch)), bits, hit);
    return;
  }
  for (; bits != 0; bits &= bits - 1) {
    const uint32_t i = first + static_cast<uint32_t>(__builtin_ctz(bits));
    view.callbacks.nearest_other(view.set, *w.ray, i, w.strict_limit, hit);
  }
}

RAYSHADE_KERNEL bool OtherBlocks(const TraceView& view, const Ray& ray, uint32_t object,
                                 double limit, uint8_t* crossed) {
  const Meeting meeting = view.callbacks.meets_other(view.set, ray, object, limit);
  if (meeting == Meeting::kTransparent) *crossed = 1;
  return meeting == Meeting::kOpaque;
}

RAYSHADE_KERNEL bool LeafBlocks(const TraceView& view, LeafKind kind, const RayWork& w,
                                uint64_t branch, uint32_t bits, double limit, uint8_t* crossed,
                                Counters* counters) {
  const uint32_t first = ChildOf(branch);
  if (kind == kSphereLeaf) {
    const int count = static_cast<int>(CountOf(branch));
    if (!SpheresBlock(view, w, first, count, bits, limit, crossed)) return false;
    CountHit(view, first, counters);
    return true;
  }
  for (; bits != 0; bits &= bits - 1) {
    const uint32_t i = first + static_cast<uint32_t>(__builtin_ctz(bits));
    if (!OtherBlocks(view, *w.ray, i, limit, crossed)) continue;
    CountHit(view, i, counters);
    return true;
  }
  return false;
}

// The distance before which hits of strict kinds must lie: the limit, where the hit is none yet.
RAYSHADE_KERNEL double StrictLimit(const Hit& hit) {
  return hit.rank == kNoRank ? hit.distance : __builtin_inf();
}
