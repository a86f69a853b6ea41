// Shadow rays of neighbouring hits towards one position, in rows as the hits lie; part of
// trace.inl. Up to eight groups of eight are in work together. Neighbouring groups are traced as
// one bundle as long as their pyramid stays narrow; a group that is too wide by itself is traced
// ray by ray.

// The very operations of Normalize (common/vector.h). Returns the lengths.
RAYSHADE_KERNEL D8 NormalizeEach(D8* v) {
  const D8 length = Sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  const uint32_t near = Less(length, SetD(kEpsilon));
  for (int k = 0; k < 3; ++k) {
    const D8 unit = v[k] / length;
    v[k] = near == 0 ? unit : Choose(near, v[k], unit);
  }
  return near == 0 ? length : Choose(near, SetD(0), length);
}

// The very operations of Camera (render/camera.cc).
RAYSHADE_ROUTINE void Look(const ScreenRows& s) {
  for (uint32_t i = 0; i < s.count; i += 8) {
    const D8 x = LoadD(s.place[0] + i), y = LoadD(s.place[1] + i);
    D8 direction[3];
    for (int k = 0; k < 3; ++k) {
      direction[k] = SetD(s.corner[k]) + x * SetD(s.step[0][k]) + y * SetD(s.step[1][k]);
    }
    NormalizeEach(direction);
    for (int k = 0; k < 3; ++k) Store(direction[k], s.direction[k] + i);
  }
}

RAYSHADE_ROUTINE void Aim(const AimRows& a) {
  for (uint32_t i = 0; i < a.count; i += 8) {
    // The very operations of TowardPosition (light/point.h).
    D8 toward[3];
    for (int k = 0; k < 3; ++k) toward[k] = SetD(a.position[k]) - LoadD(a.point[k] + i);
    const D8 distance = NormalizeEach(toward);
    D8 cosine = SetD(0);
    for (int k = 0; k < 3; ++k) Store(toward[k], a.toward[k] + i);
    for (int k = 0; k < 3; ++k) {
      const D8 part = toward[k] * LoadD(a.normal[k] + i);
      cosine = k == 0 ? part : cosine + part;
    }
    Store(distance, a.distance + i);
    Store(cosine, a.cosine + i);
  }
}

RAYSHADE_KERNEL void LoadRows(const ShadowRows& rows, uint32_t first, uint32_t count, Bundle* b) {
  b->rays = nullptr;
  b->times = rows.times + first;
  b->groups = static_cast<int>((count + 7) / 8);
  for (int axis = 0; axis < 3; ++axis) {
    b->o[axis] = reinterpret_cast<const double(*)[8]>(rows.origin[axis] + first);
    b->d[axis] = reinterpret_cast<const double(*)[8]>(rows.direction[axis] + first);
  }
  for (int g = 0; g < b->groups; ++g) {
    const uint32_t begin = 8 * static_cast<uint32_t>(g), size = count - begin;
    const uint32_t live =
        ~BitsAt(rows.blocked + first + begin, size) & (size < 8 ? (1u << size) - 1 : 0xff);
    b->live[g] = live;
    const D8 limit = LoadD(rows.limits + first + 8 * g);
    Store(limit, b->strict[g]);
    Store(Choose(live, limit, SetD(-1)), b->best[g]);
    Store(SetD(kShadowEpsilon), b->least[g]);
  }
}

// The apex, rounded outwards. followed: 1 or -1, of the directions from there along the axis.
RAYSHADE_KERNEL void SetApex(const TraceView& view, const ShadowRows& rows, int axis,
                             double followed, Bundle* b) {
  float low[3], high[3];
  for (int k = 0; k < 3; ++k) {
    low[k] = FloatBelow(rows.position[k] - view.center[k] - 1e-14 * rows.reach);
    high[k] = FloatAbove(rows.position[k] - view.center[k] + 1e-14 * rows.reach);
  }
  PlaceApex(axis, followed, low, high, b);
  const Spread apex[3] = {{rows.position[0], rows.position[0]},
                          {rows.position[1], rows.position[1]},
                          {rows.position[2], rows.position[2]}};
  b->pointed = rows.reach < kSureDistance;
  b->sure = 4 * rows.reach < kSureDistance;
  if (b->pointed) SetViewpoint(view, apex, 1e-14 * rows.reach, b);
}

