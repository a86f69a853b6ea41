// Bundles of coherent rays through the hierarchy; part of trace.inl. Nodes are met by pyramids, and
// a stack entry knows which groups of rays met it; in the leaves every ray of these groups is
// tested exactly, eight at a time.

struct BundleEntry {
  uint64_t branch;
  float depth;
  uint32_t groups;  // bits
};

// Wider pyramids (by slope) are divided, or their rays traced one by one.
constexpr float kWidestBundle = 0.5f;
constexpr float kWidestShadowBundle = 0.04f;
constexpr float kWidestGroup = 0.02f;

// One sphere against the eight rays of a group: the very operations of IntersectSphere.
RAYSHADE_KERNEL uint32_t MeetSphere(const Bundle& b, int g, D8 x, D8 y, D8 z, D8 radius,
                                    D8* distance) {
  const D8 dx = LoadD(b.d[0][g]), dy = LoadD(b.d[1][g]), dz = LoadD(b.d[2][g]);
  const D8 cx = x - LoadD(b.o[0][g]), cy = y - LoadD(b.o[1][g]), cz = z - LoadD(b.o[2][g]);
  const D8 c = cx * dx + cy * dy + cz * dz;
  const D8 px = cx - c * dx, py = cy - c * dy, pz = cz - c * dz;
  const D8 discriminant = radius * radius - (px * px + py * py + pz * pz);
  const uint32_t real = LessEqual(SetD(0), discriminant);
  if (real == 0) return 0;
  const D8 root = Sqrt(discriminant);
  const D8 first = c - root, second = c + root, least = LoadD(b.least[g]);
  const D8 s = Choose(Less(least, first), first, second);
  *distance = s;
  return real & Less(least, s) & LessEqual(s, LoadD(b.best[g])) & Less(s, LoadD(b.strict[g]));
}

RAYSHADE_KERNEL bool BundleHitCounts(const TraceView& view, const Bundle& b, int ray,
                                     double distance, uint32_t object) {
  return distance <= kSureDistance ||
         view.callbacks.meets_box(view.set, b.rays[ray], object, distance);
}

// Returns whether a best distance changed.
RAYSHADE_KERNEL bool TakeNearest(const TraceView& view, Bundle* b, int g, uint32_t bits,
                                 D8 distances, uint32_t object, Hit* hits) {
  alignas(64) double at[8];
  Store(distances, at);
  const uint32_t rank = view.keys[object].rank;
  bool changed = false;
  for (; bits != 0; bits &= bits - 1) {
    const int lane = __builtin_ctz(bits), ray = 8 * g + lane;
    Hit& hit = hits[ray];
    if (at[lane] == hit.distance && rank >= hit.rank) continue;
    if (!BundleHitCounts(view, *b, ray, at[lane], object)) continue;
    hit.distance = b->best[g][lane] = at[lane];
    hit.rank = rank;
    hit.object = object;
    hit.set = view.owner;
    changed = true;
  }
  return changed;
}

RAYSHADE_KERNEL bool OthersNearest(const TraceView& view, Bundle* b, int g, uint32_t object,
                                   Hit* hits) {
  bool changed = false;
  for (int lane = 0; lane < 8; ++lane) {
    if (!b->has(g, lane)) continue;
    Hit& hit = hits[8 * g + lane];
    const uint32_t rank = hit.rank;
    view.callbacks.nearest_other(view.set, b->rays[8 * g + lane], object, b->strict[g][lane], &hit);
    if (hit.rank == rank) continue;
    hit.set = view.owner;
    b->best[g][lane] = hit.distance;
    changed = true;
  }
  return changed;
}

RAYSHADE_KERNEL void NearestInLeafOfBundle(const TraceView& view, Bundle* b, const BundleEntry& e,
                                           Hit* hits) {
  uint32_t changed = 0;
  const uint32_t first = ChildOf(e.branch), count = CountOf(e.branch);
  const LeafKind kind = KindOf(e.branch);
  const double* rows = view.spheres + 4 * static_cast<size_t>(first);
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t object = first + i;
    if (kind != kSphereLeaf) {
      for (uint32_t m = e.groups; m != 0; m &= m - 1) {
        const int g = __builtin_ctz(m);
        if (OthersNearest(view, b, g, object, hits)) changed |= 1u << g;
      }
      continue;
    }
    const D8 x = SetD(rows[i]), y = SetD(rows[count + i]), z = SetD(rows[2 * count + i]);
    const D8 radius = SetD(rows[3 * count + i]);
    for (uint32_t m = e.groups; m != 0; m &= m - 1) {
      const int g = __builtin_ctz(m);
      D8 distance;
      const uint32_t bits = MeetSphere(*b, g, x, y, z, radius, &distance);
      if (bits != 0 && TakeNearest(view, b, g, bits, distance, object, hits)) changed |= 1u << g;
    }
  }
  if (changed == 0) return;
  for (uint32_t m = changed; m != 0; m &= m - 1) UpdateMost(b, __builtin_ctz(m));
  UpdateWholeMost(b);
}

