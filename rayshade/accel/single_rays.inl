// Single rays against a hierarchy of nodes with eight children; part of trace.inl.
//
//   1. A child is left out only if no computed hit can lie in it, nearer than or at the best
//   distance so far: planes are rounded outwards, origins are rounded both ways, and distances are
//   compared with kSlack to spare, which covers the rounding of inverse, difference, product and of
//   hits beyond kSureDistance.
//   2. Which children are visited, and in which order, does not change an answer.

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
  F8 near_origin[3], far_origin[3], inverse[3], far_inverse[3], least;
  int near_plane[3], far_plane[3];
};

// One ray at work.
struct RayWork {
  double o[3], d[3];
  double least;         // hits lie beyond
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
  const double o[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const double d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    w->o[axis] = o[axis];
    w->d[axis] = d[axis];
    squared += d[axis] * d[axis];
    const bool negative = __builtin_signbit(d[axis]);
    const double size = __builtin_fabs(d[axis]);
    const double clamped = size < kSmallestDirection ? kSmallestDirection : size;
    const float inverse = static_cast<float>(1.0 / (negative ? -clamped : clamped));
    const double relative = o[axis] - view.center[axis];
    const float above = FloatAbove(relative), below = FloatBelow(relative);
    s->near_origin[axis] = SetF(negative ? below : above);
    s->far_origin[axis] = SetF(negative ? above : below);
    s->inverse[axis] = SetF(inverse);
    s->far_inverse[axis] = SetF(inverse * kSlack);
    s->near_plane[axis] = negative ? 3 + axis : axis;
    s->far_plane[axis] = negative ? axis : 3 + axis;
  }
  s->least = SetF(FloatBelow(ray.min_distance) * (2 - kSlack));
  w->least = ray.min_distance;
  w->sure = __builtin_fabs(squared - 1) < kUnitTolerance ? kSureDistance : -1;
  w->ray = &ray;
}

// The children that the ray meets not farther away than `most` (in single precision, with slack);
// *entry: where.
RAYSHADE_KERNEL uint32_t MeetChildren(const Node& node, const SlabRay& s, float most, F8* entry) {
  F8 near = s.least, far = SetF(most);
  for (int axis = 0; axis < 3; ++axis) {
    near =
        Max((LoadF(node.plane[s.near_plane[axis]]) - s.near_origin[axis]) * s.inverse[axis], near);
    far =
        Min((LoadF(node.plane[s.far_plane[axis]]) - s.far_origin[axis]) * s.far_inverse[axis], far);
  }
  *entry = near;
  return LessEqual(near, far);
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
  CountTests(view, branch, 1, counters);
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

// What is still to be visited; room for eight more than can be needed, since pushing stores eight.
struct Stack {
  uint64_t branch[kStackSize + 8];
  float entry[kStackSize + 8];
};

// The distance before which hits of strict kinds must lie: the limit, where the hit is none yet.
RAYSHADE_KERNEL double StrictLimit(const Hit& hit) {
  return hit.rank == kNoRank ? hit.distance : __builtin_inf();
}

RAYSHADE_ROUTINE void NearestOfOne(const TraceView& view, const Ray& ray, double strict_limit,
                                   Hit* hit, Counters* counters) {
  RayWork w;
  SlabRay s;
  SetUp(view, ray, &w, &s);
  w.strict_limit = strict_limit;
  for (uint32_t i = 0; i < view.unbounded_count; ++i) {
    view.callbacks.nearest_other(view.set, ray, view.unbounded[i], w.strict_limit, hit);
    CountTest(view, view.unbounded[i], 1, counters);
  }
  if (view.node_count == 0) return;
  Stack stack;
  uint32_t top = 0;
  uint64_t branch = MakeBranch(kInnerNode, 0, 0);
  float most = Loosened(hit->distance);
  for (;;) {
    if (KindOf(branch) == kInnerNode) {
      ++counters->nodes;
      const Node& node = view.nodes[ChildOf(branch)];
      F8 entries;
      uint32_t bits = MeetChildren(node, s, most, &entries);
      if (bits != 0) {
        // The nearest child is next, the others wait.
        const F8 met = Choose(bits, entries, SetF(__builtin_inff()));
        const uint32_t nearest = LessEqual(met, SetF(Least(met)));
        // None is the nearest where the ray's direction is no number.
        const uint32_t i = static_cast<uint32_t>(__builtin_ctz(nearest != 0 ? nearest : bits));
        branch = node.branch[i];
        bits &= ~(1u << i);
        Compress(bits, entries, stack.entry + top);
        Compress(bits, node.branch, stack.branch + top);
        top += static_cast<uint32_t>(__builtin_popcount(bits));
        continue;
      }
    } else {
      CountTests(view, branch, 1, counters);
      NearestInLeaf(view, w, branch, hit);
      most = Loosened(hit->distance);
    }
    do {
      if (top == 0) return;
      --top;
    } while (stack.entry[top] > most);
    branch = stack.branch[top];
  }
}

RAYSHADE_ROUTINE bool OneIsBlocked(const TraceView& view, const Ray& ray, double limit,
                                   uint8_t* crossed, Counters* counters) {
  for (uint32_t i = 0; i < view.unbounded_count; ++i) {
    CountTest(view, view.unbounded[i], 1, counters);
    if (!OtherBlocks(view, ray, view.unbounded[i], limit, crossed)) continue;
    CountHit(view, view.unbounded[i], counters);
    return true;
  }
  if (view.node_count == 0) return false;
  RayWork w;
  SlabRay s;
  SetUp(view, ray, &w, &s);
  w.strict_limit = limit;
  const float most = Loosened(limit);
  uint64_t stack[kStackSize + 8];
  uint32_t top = 0;
  stack[top++] = MakeBranch(kInnerNode, 0, 0);
  while (top != 0) {
    const uint64_t branch = stack[--top];
    if (KindOf(branch) != kInnerNode) {
      if (LeafBlocks(view, w, branch, limit, crossed, counters)) return true;
      continue;
    }
    ++counters->nodes;
    const Node& node = view.nodes[ChildOf(branch)];
    F8 entries;
    const uint32_t bits = MeetChildren(node, s, most, &entries);
    Compress(bits, node.branch, stack + top);
    top += static_cast<uint32_t>(__builtin_popcount(bits));
  }
  return false;
}
