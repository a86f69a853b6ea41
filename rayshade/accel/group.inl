// One group of shadow rays whose pyramid is too wide: each ray has its own slopes, and a stack
// entry knows which rays met it; part of trace.inl.

struct GroupEntry {
  uint64_t branch;
  uint32_t rays;  // bits
};

RAYSHADE_ROUTINE void BlockGroup(const TraceView& view, Bundle* b, int g, const Fate& fate,
                                 Counters* counters) {
  GroupEntry stack[kStackSize];
  GroupEntry* top = stack;
  *top++ = {MakeBranch(kInnerNode, 0, 0), b->live[g]};
  const Slopes<F8> rays = RaysAsPyramids(*b, g);
  while (top != stack) {
    const GroupEntry e = *--top;
    const uint32_t live = e.rays & b->live[g];
    if (live == 0) continue;
    if (KindOf(e.branch) != kInnerNode) {
      const auto tested = static_cast<uint32_t>(__builtin_popcount(live));
      CountTests(view, KindOf(e.branch), e.branch, tested, counters);
      BlockInLeafOfBundle(view, b, e.branch, 1u << g, fate, counters);
      continue;
    }
    ++counters->nodes;
    const Node& node = view.nodes[ChildOf(e.branch)];
    F8 depths;
    for (uint32_t m = BoxesInPyramid(*b, node.plane, g, &depths); m != 0; m &= m - 1) {
      const auto i = static_cast<uint32_t>(__builtin_ctz(m));
      const uint32_t met = PyramidsAtBox(*b, rays, node.plane, i) & live;
      if (met != 0) *top++ = {node.branch[i], met};
    }
  }
}
