// Bundles of up to eight groups of eight rays, and the pyramids around them; part of trace.inl.
//
// The rays of a bundle begin, or end, in a small box: the apex (a camera, a light). Along the axis
// of the largest component of their directions, depth w is measured from the apex; at depth w a
// ray lies at apex + slope * w in the other two axes, u and v. A pyramid is an interval of slopes.
// A box is left out if no slope of the interval meets it at any of its depths.
//
//   1. Everything is rounded outwards: the apex as in single_rays.inl, slopes by kSlopeSlack, which
//   covers the rounding of depths and products.

constexpr int kGroups = 8;
constexpr uint32_t kBundleSize = 64;
constexpr float kSlopeSlack = 1e-6f;
constexpr double kLeastCosine = 0.4;  // of every ray with the axis
constexpr double kEndless = 1e13;     // limits beyond are no ends of rays

// Of one pyramid, or of eight.
template <typename F>
struct Slopes {
  F u_low, u_high, v_low, v_high;
  F most;  // depth beyond which nothing matters
};

struct Bundle {
  const double (*o[3])[8];  // origins and directions, of each group
  const double (*d[3])[8];
  alignas(64) double own[6][kGroups][8];  // where they are not the caller's
  alignas(64) double least[kGroups][8];
  alignas(64) double best[kGroups][8];    // the hit so far, or the limit; negative: no such ray
  alignas(64) double strict[kGroups][8];  // hits of strict kinds lie before
  alignas(64) float u_low[8], u_high[8], v_low[8], v_high[8], most[8];           // of each group
  alignas(64) float ray_u[kGroups][8], ray_v[kGroups][8], ray_most[kGroups][8];  // of each ray
  Slopes<float> whole;
  float w_near, w_far, u_near, u_far, v_near, v_far;  // apex; near: taken off the near plane
  float sign;                                         // of the directions along the axis
  int axis, near_plane, far_plane, u, v;              // planes of nodes; axes
  int groups;
  bool from_end;
  bool pointed;    // the apex is a point, and viewpoint is set
  bool sure;       // and no hit on a triangle is checked against its box
  double apex[3];  // a corner of it
  Viewpoint viewpoint;
  uint32_t live[kGroups];  // bits of the rays that are still of interest
  const Ray* rays;         // or null, and
  const double* times;

  bool has(int group, int lane) const { return (live[group] >> lane & 1) != 0; }
};

// For the callbacks.
RAYSHADE_KERNEL Ray RayOf(const Bundle& b, int i) {
  if (b.rays != nullptr) return b.rays[i];
  const int g = i / 8, lane = i % 8;
  Ray ray;
  ray.origin = {b.o[0][g][lane], b.o[1][g][lane], b.o[2][g][lane]};
  ray.direction = {b.d[0][g][lane], b.d[1][g][lane], b.d[2][g][lane]};
  ray.min_distance = b.least[g][lane];
  ray.time = b.times[i];
  ray.kind = RayKind::kShadow;
  return ray;
}

struct Spread {
  double low, high;
};

RAYSHADE_KERNEL void LoadRays(const Ray* rays, uint32_t count, Bundle* b) {
  b->rays = rays;
  b->groups = static_cast<int>((count + 7) / 8);
  for (int axis = 0; axis < 3; ++axis) {
    b->o[axis] = b->own[axis];
    b->d[axis] = b->own[3 + axis];
  }
  for (int i = 0; i < 8 * b->groups; ++i) {
    const int group = i / 8, lane = i % 8;
    const Ray& ray = rays[static_cast<uint32_t>(i) < count ? static_cast<uint32_t>(i) : count - 1];
    b->own[0][group][lane] = ray.origin.x;
    b->own[1][group][lane] = ray.origin.y;
    b->own[2][group][lane] = ray.origin.z;
    b->own[3][group][lane] = ray.direction.x;
    b->own[4][group][lane] = ray.direction.y;
    b->own[5][group][lane] = ray.direction.z;
    b->least[group][lane] = ray.min_distance;
  }
}