// Slopes of the rays of a group along the axis, those of `live`.
RAYSHADE_KERNEL void SlopesOfGroup(int g, uint32_t live, F8 depth, Bundle* b) {
  const F8 turned = SetF(-1) / depth;
  const F8 u = Rounded(LoadD(b->d[b->u][g])) * turned, v = Rounded(LoadD(b->d[b->v][g])) * turned;
  Store(u, b->ray_u[g]);
  Store(v, b->ray_v[g]);
  const F8 most = SetF(1e30f), least = SetF(-1e30f);
  b->u_low[g] = Least(Choose(live, u, most)) - 3 * kSlopeSlack;
  b->u_high[g] = Largest(Choose(live, u, least)) + 3 * kSlopeSlack;
  b->v_low[g] = Least(Choose(live, v, most)) - 3 * kSlopeSlack;
  b->v_high[g] = Largest(Choose(live, v, least)) + 3 * kSlopeSlack;
}

// The groups of which all rays that are left follow the axis, and the first with those of its rays
// that do: they become the bundle's live rays, and are left no longer. Returns bits of the groups.
RAYSHADE_KERNEL uint32_t TakeGroups(uint32_t groups, int axis, double sign, uint32_t* left,
                                    Bundle* b) {
  const int first = __builtin_ctz(groups);
  uint32_t taken = 0;
  for (uint32_t m = groups; m != 0; m &= m - 1) {
    const int g = __builtin_ctz(m);
    const F8 depth = Rounded(LoadD(b->d[axis][g])) * SetF(static_cast<float>(sign));
    const uint32_t follow = LessEqual(SetF(static_cast<float>(kLeastCosine)), depth) & left[g];
    if (follow == 0 || (follow != left[g] && g != first)) continue;
    b->live[g] = follow;
    left[g] &= ~follow;
    taken |= 1u << g;
    SlopesOfGroup(g, follow, depth, b);
  }
  return taken;
}

// The groups from the first of `groups` on that make one narrow pyramid, which becomes the whole.
RAYSHADE_KERNEL uint32_t NarrowRun(uint32_t groups, float widest, Bundle* b) {
  Slopes<float>& w = b->whole;
  uint32_t run = 0;
  for (uint32_t m = groups; m != 0; m &= m - 1) {
    const int g = __builtin_ctz(m);
    const auto lower = [](float x, float y) { return x < y ? x : y; };
    const auto higher = [](float x, float y) { return x > y ? x : y; };
    Slopes<float> next = {b->u_low[g], b->u_high[g], b->v_low[g], b->v_high[g], 0};
    if (run != 0) {
      next = {lower(w.u_low, next.u_low), higher(w.u_high, next.u_high), lower(w.v_low, next.v_low),
              higher(w.v_high, next.v_high), 0};
      if (next.u_high - next.u_low > widest || next.v_high - next.v_low > widest) break;
    }
    w = next;
    run |= 1u << g;
  }
  return run;
}

// For the callbacks.
RAYSHADE_KERNEL const Ray& LoadLone(const ShadowRows& rows, uint32_t i, Walker* w) {
  Ray& ray = w->own;
  ray.origin = {rows.origin[0][i], rows.origin[1][i], rows.origin[2][i]};
  ray.direction = {rows.direction[0][i], rows.direction[1][i], rows.direction[2][i]};
  ray.min_distance = kShadowEpsilon;
  ray.time = rows.times[i];
  ray.kind = RayKind::kShadow;
  return ray;
}

// first: of the bundle among the rows.
RAYSHADE_KERNEL void AppendLive(const Bundle& b, uint32_t groups, uint32_t first, LoneRays* lone) {
  for (; groups != 0; groups &= groups - 1) {
    const uint32_t g = static_cast<uint32_t>(__builtin_ctz(groups));
    for (uint32_t live = b.live[g]; live != 0; live &= live - 1) {
      const uint32_t lane = static_cast<uint32_t>(__builtin_ctz(live));
      lone->Append(first + 8 * g + lane, b.strict[g][lane]);
    }
  }
}

