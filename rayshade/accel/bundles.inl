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
constexpr float kWidestShadowBundle = 0.08f;
constexpr float kWidestShadowGroup = 0.08f;
constexpr float kWidestGroup = 0.08f;
// Of neighbouring groups, and of one group with a slope for each ray. Spheres cost a ray that is
// alone so little that wide pyramids do not pay, and groups by themselves never do.
struct ShadowWidths {
  float run, packet;
};
constexpr ShadowWidths kWidest = {0.1f, 0.1f}, kWidestAmongSpheres = {0.03f, 0};
// Work that a bundle may be for each of its groups.
constexpr int kNearestPatience = 100;
constexpr int kBlockPatience = 60;
constexpr int kLoneGroupPatience = 30;

RAYSHADE_KERNEL bool BundleHitCounts(const TraceView& view, const Bundle& b, int ray,
                                     double distance, const LeafObject& o) {
  if (distance <= kSureDistance && !o.box_decides) return true;
  return view.callbacks.meets_box(view.set, RayOf(b, ray), o.object, distance);
}

// Returns whether a best distance changed.
RAYSHADE_KERNEL bool TakeNearest(const TraceView& view, Bundle* b, int g, const Met& met,
                                 const LeafObject& o, Hit* hits) {
  alignas(64) double at[8];
  Store(met.distance, at);
  const uint32_t rank = view.keys[o.object].rank;
  bool changed = false;
  for (uint32_t bits = met.hit; bits != 0; bits &= bits - 1) {
    const int lane = __builtin_ctz(bits), ray = 8 * g + lane;
    Hit& hit = hits[ray];
    if (at[lane] == hit.distance && rank >= hit.rank) continue;
    if (!BundleHitCounts(view, *b, ray, at[lane], o)) continue;
    hit.distance = b->best[g][lane] = at[lane];
    hit.rank = rank;
    hit.object = o.object;
    hit.set = view.owner;
    changed = true;
  }
  return changed;
}

// The rays of a group whose bits are set, by callback.
RAYSHADE_KERNEL bool AskNearest(const TraceView& view, Bundle* b, int g, uint32_t bits,
                                uint32_t object, Hit* hits) {
  bool changed = false;
  for (; bits != 0; bits &= bits - 1) {
    const int lane = __builtin_ctz(bits);
    if (!b->has(g, lane)) continue;
    Hit& hit = hits[8 * g + lane];
    const uint32_t rank = hit.rank;
    view.callbacks.nearest_other(view.set, RayOf(*b, 8 * g + lane), object, b->strict[g][lane],
                                 &hit);
    if (hit.rank == rank) continue;
    hit.set = view.owner;
    b->best[g][lane] = hit.distance;
    changed = true;
  }
  return changed;
}