// Puts the children that the bundle meets on the stack, the nearest on top where `sorted`.
RAYSHADE_KERNEL BundleEntry* PushMet(const TraceView& view, const Bundle& b, const BundleEntry& e,
                                     bool sorted, BundleEntry* top) {
  const Node& node = view.nodes[ChildOf(e.branch)];
  const bool one = (e.groups & (e.groups - 1)) == 0;
  F8 depths;
  uint32_t bits = ChildrenInPyramid(b, node, one ? __builtin_ctz(e.groups) : -1, &depths);
  alignas(32) float depth[8];
  Store(depths, depth);
  BundleEntry* const bottom = top;
  for (; bits != 0; bits &= bits - 1) {
    const uint32_t i = static_cast<uint32_t>(__builtin_ctz(bits));
    const uint32_t groups = one ? e.groups : e.groups & GroupsAtChild(b, node, i);
    if (groups == 0) continue;
    const BundleEntry child{node.branch[i], depth[i], groups};
    BundleEntry* p = top++;
    for (; sorted && p > bottom && p[-1].depth < child.depth; --p) *p = p[-1];
    *p = child;
  }
  return top;
}

RAYSHADE_KERNEL uint32_t Tests(const BundleEntry& e) {
  return 8u * CountOf(e.branch) * static_cast<uint32_t>(__builtin_popcount(e.groups));
}

RAYSHADE_KERNEL void NearestOfBundle(const TraceView& view, Bundle* b, Hit* hits,
                                     Counters* counters) {
  BundleEntry stack[kStackSize];
  BundleEntry* top = stack;
  *top++ = {MakeBranch(kInnerNode, 0, 0), 0, (1u << b->groups) - 1};
  while (top != stack) {
    BundleEntry e = *--top;
    if (e.depth > b->whole.most) continue;
    e.groups &= LessEqual(SetF(e.depth), LoadF(b->most));
    if (e.groups == 0) continue;
    if (KindOf(e.branch) != kInnerNode) {
      counters->tests += Tests(e);
      NearestInLeafOfBundle(view, b, e, hits);
    } else {
      ++counters->nodes;
      top = PushMet(view, *b, e, true, top);
    }
  }
}

// Rays that are found blocked leave the bundle.
RAYSHADE_KERNEL void BlockInLeafOfBundle(const TraceView& view, Bundle* b, const BundleEntry& e,
                                         uint8_t* blocked) {
  uint32_t changed = 0;
  const uint32_t first = ChildOf(e.branch), count = CountOf(e.branch);
  const LeafKind kind = KindOf(e.branch);
  const double* rows = view.spheres + 4 * static_cast<size_t>(first);
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t object = first + i;
    const bool sphere = kind == kSphereLeaf;
    if (sphere && !view.all_opaque && !view.opaque[view.keys[object].placement]) continue;
    D8 x, y, z, radius;
    if (sphere) {
      x = SetD(rows[i]);
      y = SetD(rows[count + i]);
      z = SetD(rows[2 * count + i]);
      radius = SetD(rows[3 * count + i]);
    }
    for (uint32_t m = e.groups; m != 0; m &= m - 1) {
      const int g = __builtin_ctz(m);
      D8 distances = SetD(0);
      uint32_t bits = 0xff;
      if (sphere) bits = MeetSphere(*b, g, x, y, z, radius, &distances);
      if (bits == 0) continue;
      alignas(64) double at[8];
      Store(distances, at);
      for (; bits != 0; bits &= bits - 1) {
        const int lane = __builtin_ctz(bits), ray = 8 * g + lane;
        if (!b->has(g, lane)) continue;
        const bool blocks =
            sphere ? BundleHitCounts(view, *b, ray, at[lane], object)
                   : view.callbacks.blocks_other(view.set, b->rays[ray], object, b->best[g][lane]);
        if (!blocks) continue;
        blocked[ray] = 1;
        b->best[g][lane] = -1;
        changed |= 1u << g;
      }
    }
  }
  if (changed == 0) return;
  for (uint32_t m = changed; m != 0; m &= m - 1) {
    const int g = __builtin_ctz(m);
    if (Largest(LoadD(b->best[g])) < 0) b->most[g] = -1;
  }
}