// Puts the pyramid around these groups, which make up the whole.
RAYSHADE_KERNEL void SurroundRun(const TraceView& view, const ShadowRows& rows, uint32_t run,
                                 double sign, Bundle* b) {
  for (int k = 0; k < kGroups; ++k) b->most[k] = -1;
  for (uint32_t m = run; m != 0; m &= m - 1) UpdateMost(b, __builtin_ctz(m));
  UpdateWholeMost(b);
  SetApex(view, rows, b->axis, -sign, b);
}

// Groups whose rays follow the bundle's axis; sign: of their directions along it. Appends the rays
// that are better off alone; first: of the bundle among the rows.
RAYSHADE_KERNEL void BlockRuns(const TraceView& view, const ShadowRows& rows, uint32_t groups,
                               double sign, const Fate& fate, uint32_t first, Bundle* b,
                               LoneRays* lone, uint64_t* last_blocker, Counters* counters) {
  const Togetherness& widest = TogethernessIn(view);
  while (groups != 0) {
    const uint32_t run = NarrowRun(groups, widest.run, b);
    groups &= ~run;
    const bool one = (run & (run - 1)) == 0;
    const Slopes<float>& w = b->whole;
    if (one && (w.u_high - w.u_low > widest.packet || w.v_high - w.v_low > widest.packet)) {
      AppendLive(*b, run, first, lone);
      continue;
    }
    SurroundRun(view, rows, run, sign, b);
    if (one) {
      BlockGroup(view, b, __builtin_ctz(run), fate, counters);
    } else {
      BlockBundle(view, b, run, fate, first, lone, last_blocker, counters);
    }
  }
}

RAYSHADE_ROUTINE void BlockRowsOfBundle(const TraceView& view, const ShadowRows& rows,
                                        uint32_t first, uint32_t count, LoneRays* lone,
                                        uint64_t* last_blocker, Counters* counters) {
  Bundle b;
  LoadRows(rows, first, count, &b);
  const Fate fate = FateFrom({rows.blocked, rows.crossed}, first);
  uint32_t groups = 0;
  for (int g = 0; g < b.groups; ++g) groups |= static_cast<uint32_t>(b.live[g] != 0) << g;
  if (view.unbounded_count > 0 || view.node_count == 0) {
    AppendLive(b, groups, first, lone);
    return;
  }
  uint32_t left[kGroups];
  for (int g = 0; g < b.groups; ++g) left[g] = b.live[g];
  b.from_end = true;
  while (groups != 0) {
    // Along the axis that the first ray follows.
    const int g = __builtin_ctz(groups), lane = __builtin_ctz(left[g]);
    const double d[3] = {b.d[0][g][lane], b.d[1][g][lane], b.d[2][g][lane]};
    b.axis = LargestAxis(d);
    b.u = FirstAcross(b.axis);
    b.v = SecondAcross(b.axis);
    const double sign = d[b.axis] < 0 ? -1 : 1;
    const uint32_t taken = TakeGroups(groups, b.axis, sign, left, &b);
    if ((taken >> g & 1) != 0) {
      BlockRuns(view, rows, taken, sign, fate, first, &b, lone, last_blocker, counters);
    } else {
      // Not a direction.
      b.live[g] = 1u << lane;
      left[g] &= ~b.live[g];
      AppendLive(b, 1u << g, first, lone);
    }
    for (uint32_t m = groups; m != 0; m &= m - 1) {
      const int k = __builtin_ctz(m);
      if (left[k] == 0) groups &= ~(1u << k);
    }
  }
}

RAYSHADE_ROUTINE void BlockLoneOfRows(const TraceView& view, const ShadowRows& rows,
                                      const LoneRays& lone, Counters* counters) {
  const BlockJob<ShadowRows> job{view, rows, lone.rays, {rows.blocked, rows.crossed}, counters};
  Walk(view, job, lone.count, counters);
}
