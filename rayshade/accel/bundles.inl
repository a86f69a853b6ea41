// Bundles of coherent rays through the hierarchy; part of trace.inl. Nodes are met by pyramids, and
// a stack entry knows which groups of rays met it; in the leaves every ray of these groups is
// tested exactly, eight at a time.

struct BundleEntry {
  const Node* parent;
  float depth;
  uint16_t lane;    // in the parent
  uint16_t groups;  // bits
};

constexpr Node kAboveRoot = {{}, {uint64_t{kInnerNode} << kKindShift}};

RAYSHADE_KERNEL uint64_t BranchOf(const BundleEntry& e) { return e.parent->branch[e.lane]; }

// Wider pyramids (by slope) are divided, or their rays traced one by one.
constexpr float kWidestBundle = 0.5f;
constexpr float kWidestShadowBundle = 0.08f;
constexpr float kWidestShadowGroup = 0.08f;
constexpr float kWidestGroup = 0.08f;
// How far rays stay together: the widest pyramids of neighbouring groups of shadow rays, and of one
// group with a slope for each ray; and how many visits only one group makes, for each group of a
// bundle, before the rays go on alone. Among spheres a ray that is alone costs so little that wide
// pyramids do not pay, and groups by themselves never do.
struct Togetherness {
  float run, packet;
  int nearest, block;
};
constexpr Togetherness kAmongAll = {0.2f, 0.2f, 5, 8}, kAmongSpheres = {0.03f, 0, 2, 1};
RAYSHADE_KERNEL const Togetherness& TogethernessIn(const TraceView& view) {
  return view.flat->items == nullptr ? kAmongSpheres : kAmongAll;
}

constexpr int kVisitsOfGroup = 30;  // of a bundle that is one group

// visits: for each group.
RAYSHADE_KERNEL int VisitsOfOne(int groups, int visits) {
  return groups == 1 ? kVisitsOfGroup : visits * groups;
}

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