RAYSHADE_KERNEL double Larger(double a, double b) { return a > b ? a : b; }

RAYSHADE_KERNEL double SizeOf(const Spread box[3]) {
  double size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = box[axis].high - box[axis].low;
    size = extent > size ? extent : size;
  }
  return size;
}

// Where the rays begin and, if `ends`, where they end: boxes.
RAYSHADE_KERNEL void FindApex(const Bundle& b, bool ends, Spread box[3]) {
  for (int axis = 0; axis < 3; ++axis) {
    D8 low = SetD(__builtin_inf()), high = SetD(-__builtin_inf());
    for (int g = 0; g < b.groups; ++g) {
      D8 p = LoadD(b.o[axis][g]);
      if (ends) p = p + LoadD(b.best[g]) * LoadD(b.d[axis][g]);
      low = Min(p, low);
      high = Max(p, high);
    }
    box[axis] = {Least(low), Largest(high)};
  }
}

RAYSHADE_KERNEL int LargestAxis(const double d[3]) {
  const double x = __builtin_fabs(d[0]), y = __builtin_fabs(d[1]), z = __builtin_fabs(d[2]);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

// The two other axes, in their order.
RAYSHADE_KERNEL int FirstAcross(int axis) { return axis == 0 ? 1 : 0; }
RAYSHADE_KERNEL int SecondAcross(int axis) { return axis == 2 ? 1 : 2; }

// The axis that all directions follow, and their sign along it; false where there is none.
RAYSHADE_KERNEL bool FindAxis(const Bundle& b, int* axis, double* sign) {
  const double d[3] = {b.d[0][0][0], b.d[1][0][0], b.d[2][0][0]};
  *axis = LargestAxis(d);
  *sign = b.d[*axis][0][0] < 0 ? -1 : 1;
  uint32_t good = 0xff;
  for (int g = 0; g < b.groups; ++g) {
    const D8 dx = LoadD(b.d[0][g]), dy = LoadD(b.d[1][g]), dz = LoadD(b.d[2][g]);
    const D8 squared = dx * dx + dy * dy + dz * dz;
    good &= LessEqual(SetD(kLeastCosine), LoadD(b.d[*axis][g]) * SetD(*sign)) &
            Less(SetD(1 - kUnitTolerance), squared) & Less(squared, SetD(1 + kUnitTolerance));
  }
  return good == 0xff;
}

// The depths beyond which nothing matters: of the rays of a group, and of the group.
RAYSHADE_KERNEL void UpdateMost(Bundle* b, int group) {
  const D8 d = LoadD(b->d[b->axis][group]);
  D8 far = LoadD(b->best[group]);
  // Followed backwards, a ray ends where hits begin to count.
  if (b->from_end) far = far - LoadD(b->least[group]);
  const F8 depth = Rounded(far * Max(d, SetD(0) - d));
  const F8 most = depth + Size(depth) * SetF(2 * (kSlack - 1));
  Store(most, b->ray_most[group]);
  b->most[group] = Largest(most);
}

RAYSHADE_KERNEL void UpdateWholeMost(Bundle* b) {
  float most = -1;
  for (int g = 0; g < kGroups; ++g) most = b->most[g] > most ? b->most[g] : most;
  b->whole.most = most;
}

// turn: -1 for rays that are followed backwards, from their ends.
RAYSHADE_KERNEL void FindSlopes(Bundle* b, int axis, double sign, double turn) {
  Slopes<float>& whole = b->whole;
  whole = {1e30f, -1e30f, 1e30f, -1e30f, -1};
  for (int g = 0; g < 8; ++g) b->most[g] = -1;
  for (int g = 0; g < b->groups; ++g) {
    const D8 depth = LoadD(b->d[axis][g]) * SetD(sign);
    const D8 u = LoadD(b->d[b->u][g]) * SetD(turn) / depth;
    const D8 v = LoadD(b->d[b->v][g]) * SetD(turn) / depth;
    Store(Rounded(u), b->ray_u[g]);
    Store(Rounded(v), b->ray_v[g]);
    // Slopes are at most 2.3 in size.
    b->u_low[g] = FloatBelow(Least(u)) - 3 * kSlopeSlack;
    b->u_high[g] = FloatAbove(Largest(u)) + 3 * kSlopeSlack;
    b->v_low[g] = FloatBelow(Least(v)) - 3 * kSlopeSlack;
    b->v_high[g] = FloatAbove(Largest(v)) + 3 * kSlopeSlack;
    UpdateMost(b, g);
    whole.u_low = b->u_low[g] < whole.u_low ? b->u_low[g] : whole.u_low;
    whole.u_high = b->u_high[g] > whole.u_high ? b->u_high[g] : whole.u_high;
    whole.v_low = b->v_low[g] < whole.v_low ? b->v_low[g] : whole.v_low;
    whole.v_high = b->v_high[g] > whole.v_high ? b->v_high[g] : whole.v_high;
  }
  UpdateWholeMost(b);
}

// The apex's box for the tests of nodes. sign: of the directions from there along the axis.
RAYSHADE_KERNEL void PlaceApex(int axis, double sign, const float low[3], const float high[3],
                               Bundle* b) {
  const bool forward = sign > 0;
  b->sign = forward ? 1 : -1;
  b->near_plane = forward ? axis : 3 + axis;
  b->far_plane = forward ? 3 + axis : axis;
  b->w_near = forward ? high[axis] : low[axis];
  b->w_far = forward ? low[axis] : high[axis];
  b->u_near = high[b->u];
  b->u_far = low[b->u];
  b->v_near = high[b->v];
  b->v_far = low[b->v];
}

// loose: by how much rays may miss the apex.
RAYSHADE_KERNEL void SetViewpoint(const TraceView& view, const Spread apex[3], double loose,
                                  Bundle* b) {
  Viewpoint& p = b->viewpoint;
  p.size = 0;
  for (int k = 0; k < 3; ++k) {
    b->apex[k] = apex[k].low;
    p.at[k] = static_cast<float>(apex[k].low - view.center[k]);
    p.size += __builtin_fabsf(p.at[k]);
  }
  p.u = b->u;
  p.v = b->v;
  p.w = b->axis;
  p.sign = b->sign;
  p.handed = b->axis == 1 ? -b->sign : b->sign;
  p.loose = static_cast<float>(loose);
  const Slopes<float>& w = b->whole;
  const double u = Larger(__builtin_fabsf(w.u_low), __builtin_fabsf(w.u_high));
  const double v = Larger(__builtin_fabsf(w.v_low), __builtin_fabsf(w.v_high));
  p.q_sum = FloatAbove(1 + u + v);
  p.q_size = FloatAbove(__builtin_sqrt(1 + u * u + v * v));
}

// size: of the apex.
RAYSHADE_KERNEL void FindViewpoint(const TraceView& view, const Spread apex[3], double size,
                                   Bundle* b) {
  double reach = 0;
  for (int k = 0; k < 3; ++k) {
    reach = Larger(reach, Larger(__builtin_fabs(apex[k].low), __builtin_fabs(apex[k].high)));
    for (int g = 0; g < b->groups; ++g) {
      const D8 o = LoadD(b->o[k][g]);
      reach = Larger(reach, Largest(Max(o, SetD(0) - o)));
    }
  }
  b->pointed = size <= 1e-12 * reach && reach < kSureDistance;
  b->sure = false;
  if (b->pointed) SetViewpoint(view, apex, 2 * size + 1e-14 * reach, b);
}

// Puts a pyramid around the rays; false where they are too wide apart to gain from one. best must
// be set. ended: the rays' limits are where they end.
RAYSHADE_ROUTINE bool SurroundRays(const TraceView& view, bool ended, float widest, Bundle* b) {
  int axis;
  double sign;
  if (!FindAxis(*b, &axis, &sign)) return false;
  Spread apex[3], end[3];
  FindApex(*b, false, apex);
  double size = SizeOf(apex);
  bool from_end = false;
  if (ended && size > 0) {
    FindApex(*b, true, end);
    const double end_size = SizeOf(end);
    if (end_size < size) {
      from_end = true;
      size = end_size;
      for (int k = 0; k < 3; ++k) apex[k] = end[k];
    }
  }
  b->u = FirstAcross(axis);
  b->v = SecondAcross(axis);
  b->axis = axis;
  b->from_end = from_end;
  FindSlopes(b, axis, sign, from_end ? -1 : 1);
  if (from_end) sign = -sign;
  const Slopes<float>& w = b->whole;
  if (w.u_high - w.u_low > widest || w.v_high - w.v_low > widest) return false;
  // The apex, rounded outwards.
  float low[3], high[3];
  for (int k = 0; k < 3; ++k) {
    const double largest = Larger(__builtin_fabs(apex[k].low), __builtin_fabs(apex[k].high));
    low[k] = FloatBelow(apex[k].low - view.center[k] - 1e-14 * largest);
    high[k] = FloatAbove(apex[k].high - view.center[k] + 1e-14 * largest);
  }
  PlaceApex(axis, sign, low, high, b);
  FindViewpoint(view, apex, size, b);
  return true;
}

// Which boxes (given by their planes) the pyramids may meet, and from which depth on.
RAYSHADE_KERNEL uint32_t MeetPyramids(const Bundle& b, const Slopes<F8>& p, F8 near, F8 far,
                                      F8 u_low, F8 u_high, F8 v_low, F8 v_high, F8* depth) {
  const F8 sign = SetF(b.sign);
  const F8 w0 = Max((near - SetF(b.w_near)) * sign, SetF(0));
  const F8 w1 = Min((far - SetF(b.w_far)) * sign, p.most);
  *depth = w0;
  return LessEqual(w0, w1) & LessEqual(u_low - SetF(b.u_near), Max(p.u_high * w0, p.u_high * w1)) &
         LessEqual(Min(p.u_low * w0, p.u_low * w1), u_high - SetF(b.u_far)) &
         LessEqual(v_low - SetF(b.v_near), Max(p.v_high * w0, p.v_high * w1)) &
         LessEqual(Min(p.v_low * w0, p.v_low * w1), v_high - SetF(b.v_far));
}

// Eight boxes, whose planes lie as in Node, against one pyramid: a group's own, or the whole
// bundle's where group < 0.
RAYSHADE_KERNEL uint32_t BoxesInPyramid(const Bundle& b, const float (*plane)[8], int group,
                                        F8* depth) {
  Slopes<F8> p;
  if (group < 0) {
    const Slopes<float>& w = b.whole;
    p = {SetF(w.u_low), SetF(w.u_high), SetF(w.v_low), SetF(w.v_high), SetF(w.most)};
  } else {
    p = {SetF(b.u_low[group]), SetF(b.u_high[group]), SetF(b.v_low[group]), SetF(b.v_high[group]),
         SetF(b.most[group])};
  }
  return MeetPyramids(b, p, LoadF(plane[b.near_plane]), LoadF(plane[b.far_plane]),
                      LoadF(plane[b.u]), LoadF(plane[3 + b.u]), LoadF(plane[b.v]),
                      LoadF(plane[3 + b.v]), depth);
}

// Which of eight pyramids the box in lane i, whose planes lie as in Node, may meet: bits.
RAYSHADE_KERNEL uint32_t PyramidsAtBox(const Bundle& b, const Slopes<F8>& p,
                                       const float (*plane)[8], uint32_t i) {
  F8 depth;
  return MeetPyramids(b, p, SetF(plane[b.near_plane][i]), SetF(plane[b.far_plane][i]),
                      SetF(plane[b.u][i]), SetF(plane[3 + b.u][i]), SetF(plane[b.v][i]),
                      SetF(plane[3 + b.v][i]), &depth);
}

// The pyramids of all groups.
RAYSHADE_KERNEL Slopes<F8> GroupsAsPyramids(const Bundle& b) {
  return {LoadF(b.u_low), LoadF(b.u_high), LoadF(b.v_low), LoadF(b.v_high), LoadF(b.most)};
}
