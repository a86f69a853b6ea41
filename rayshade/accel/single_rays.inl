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
  uint64_t flat_tests[kOtherLeaf] = {};  // by the kind of the leaf
  KindCounts kinds[kGeomKinds];          // all else
};

// GeomSpec::index() of an object.
RAYSHADE_KERNEL uint32_t GeomOf(const TraceView& view, uint32_t object) {
  return object < view.sphere_count ? kSphereGeom
                                    : view.flat->items[object - view.sphere_count].geom;
}

// So many rays are tested against each object of a leaf.
RAYSHADE_KERNEL void CountTests(const TraceView& view, uint64_t branch, uint32_t rays,
                                Counters* counters) {
  const uint32_t first = ChildOf(branch), count = CountOf(branch);
  if (KindOf(branch) != kOtherLeaf) {
    counters->flat_tests[KindOf(branch)] += rays * count;
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
};

RAYSHADE_KERNEL float FloatBelow(double x) {
  const float f = static_cast<float>(x);
  return f - __builtin_fabsf(f) * 1.2e-7f;
}
RAYSHADE_KERNEL float FloatAbove(double x) {
  const float f = static_cast<float>(x);
  return f + __builtin_fabsf(f) * 1.2e-7f;
}

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
  const F8 relative = Rounded(all - LoadD(view.center));
  const F8 margin = Size(relative) * SetF(1.2e-7f);
  const F8 inverse = Rounded(SetD(1) / Max(SetD(kSmallestDirection), Max(all, SetD(0) - all)));
  alignas(32) float above[8], below[8], inverses[8];
  Store(relative + margin, above);
  Store(relative - margin, below);
  Store(inverse, inverses);
  for (int axis = 0; axis < 3; ++axis) {
    const bool negative = __builtin_signbit(w->d[axis]);
    s->near_origin[axis] = negative ? below[axis] : above[axis];
    s->far_origin[axis] = negative ? above[axis] : below[axis];
    s->inverse[axis] = negative ? -inverses[3 + axis] : inverses[3 + axis];
    const auto low = static_cast<uint32_t>(axis) * kPlaneBytes, high = low + 3 * kPlaneBytes;
    s->near_plane[axis] = negative ? high : low;
    s->far_plane[axis] = negative ? low : high;
  }
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

// Up to eight spheres, one a lane, against a ray: the very operations of IntersectSphere
// (geom/sphere.h). Bits of those hit in (least, limit) and not beyond best; *distance: where.
RAYSHADE_KERNEL uint32_t MeetSpheres(const double* rows, int count, const RayWork& w, double best,
                                     D8* distance) {
  const D8 dx = SetD(w.d[0]), dy = SetD(w.d[1]), dz = SetD(w.d[2]);
  const D8 cx = LoadD(rows) - SetD(w.o[0]);
  const D8 cy = LoadD(rows + count) - SetD(w.o[1]);
  const D8 cz = LoadD(rows + 2 * count) - SetD(w.o[2]);
  const D8 radius = LoadD(rows + 3 * count);
  const D8 b = cx * dx + cy * dy + cz * dz;
  const D8 px = cx - b * dx, py = cy - b * dy, pz = cz - b * dz;
  const D8 discriminant = radius * radius - (px * px + py * py + pz * pz);
  const uint32_t real = LessEqual(SetD(0), discriminant) & ((1u << count) - 1);
  if (real == 0) return 0;
  const D8 root = Sqrt(discriminant);
  const D8 first = b - root, second = b + root, least = SetD(w.least);
  const D8 s = Choose(Less(least, first), first, second);
  *distance = s;
  return real & Less(least, s) & LessEqual(s, SetD(best)) & Less(s, SetD(w.strict_limit));
}

RAYSHADE_KERNEL void NearestInSpheres(const TraceView& view, const RayWork& w, uint32_t first,
                                      int count, Hit* hit) {
  D8 distance;
  uint32_t bits = MeetSpheres(view.spheres + 4 * static_cast<size_t>(first), count, w,
                              hit->distance, &distance);
  if (bits == 0) return;
  alignas(64) double at[8];
  Store(distance, at);
  for (; bits != 0; bits &= bits - 1) {
    const uint32_t lane = static_cast<uint32_t>(__builtin_ctz(bits)), object = first + lane;
    if (at[lane] > hit->distance) continue;
    const uint32_t rank = view.keys[object].rank;
    if (at[lane] == hit->distance && rank >= hit->rank) continue;
    if (!Counts(view, w, at[lane], object)) continue;
    hit->distance = at[lane];
    hit->rank = rank;
    hit->object = object;
  }
}

// Does an opaque sphere block the ray? Sets *crossed where a transparent one is met.
RAYSHADE_KERNEL bool SpheresBlock(const TraceView& view, const RayWork& w, uint32_t first,
                                  int count, double limit, uint8_t* crossed) {
  D8 distance;
  uint32_t bits =
      MeetSpheres(view.spheres + 4 * static_cast<size_t>(first), count, w, limit, &distance);
  if (bits == 0) return false;
  alignas(64) double at[8];
  Store(distance, at);
  for (; bits != 0; bits &= bits - 1) {
    const uint32_t lane = static_cast<uint32_t>(__builtin_ctz(bits)), object = first + lane;
    if (!Counts(view, w, at[lane], object)) continue;
    if (IsOpaque(view, object)) return true;
    *crossed = 1;
  }
  return false;
}

// A ray whose direction is no number comes to empty slots, too.
RAYSHADE_KERNEL bool HasQuads(uint64_t branch) {
  return KindOf(branch) == kTriangleLeaf || KindOf(branch) == kPolygonLeaf;
}

RAYSHADE_KERNEL void NearestInLeaf(const TraceView& view, const RayWork& w, uint64_t branch,
                                   Hit* hit) {
  const uint32_t first = ChildOf(branch), count = CountOf(branch);
  if (KindOf(branch) == kSphereLeaf) {
    NearestInSpheres(view, w, first, static_cast<int>(count), hit);
    return;
  }
  uint32_t bits = (1u << count) - 1;
  if (HasQuads(branch)) bits = QuadsOnRay(view, branch, w.o, w.d, Loosened(hit->distance));
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

RAYSHADE_KERNEL bool LeafBlocks(const TraceView& view, const RayWork& w, uint64_t branch,
                                double limit, uint8_t* crossed, Counters* counters) {
  const uint32_t first = ChildOf(branch), count = CountOf(branch);
  if (KindOf(branch) == kSphereLeaf) {
    if (!SpheresBlock(view, w, first, static_cast<int>(count), limit, crossed)) return false;
    CountHit(view, first, counters);
    return true;
  }
  uint32_t bits = (1u << count) - 1;
  if (HasQuads(branch)) bits = QuadsOnRay(view, branch, w.o, w.d, Loosened(limit));
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