RAYSHADE_KERNEL void BlockBundle(const TraceView& view, Bundle* b, uint8_t* blocked,
                                 Counters* counters) {
  BundleEntry stack[kStackSize];
  BundleEntry* top = stack;
  *top++ = {MakeBranch(kInnerNode, 0, 0), 0, (1u << b->groups) - 1};
  while (top != stack) {
    BundleEntry e = *--top;
    e.groups &= LessEqual(SetF(0), LoadF(b->most));
    if (e.groups == 0) continue;
    if (KindOf(e.branch) != kInnerNode) {
      counters->tests += Tests(e);
      BlockInLeafOfBundle(view, b, e, blocked);
    } else {
      ++counters->nodes;
      top = PushMet(view, *b, e, false, top);
    }
  }
}

RAYSHADE_KERNEL bool TryNearest(const TraceView& view, const Ray* rays, Hit* hits, uint32_t count,
                                float widest, Counters* counters) {
  Bundle b;
  LoadRays(rays, count, &b);
  for (int i = 0; i < 8 * b.groups; ++i) {
    const bool there = static_cast<uint32_t>(i) < count;
    b.best[i / 8][i % 8] = there ? hits[i].distance : -1;
    b.strict[i / 8][i % 8] = !there || hits[i].rank != kNoRank ? __builtin_inf() : hits[i].distance;
  }
  if (!SurroundRays(view, false, widest, &b)) return false;
  for (uint32_t k = 0; k < view.unbounded_count; ++k) {
    for (int g = 0; g < b.groups; ++g) OthersNearest(view, &b, g, view.unbounded[k], hits);
    counters->tests += count;
  }
  for (int g = 0; g < b.groups; ++g) UpdateMost(&b, g);
  UpdateWholeMost(&b);
  if (view.node_count != 0) NearestOfBundle(view, &b, hits, counters);
  return true;
}

RAYSHADE_KERNEL bool TryBlock(const TraceView& view, const Ray* rays, const double* limits,
                              uint8_t* blocked, uint32_t count, float widest, Counters* counters) {
  Bundle b;
  LoadRays(rays, count, &b);
  bool ended = true;
  for (int i = 0; i < 8 * b.groups; ++i) {
    const double limit = limits[static_cast<uint32_t>(i) < count ? i : static_cast<int>(count - 1)];
    b.best[i / 8][i % 8] = b.strict[i / 8][i % 8] = limit;
    if (!(limit < kEndless)) ended = false;
  }
  if (!SurroundRays(view, ended, widest, &b)) return false;
  for (int i = 0; i < 8 * b.groups; ++i) {
    if (static_cast<uint32_t>(i) >= count || blocked[i]) b.best[i / 8][i % 8] = -1;
  }
  for (uint32_t k = 0; k < view.unbounded_count; ++k) {
    counters->tests += count;
    for (uint32_t i = 0; i < count; ++i) {
      double& limit = b.best[i / 8][i % 8];
      if (limit < 0 || !view.callbacks.blocks_other(view.set, rays[i], view.unbounded[k], limit)) {
        continue;
      }
      blocked[i] = 1;
      limit = -1;
    }
  }
  for (int g = 0; g < b.groups; ++g) UpdateMost(&b, g);
  UpdateWholeMost(&b);
  if (view.node_count != 0) BlockBundle(view, &b, blocked, counters);
  return true;
}

RAYSHADE_KERNEL void NearestOfSome(const TraceView& view, const Ray* rays, Hit* hits,
                                   uint32_t count, Counters* counters) {
  if (count > 8 && TryNearest(view, rays, hits, count, kWidestBundle, counters)) return;
  for (uint32_t i = 0; i < count; i += 8) {
    const uint32_t size = count - i < 8 ? count - i : 8;
    if (size > 1 && TryNearest(view, rays + i, hits + i, size, kWidestGroup, counters)) continue;
    for (uint32_t k = i; k < i + size; ++k) {
      Hit hit = hits[k];
      NearestOfOne(view, rays[k], &hit, counters);
      if (hit.rank == hits[k].rank) continue;
      hit.set = view.owner;
      hits[k] = hit;
    }
  }
}

RAYSHADE_KERNEL void BlockSome(const TraceView& view, const Ray* rays, const double* limits,
                               uint8_t* blocked, uint32_t count, Counters* counters) {
  if (count > 8 && TryBlock(view, rays, limits, blocked, count, kWidestShadowBundle, counters)) {
    return;
  }
  for (uint32_t i = 0; i < count; i += 8) {
    const uint32_t size = count - i < 8 ? count - i : 8;
    if (size > 1 &&
        TryBlock(view, rays + i, limits + i, blocked + i, size, kWidestGroup, counters)) {
      continue;
    }
    for (uint32_t k = i; k < i + size; ++k) {
      if (!blocked[k]) blocked[k] = OneIsBlocked(view, rays[k], limits[k], counters);
    }
  }
}
