// Arrays of rays, whose neighbours may be coherent, cut into bundles and rays that are alone; part
// of trace.inl.

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

// Returns false where the rays are too wide apart. Appends those that go on alone; first: of the
// rays in the array.
RAYSHADE_ROUTINE bool TryNearest(const TraceView& view, const Ray* rays, const double* strict,
                                 Hit* hits, uint32_t count, float widest, uint32_t first,
                                 LoneRays* lone, Counters* counters) {
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
  if (view.node_count > 0) NearestOfBundle(view, &b, hits, first, lone, counters);
  return true;
}

RAYSHADE_ROUTINE bool TryBlock(const TraceView& view, const Ray* rays, const double* limits,
                               const Fate& fate, uint32_t count, float widest, uint32_t first,
                               LoneRays* lone, uint64_t* last_blocker, Counters* counters) {
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
  if (view.node_count > 0) {
    BlockBundle(view, &b, (1u << b.groups) - 1, fate, first, lone, last_blocker, counters);
  }
  return true;
}

// Appends the rays that are better off alone.
RAYSHADE_KERNEL void NearestOfSome(const TraceView& view, const Ray* rays, Hit* hits,
                                   uint32_t first, uint32_t count, LoneRays* lone,
                                   Counters* counters) {
  double strict[kBundleSize];
  for (uint32_t i = 0; i < count; ++i) strict[i] = StrictLimit(hits[first + i]);
  const auto traced = [&](uint32_t i, uint32_t size, float widest) {
    return size > 1 && !TooWide(rays + first + i, size, widest) &&
           TryNearest(view, rays + first + i, strict + i, hits + first + i, size, widest, first + i,
                      lone, counters);
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
                                uint64_t* last_blocker, Counters* counters) {
  const float widest = count > 8 ? kWidestShadowBundle : kWidestShadowGroup;
  if (count > 1 && TryBlock(view, rays + first, limits + first, FateFrom(fate, first), count,
                            widest, first, lone, last_blocker, counters)) {
    return;
  }
  if (count <= 8) {
    for (uint32_t i = first; i < first + count; ++i) {
      if (!fate.blocked[i]) lone->Append(i, limits[i]);
    }
    return;
  }
  const uint32_t half = (count + 15) / 16 * 8;
  BlockSome(view, rays, limits, fate, first, half, lone, last_blocker, counters);
  BlockSome(view, rays, limits, fate, first + half, count - half, lone, last_blocker, counters);
}

RAYSHADE_ROUTINE void BlockMany(const TraceView& view, const Ray* rays, const double* limits,
                                const Fate& fate, uint32_t count, Counters* counters) {
  LoneRays lone;
  uint64_t last_blocker = 0;
  for (uint32_t i = 0; i < count; i += kBundleSize) {
    const uint32_t size = count - i < kBundleSize ? count - i : kBundleSize;
    BlockSome(view, rays, limits, fate, i, size, &lone, &last_blocker, counters);
  }
  BlockLone(view, rays, lone.rays, lone.count, fate, counters);
}
