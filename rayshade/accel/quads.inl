// A look at the objects of a leaf in single precision before they are tested: most of them can be
// left out for all rays of a bundle at once, or ray by ray for a few operations; part of trace.inl.
//
// It needs a common apex: all rays pass through it, and are followed from there. In its depths and
// slopes (pyramid.inl) a direction is q = (u, v, +-1), and a ray is the point (u, v) of a plane.
//
//   1. Only what no ray can hit is left out. A line inside of a quadrilateral (quads.h) has
//   (a x b) . q of one sign for each of its edges from a to b, seen from the apex, and the sign is
//   that of the plane's height. A sphere lies inside of a circle in the plane of slopes.
//   2. Margins cover the rounding of everything that goes in. For a line that hits at depth w, a
//   quadrilateral of diameter d with corners at most D away, and |q| <= Q (a sum of sizes),
//   products of coordinates are off by less than 2e-6 D d Q; corners that are off by P move
//   (a x b) . q by less than 8 P D d / w, since the hit is no farther than d from each of them.
//   Corners off their plane count 10. w Q is at least the height, and the depth of the nearest
//   corner. A comparison with something that is not a number leaves nothing out.
//   3. The same margins, doubled, tell what surely hits: a line that passes inside of the
//   quadrilateral as it is here hits it, and so the true one is no farther off than that. Where
//   this is the object itself, its own test counts any line that truly passes inside as a hit.

constexpr float kOneRounding = 1.2e-7f;  // twice of what one rounding is

// Where lines come from.
struct Viewpoint {
  float at[3];   // relative to the hierarchy's center
  int u, v, w;   // axes
  float sign;    // of the directions along w
  float handed;  // 1 where u, v and the directions along w are a right-handed system, -1 elsewhere
  float size;    // sum of the sizes of the coordinates
  float loose;   // by how much a ray may pass by
  float q_sum;   // at least |u| + |v| + 1 of every direction
  float q_size;  // and its length
};

// Quadrilaterals, one a lane; all that is compared is turned so that the height is positive.
struct SeenQuads {
  F8 edge[4][3];     // along u, v, w
  F8 least;          // of the edge functions of a line that may hit
  F8 inside;         // larger edge functions are those of lines that surely pass through the object
  F8 plane[3];       // normal
  F8 height;         // of the plane over the viewpoint; nothing is left out where it is -infinite
  F8 height_margin;  // without the part that grows with depth
};

RAYSHADE_KERNEL F8 LargestSize(F8 x, F8 y, F8 z) { return Max(Max(Size(x), Size(y)), Size(z)); }

RAYSHADE_KERNEL SeenQuads SeeQuads(const float* rows, uint32_t count, const Viewpoint& p) {
  const auto row = [&](int i) { return LoadF(rows + static_cast<uint32_t>(i) * count); };
  SeenQuads s;
  // The plane.
  const F8 x = row(12), y = row(13), z = row(14), offset = row(15);
  const F8 raw_height = offset - (x * SetF(p.at[0]) + y * SetF(p.at[1]) + z * SetF(p.at[2]));
  const F8 turn = Choose(Less(raw_height, SetF(0)), SetF(-1), SetF(1));
  s.height = raw_height * turn;
  s.plane[0] = row(12 + p.u) * turn;
  s.plane[1] = row(12 + p.v) * turn;
  s.plane[2] = row(12 + p.w) * turn * SetF(p.sign);
  s.height_margin = SetF(4e-7f) * (SetF(p.size) + Size(offset)) + SetF(2 * p.loose);
  // The corners, and the planes through apex and edges.
  F8 a[4][3];
  F8 largest = SetF(0), nearest = SetF(__builtin_inff());
  for (int i = 0; i < 4; ++i) {
    a[i][0] = row(3 * i + p.u) - SetF(p.at[p.u]);
    a[i][1] = row(3 * i + p.v) - SetF(p.at[p.v]);
    a[i][2] = (row(3 * i + p.w) - SetF(p.at[p.w])) * SetF(p.sign);
    largest = Max(largest, LargestSize(a[i][0], a[i][1], a[i][2]));
    nearest = Min(nearest, a[i][2]);
  }
  const F8 handed = turn * SetF(p.handed);
  for (int i = 0; i < 4; ++i) {
    const F8* to = a[(i + 1) % 4];
    const F8 along[3] = {to[0] - a[i][0], to[1] - a[i][1], to[2] - a[i][2]};
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      s.edge[i][k] = (a[i][l] * along[m] - a[i][m] * along[l]) * handed;
    }
  }
  const F8 known = SetF(2 * kOneRounding) * (largest + SetF(p.size)) + SetF(p.loose);
  const F8 q = SetF(p.q_sum);
  const F8 depth = Max(nearest, s.height) / (q * SetF(1.0001f));
  const F8 off = SetF(8) * known + SetF(10) * row(16);
  const F8 margin = largest * row(17) * (SetF(2e-6f) * q + off / depth);
  // On which side the apex is must be known.
  const F8 endless = SetF(__builtin_inff());
  const uint32_t above = Less(s.height_margin, s.height);
  s.least = Choose(above, SetF(0) - margin, SetF(0) - endless);
  s.inside = Choose(above, SetF(2) * margin + row(18), endless);
  s.height = Choose(above, s.height, SetF(0) - endless);
  return s;
}