RAYSHADE_ROUTINE void NearestInLeafOfBundle(const TraceView& view, Bundle* b, const BundleEntry& e,
                                            Hit* hits) {
  SeenLeaf leaf;
  SeenParts parts;
  SeeLeaf(view, *b, e.branch, &leaf);
  uint32_t changed = 0;
  for (uint32_t left = leaf.bits; left != 0; left &= left - 1) {
    const uint32_t i = static_cast<uint32_t>(__builtin_ctz(left));
    const LeafObject o = ObjectOfLeaf(view, e.branch, i);
    for (uint32_t m = e.groups; m != 0; m &= m - 1) {
      const int g = __builtin_ctz(m);
      uint32_t may = RaysThatMayMeet(*b, g, leaf, o.kind, i);
      if (may != 0 && IsInParts(o)) {
        may = RaysAtParts(view, *b, g, *o.polygon, may, &parts, nullptr);
      }
      if (may == 0) continue;
      const Met met = MeetObject(*b, g, o);
      if (met.hit != 0 && TakeNearest(view, b, g, met, o, hits)) changed |= 1u << g;
      const uint32_t unsure = met.unsure & may;
      if (unsure != 0 && AskNearest(view, b, g, unsure, o.object, hits)) changed |= 1u << g;
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

RAYSHADE_KERNEL uint32_t RaysIn(const BundleEntry& e) {
  return 8u * static_cast<uint32_t>(__builtin_popcount(e.groups));
}

// How much work a bundle has been for each of its groups; false: so much that its rays are better
// off in smaller bundles, or alone. What was found until then stays valid.
RAYSHADE_KERNEL bool PaysOff(int groups, const BundleEntry& e, int patience, int* work) {
  const bool leaf = KindOf(e.branch) != kInnerNode;
  *work += leaf ? static_cast<int>(CountOf(e.branch)) * __builtin_popcount(e.groups) : 1;
  return *work <= (groups == 1 ? kLoneGroupPatience : patience * groups);
}

// Returns false where it gave up.
RAYSHADE_ROUTINE bool NearestOfBundle(const TraceView& view, Bundle* b, Hit* hits,
                                      Counters* counters) {
  BundleEntry stack[kStackSize];
  BundleEntry* top = stack;
  int work = 0;
  *top++ = {MakeBranch(kInnerNode, 0, 0), 0, (1u << b->groups) - 1};
  while (top != stack) {
    BundleEntry e = *--top;
    if (e.depth > b->whole.most) continue;
    e.groups &= LessEqual(SetF(e.depth), LoadF(b->most));
    if (e.groups == 0) continue;
    if (!PaysOff(b->groups, e, kNearestPatience, &work)) return false;
    if (KindOf(e.branch) != kInnerNode) {
      CountTests(view, KindOf(e.branch), e.branch, RaysIn(e), counters);
      NearestInLeafOfBundle(view, b, e, hits);
    } else {
      ++counters->nodes;
      top = PushMet(view, *b, e, true, top);
    }
  }
  return true;
}

RAYSHADE_KERNEL Meeting MeetingOf(const TraceView& view, const Bundle& b, int ray, bool sure,
                                  double distance, const LeafObject& o, bool opaque) {
  if (!sure) {
    // Others decide for themselves.
    return view.callbacks.meets_other(view.set, RayOf(b, ray), o.object, b.best[ray / 8][ray % 8]);
  }
  if (!BundleHitCounts(view, b, ray, distance, o)) return Meeting::kNothing;
  return opaque ? Meeting::kOpaque : Meeting::kTransparent;
}

// Rays that are found blocked leave the bundle.
RAYSHADE_ROUTINE void BlockInLeafOfBundle(const TraceView& view, Bundle* b, const BundleEntry& e,
                                          const Fate& fate, Counters* counters) {
  SeenLeaf leaf;
  SeenParts parts;
  SeeLeaf(view, *b, e.branch, &leaf);
  for (uint32_t left = leaf.bits; left != 0; left &= left - 1) {
    const uint32_t i = static_cast<uint32_t>(__builtin_ctz(left));
    const LeafObject o = ObjectOfLeaf(view, e.branch, i);
    const bool opaque = o.kind == kOtherLeaf || IsOpaque(view, o.object);
    if (!opaque && fate.crossed == nullptr) continue;
    for (uint32_t m = GroupsThatMayMeet(*b, leaf, o.kind, i, e.groups); m != 0; m &= m - 1) {
      const int g = __builtin_ctz(m);
      uint32_t surely;
      uint32_t may = RaysThatMayMeet(*b, g, leaf, o.kind, i, &surely);
      if (may != 0 && IsInParts(o)) {
        may = RaysAtParts(view, *b, g, *o.polygon, may, &parts, &surely);
      }
      if (may == 0) continue;
      if (opaque && surely != 0) {
        b->live[g] &= ~surely;
        if (b->live[g] == 0) b->most[g] = -1;
        for (uint32_t bits = surely; bits != 0; bits &= bits - 1) {
          fate.blocked[8 * g + __builtin_ctz(bits)] = 1;
          CountHit(view, o.object, counters);
        }
        if (may == surely) continue;
      }
      const Met met = MeetObject(*b, g, o);
      const uint32_t met_bits = (met.hit | met.unsure) & may & b->live[g];
      if (met_bits == 0) continue;
      alignas(64) double at[8];
      Store(met.distance, at);
      for (uint32_t bits = met_bits; bits != 0; bits &= bits - 1) {
        const int lane = __builtin_ctz(bits), ray = 8 * g + lane;
        const bool sure = (met.hit >> lane & 1) != 0;
        const Meeting meeting = MeetingOf(view, *b, ray, sure, at[lane], o, opaque);
        if (meeting == Meeting::kTransparent && fate.crossed != nullptr) fate.crossed[ray] = 1;
        if (meeting != Meeting::kOpaque) continue;
        fate.blocked[ray] = 1;
        b->best[g][lane] = -1;
        b->live[g] &= ~(1u << lane);
        CountHit(view, o.object, counters);
      }
      if (b->live[g] == 0) b->most[g] = -1;
    }
  }
}

// run: bits of the groups.
RAYSHADE_ROUTINE bool BlockBundle(const TraceView& view, Bundle* b, uint32_t run, const Fate& fate,
                                  Counters* counters) {
  BundleEntry stack[kStackSize];
  BundleEntry* top = stack;
  const int groups = __builtin_popcount(run);
  int work = 0;
  *top++ = {MakeBranch(kInnerNode, 0, 0), 0, run};
  while (top != stack) {
    BundleEntry e = *--top;
    e.groups &= LessEqual(SetF(0), LoadF(b->most));
    if (e.groups == 0) continue;
    if (!PaysOff(groups, e, kBlockPatience, &work)) return false;
    if (KindOf(e.branch) != kInnerNode) {
      CountTests(view, KindOf(e.branch), e.branch, RaysIn(e), counters);
      BlockInLeafOfBundle(view, b, e, fate, counters);
    } else {
      ++counters->nodes;
      top = PushMet(view, *b, e, false, top);
    }
  }
  return true;
}

// Are these rays surely too wide apart for one pyramid? Asks the first, the middle and the last.
RAYSHADE_KERNEL bool TooWide(const Ray* rays, uint32_t count, double widest) {
  const Vector first = rays[0].direction;
  const double a[3] = {first.x, first.y, first.z};
  const int w = LargestAxis(a), u = FirstAcross(w), v = SecondAcross(w);
  bool apart = false;
  for (const uint32_t i : {count / 2, count - 1}) {
    const Vector other = rays[i].direction;
    const double b[3] = {other.x, other.y, other.z};
    const double scale = a[w] * b[w];  // slopes are compared without a division
    apart |= !(scale > 0) | (__builtin_fabs(b[u] * a[w] - a[u] * b[w]) > widest * scale) |
             (__builtin_fabs(b[v] * a[w] - a[v] * b[w]) > widest * scale);
  }
  return apart;
}

RAYSHADE_ROUTINE bool TryNearest(const TraceView& view, const Ray* rays, const double* strict,
                                 Hit* hits, uint32_t count, float widest, Counters* counters) {
  Bundle b;
  LoadRays(rays, count, &b);
  for (int i = 0; i < 8 * b.groups; ++i) {
    const bool there = static_cast<uint32_t>(i) < count;
    b.best[i / 8][i % 8] = there ? hits[i].distance : -1;
    b.strict[i / 8][i % 8] = there ? strict[i] : __builtin_inf();
  }
  for (int g = 0; g < b.groups; ++g) b.live[g] = LessEqual(SetD(0), LoadD(b.best[g]));
  if (!SurroundRays(view, false, widest, &b)) return false;
  for (uint32_t k = 0; k < view.unbounded_count; ++k) {
    for (int g = 0; g < b.groups; ++g) AskNearest(view, &b, g, 0xff, view.unbounded[k], hits);
    CountTest(view, view.unbounded[k], count, counters);
  }
  for (int g = 0; g < b.groups; ++g) UpdateMost(&b, g);
  UpdateWholeMost(&b);
  return view.node_count == 0 || NearestOfBundle(view, &b, hits, counters);
}

RAYSHADE_ROUTINE bool TryBlock(const TraceView& view, const Ray* rays, const double* limits,
                               const Fate& fate, uint32_t count, float widest, Counters* counters) {
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
    if (static_cast<uint32_t>(i) >= count || fate.blocked[i]) b.best[i / 8][i % 8] = -1;
  }
  for (int g = 0; g < b.groups; ++g) b.live[g] = LessEqual(SetD(0), LoadD(b.best[g]));
  for (uint32_t k = 0; k < view.unbounded_count; ++k) {
    CountTest(view, view.unbounded[k], count, counters);
    for (uint32_t i = 0; i < count; ++i) {
      double& limit = b.best[i / 8][i % 8];
      uint8_t met = 0;
      if (limit < 0) continue;
      if (OtherBlocks(view, rays[i], view.unbounded[k], limit, &met)) {
        fate.blocked[i] = 1;
        limit = -1;
        b.live[i / 8] &= ~(1u << i % 8);
        CountHit(view, view.unbounded[k], counters);
      } else if (met && fate.crossed != nullptr) {
        fate.crossed[i] = 1;
      }
    }
  }
  for (int g = 0; g < b.groups; ++g) UpdateMost(&b, g);
  UpdateWholeMost(&b);
  return view.node_count == 0 || BlockBundle(view, &b, (1u << b.groups) - 1, fate, counters);
}

// Appends the rays that are better off alone.
RAYSHADE_KERNEL void NearestOfSome(const TraceView& view, const Ray* rays, Hit* hits,
                                   uint32_t first, uint32_t count, LoneRays* lone,
                                   Counters* counters) {
  double strict[kBundleSize];
  for (uint32_t i = 0; i < count; ++i) strict[i] = StrictLimit(hits[first + i]);
  const auto traced = [&](uint32_t i, uint32_t size, float widest) {
    return size > 1 && !TooWide(rays + first + i, size, widest) &&
           TryNearest(view, rays + first + i, strict + i, hits + first + i, size, widest, counters);
  };
  if (count > 8 && traced(0, count, kWidestBundle)) return;
  for (uint32_t i = 0; i < count; i += 8) {
    const uint32_t size = count - i < 8 ? count - i : 8;
    if (traced(i, size, kWidestGroup)) continue;
    for (uint32_t k = i; k < i + size; ++k) lone->Append(first + k, strict[k]);
  }
}

RAYSHADE_ROUTINE void NearestOfMany(const TraceView& view, const Ray* rays, Hit* hits,
                                    uint32_t count, Counters* counters) {
  LoneRays lone;
  uint32_t before[kLoneMost];
  for (uint32_t i = 0; i < count; ++i) before[i] = hits[i].rank;
  for (uint32_t i = 0; i < count; i += kBundleSize) {
    const uint32_t size = count - i < kBundleSize ? count - i : kBundleSize;
    NearestOfSome(view, rays, hits, i, size, &lone, counters);
  }
  NearestOfLone(view, rays, hits, lone.rays, lone.count, counters);
  for (uint32_t i = 0; i < count; ++i) {
    if (hits[i].rank != before[i]) CountHit(view, hits[i].object, counters);
  }
}

RAYSHADE_KERNEL Fate FateFrom(const Fate& fate, uint32_t first) {
  return {fate.blocked + first, fate.crossed == nullptr ? nullptr : fate.crossed + first};
}

// A pyramid that is too wide is halved, as long as more than a group is left. Appends the rays that
// are better off alone.
RAYSHADE_ROUTINE void BlockSome(const TraceView& view, const Ray* rays, const double* limits,
                                const Fate& fate, uint32_t first, uint32_t count, LoneRays* lone,
                                Counters* counters) {
  const float widest = count > 8 ? kWidestShadowBundle : kWidestShadowGroup;
  if (count > 1 && TryBlock(view, rays + first, limits + first, FateFrom(fate, first), count,
                            widest, counters)) {
    return;
  }
  if (count <= 8) {
    for (uint32_t i = first; i < first + count; ++i) {
      if (!fate.blocked[i]) lone->Append(i, limits[i]);
    }
    return;
  }
  const uint32_t half = (count + 15) / 16 * 8;
  BlockSome(view, rays, limits, fate, first, half, lone, counters);
  BlockSome(view, rays, limits, fate, first + half, count - half, lone, counters);
}

RAYSHADE_ROUTINE void BlockMany(const TraceView& view, const Ray* rays, const double* limits,
                                const Fate& fate, uint32_t count, Counters* counters) {
  LoneRays lone;
  for (uint32_t i = 0; i < count; i += kBundleSize) {
    const uint32_t size = count - i < kBundleSize ? count - i : kBundleSize;
    BlockSome(view, rays, limits, fate, i, size, &lone, counters);
  }
  BlockLone(view, rays, lone.rays, lone.count, fate, counters);
}