RAYSHADE_ROUTINE void NearestInLeafOfBundle(const TraceView& view, Bundle* b, uint64_t branch,
                                            uint32_t groups, Hit* hits) {
  SeenLeaf leaf;
  SeenParts parts;
  SeeLeaf(view, *b, branch, &leaf);
  uint32_t changed = 0;
  for (uint32_t left = leaf.bits; left != 0; left &= left - 1) {
    const uint32_t i = static_cast<uint32_t>(__builtin_ctz(left));
    const LeafObject o = ObjectOfLeaf(view, branch, i);
    for (uint32_t m = groups; m != 0; m &= m - 1) {
      const int g = __builtin_ctz(m);
      uint32_t may = RaysThatMayMeet(*b, g, leaf, o.kind, i);
      if (may != 0 && IsInParts(o)) {
        may = RaysAtParts(view, *b, g, *o.polygon, may, &parts, nullptr);
      }
      if (may == 0) continue;
      const Met met = MeetObject(*b, g, may, o);
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
RAYSHADE_KERNEL BundleEntry* PushMet(const TraceView& view, const Bundle& b, uint64_t branch,
                                     uint32_t entering, bool sorted, BundleEntry* top) {
  const Node& node = view.nodes[ChildOf(branch)];
  const bool one = (entering & (entering - 1)) == 0;
  F8 depths;
  uint32_t bits = BoxesInPyramid(b, node.plane, one ? __builtin_ctz(entering) : -1, &depths);
  alignas(32) float depth[8];
  Store(depths, depth);
  BundleEntry* const bottom = top;
  for (; bits != 0; bits &= bits - 1) {
    const uint32_t i = static_cast<uint32_t>(__builtin_ctz(bits));
    const uint32_t groups =
        one ? entering : entering & PyramidsAtBox(b, GroupsAsPyramids(b), node.plane, i);
    if (groups == 0) continue;
    const BundleEntry child{&node, depth[i], static_cast<uint16_t>(i),
                            static_cast<uint16_t>(groups)};
    BundleEntry* p = top++;
    for (; sorted && p > bottom && p[-1].depth < child.depth; --p) *p = p[-1];
    *p = child;
  }
  return top;
}

RAYSHADE_KERNEL uint32_t RaysIn(uint32_t groups) {
  return 8u * static_cast<uint32_t>(__builtin_popcount(groups));
}

// The rays of the groups go on alone with what the stack holds of what they meet; first: of the
// bundle in the array.
RAYSHADE_ROUTINE void LeaveToRays(const Bundle& b, uint32_t groups, const BundleEntry* stack,
                                  const BundleEntry* top, uint32_t first, LoneRays* lone) {
  const auto count = static_cast<uint32_t>(top - stack);
  const bool fits = count <= 8 * kUnvisitedRows && lone->rest_count < kRestsMost;
  Unvisited* const rest = fits ? &lone->rests[lone->rest_count++] : nullptr;
  for (uint32_t k = 0; fits && k < count; ++k) {
    const BundleEntry& e = top[-1 - static_cast<int>(k)];
    rest->branch[k / 8][k % 8] = BranchOf(e);
    rest->entry[k / 8][k % 8] = e.depth;
  }
  for (; groups != 0; groups &= groups - 1) {
    const int g = __builtin_ctz(groups);
    uint64_t met[8] = {};
    const Slopes<F8> rays = RaysAsPyramids(b, g);
    for (uint32_t k = 0; fits && k < count; ++k) {
      const BundleEntry& e = top[-1 - static_cast<int>(k)];
      if ((e.groups >> g & 1) == 0) continue;
      const uint32_t bits = PyramidsAtBox(b, rays, e.parent->plane, e.lane);
      for (uint32_t i = 0; i < 8; ++i) met[i] |= uint64_t{bits >> i & 1} << k;
    }
    for (uint32_t live = b.live[g]; live != 0; live &= live - 1) {
      const uint32_t i = static_cast<uint32_t>(__builtin_ctz(live));
      if (fits && met[i] == 0) continue;
      lone->Append(first + 8 * static_cast<uint32_t>(g) + i, b.strict[g][i], rest, met[i]);
    }
  }
}

RAYSHADE_ROUTINE void NearestOfBundle(const TraceView& view, Bundle* b, Hit* hits, uint32_t first,
                                      LoneRays* lone, Counters* counters) {
  BundleEntry stack[kStackSize];
  BundleEntry* top = stack;
  int alone = 0;  // visits of one group
  const int most = VisitsOfOne(b->groups, TogethernessIn(view).nearest);
  const uint32_t all = (1u << b->groups) - 1;
  *top++ = {&kAboveRoot, 0, 0, static_cast<uint16_t>(all)};
  while (top != stack) {
    const BundleEntry& e = *--top;
    if (e.depth > b->whole.most) continue;
    const uint32_t groups = e.groups & LessEqual(SetF(e.depth), LoadF(b->most));
    if (groups == 0) continue;
    const uint64_t branch = BranchOf(e);
    alone += (groups & (groups - 1)) == 0;
    if (alone > most) {
      LeaveToRays(*b, all, stack, top + 1, first, lone);
      return;
    }
    if (KindOf(branch) != kInnerNode) {
      CountTests(view, KindOf(branch), branch, RaysIn(groups), counters);
      NearestInLeafOfBundle(view, b, branch, groups, hits);
    } else {
      ++counters->nodes;
      top = PushMet(view, *b, branch, groups, true, top);
    }
  }
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

// Rays that are found blocked leave the bundle. Returns whether there are any.
RAYSHADE_ROUTINE bool BlockInLeafOfBundle(const TraceView& view, Bundle* b, uint64_t branch,
                                          uint32_t groups, const Fate& fate, Counters* counters) {
  bool any = false;
  SeenLeaf leaf;
  SeenParts parts;
  SeeLeaf(view, *b, branch, &leaf);
  for (uint32_t left = leaf.bits; left != 0; left &= left - 1) {
    const uint32_t i = static_cast<uint32_t>(__builtin_ctz(left));
    uint32_t m = GroupsThatMayMeet(*b, leaf, KindOf(branch), i, groups);
    if (m == 0) continue;
    const LeafObject o = ObjectOfLeaf(view, branch, i);
    const bool opaque = o.kind == kOtherLeaf || IsOpaque(view, o.object);
    if (!opaque && fate.crossed == nullptr) continue;
    for (; m != 0; m &= m - 1) {
      const int g = __builtin_ctz(m);
      uint32_t surely;
      uint32_t may = RaysThatMayMeet(*b, g, leaf, o.kind, i, &surely);
      if (may != 0 && IsInParts(o)) {
        may = RaysAtParts(view, *b, g, *o.polygon, may, &parts, &surely);
      }
      if (may == 0) continue;
      if (opaque && surely != 0) {
        any = true;
        b->live[g] &= ~surely;
        if (b->live[g] == 0) b->most[g] = -1;
        for (uint32_t bits = surely; bits != 0; bits &= bits - 1) {
          fate.blocked[8 * g + __builtin_ctz(bits)] = 1;
          CountHit(view, o.object, counters);
        }
        if (may == surely) continue;
      }
      const uint32_t asked = may & b->live[g];
      const Met met = MeetObject(*b, g, asked, o);
      const uint32_t met_bits = (met.hit | met.unsure) & asked;
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
        any = true;
        b->best[g][lane] = -1;
        b->live[g] &= ~(1u << lane);
        CountHit(view, o.object, counters);
      }
      if (b->live[g] == 0) b->most[g] = -1;
    }
  }
  return any;
}

// run: bits of the groups. *last_blocker: the leaf in which rays of a bundle before were blocked
// last, or 0; it is looked at first, since neighbours are often blocked by the same object.
// Callbacks are spared that.
RAYSHADE_ROUTINE void BlockBundle(const TraceView& view, Bundle* b, uint32_t run, const Fate& fate,
                                  uint32_t first, LoneRays* lone, uint64_t* last_blocker,
                                  Counters* counters) {
  if (*last_blocker != 0) {
    CountTests(view, KindOf(*last_blocker), *last_blocker, RaysIn(run), counters);
    if (!BlockInLeafOfBundle(view, b, *last_blocker, run, fate, counters)) *last_blocker = 0;
  }
  BundleEntry stack[kStackSize];
  BundleEntry* top = stack;
  int alone = 0;  // visits of one group
  const int most = VisitsOfOne(__builtin_popcount(run), TogethernessIn(view).block);
  *top++ = {&kAboveRoot, 0, 0, static_cast<uint16_t>(run)};
  while (top != stack) {
    const BundleEntry& e = *--top;
    const uint32_t groups = e.groups & LessEqual(SetF(0), LoadF(b->most));
    if (groups == 0) continue;
    const uint64_t branch = BranchOf(e);
    alone += (groups & (groups - 1)) == 0;
    if (alone > most) {
      LeaveToRays(*b, run, stack, top + 1, first, lone);
      return;
    }
    if (KindOf(branch) != kInnerNode) {
      CountTests(view, KindOf(branch), branch, RaysIn(groups), counters);
      const bool blocked = BlockInLeafOfBundle(view, b, branch, groups, fate, counters);
      if (blocked && KindOf(branch) != kOtherLeaf) *last_blocker = branch;
    } else {
      ++counters->nodes;
      top = PushMet(view, *b, branch, groups, false, top);
    }
  }
}