RAYSHADE_KERNEL SeenQuads SeeQuads(const TraceView& view, uint64_t branch, const Viewpoint& p) {
  const size_t first = ChildOf(branch) - view.sphere_count;
  return SeeQuads(view.flat->quads + kQuadRows * first, CountOf(branch), p);
}

// A direction, or the furthest of several in one function's sense.
struct Corner {
  F8 u_low, u_high, v_low, v_high;
};
RAYSHADE_KERNEL F8 Furthest(const F8 normal[3], const Corner& c) {
  return Max(normal[0] * c.u_low, normal[0] * c.u_high) +
         Max(normal[1] * c.v_low, normal[1] * c.v_high) + normal[2];
}

// What is left over of a plane's height at a depth.
RAYSHADE_KERNEL F8 HeightReached(F8 cosine, F8 depth, F8 height_margin, float q_sum) {
  return depth * cosine + (height_margin + SetF(7e-7f * q_sum) * depth);
}

// The same, but surely reached by a ray that ends at this depth, loosened as UpdateMost does.
constexpr float kSureCosine = 1e-4f;  // times the size of a direction: steeper than kEpsilon
RAYSHADE_KERNEL F8 HeightSurelyReached(F8 cosine, F8 depth, F8 height_margin, float q_sum) {
  return depth * cosine - (SetF(2) * height_margin + SetF(1e-5f * q_sum) * depth);
}

// Quadrilaterals that some direction within the corners may meet not beyond the depth.
RAYSHADE_KERNEL uint32_t QuadsInPyramid(const SeenQuads& s, const Viewpoint& p, const Corner& c,
                                        float most) {
  uint32_t out = 0;
  for (int i = 0; i < 4; ++i) out |= Less(Furthest(s.edge[i], c), s.least);
  const F8 reached = HeightReached(Furthest(s.plane, c), SetF(most), s.height_margin, p.q_sum);
  return ~(out | Less(reached, s.height)) & 0xff;
}

// The objects of a leaf that a single ray may meet.
RAYSHADE_KERNEL uint32_t QuadsOnRay(const TraceView& view, uint64_t branch, const double o[3],
                                    const double direction[3], float most) {
  Viewpoint p;
  for (int k = 0; k < 3; ++k) p.at[k] = static_cast<float>(o[k] - view.center[k]);
  p.u = 0;
  p.v = 1;
  p.w = 2;
  p.sign = p.handed = 1;
  p.size = __builtin_fabsf(p.at[0]) + __builtin_fabsf(p.at[1]) + __builtin_fabsf(p.at[2]);
  p.loose = static_cast<float>(
      1e-14 * (__builtin_fabs(o[0]) + __builtin_fabs(o[1]) + __builtin_fabs(o[2])));
  const float d[3] = {static_cast<float>(direction[0]), static_cast<float>(direction[1]),
                      static_cast<float>(direction[2])};
  p.q_sum = 1.00001f * (__builtin_fabsf(d[0]) + __builtin_fabsf(d[1]) + __builtin_fabsf(d[2]));
  p.q_size = p.q_sum;
  const SeenQuads s = SeeQuads(view, branch, p);
  const F8 x = SetF(d[0]), y = SetF(d[1]), z = SetF(d[2]);
  const auto at = [&](const F8* n) { return n[0] * x + n[1] * y + n[2] * z; };
  const F8 edges = Min(Min(at(s.edge[0]), at(s.edge[1])), Min(at(s.edge[2]), at(s.edge[3])));
  const F8 reached = HeightReached(at(s.plane), SetF(most), s.height_margin, p.q_sum);
  return ~(Less(edges, s.least) | Less(reached, s.height)) & ((1u << CountOf(branch)) - 1);
}
