// Quadrilaterals as the rays of a bundle see them, kept in memory to be read one by one; part of
// trace.inl.

constexpr int kSeenRows = 19;

RAYSHADE_KERNEL void StoreQuads(const SeenQuads& s, float (*part)[8]) {
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) Store(s.edge[i][k], part[3 * i + k]);
  }
  for (int k = 0; k < 3; ++k) Store(s.plane[k], part[12 + k]);
  Store(s.least, part[15]);
  Store(s.height, part[16]);
  Store(s.height_margin, part[17]);
  Store(s.inside, part[18]);
}

// The rays of a group, of those asked about, that may meet the quadrilateral in lane i: bits.
// *surely, where it is not null: those that the object's own test surely counts as hits.
RAYSHADE_KERNEL uint32_t RaysAtQuad(const Bundle& b, int g, const float (*part)[8], uint32_t i,
                                    uint32_t asked, uint32_t* surely) {
  const F8 u = LoadF(b.ray_u[g]), v = LoadF(b.ray_v[g]), depth = LoadF(b.ray_most[g]);
  const auto row = [&](int k) { return SetF(part[k][i]); };
  const auto at = [&](int k) { return row(k) * u + row(k + 1) * v + row(k + 2); };
  const F8 edges = Min(Min(at(0), at(3)), Min(at(6), at(9)));
  const F8 height = row(16), height_margin = row(17), cosine = at(12);
  const F8 reached = HeightReached(cosine, depth, height_margin, b.viewpoint.q_sum);
  const uint32_t may = ~(Less(edges, row(15)) | Less(reached, height)) & asked;
  if (surely != nullptr && may != 0 && b.sure) {
    const F8 short_of = HeightSurelyReached(cosine, depth, height_margin, b.viewpoint.q_sum);
    *surely = may & Less(row(18), edges) & Less(height, short_of) &
              Less(SetF(kSureCosine * b.viewpoint.q_sum), cosine);
  }
  return may;
}

// The groups of which some ray may meet the quadrilateral in lane i: bits. part of SeenQuads, as
// QuadsInPyramid does it.
RAYSHADE_KERNEL uint32_t GroupsAtQuad(const Bundle& b, const float (*part)[8], uint32_t i) {
  const Corner c = {LoadF(b.u_low), LoadF(b.u_high), LoadF(b.v_low), LoadF(b.v_high)};
  const auto furthest = [&](int k) {
    const F8 normal[3] = {SetF(part[k][i]), SetF(part[k + 1][i]), SetF(part[k + 2][i])};
    return Furthest(normal, c);
  };
  const F8 edges = Min(Min(furthest(0), furthest(3)), Min(furthest(6), furthest(9)));
  const F8 reached =
      HeightReached(furthest(12), LoadF(b.most), SetF(part[17][i]), b.viewpoint.q_sum);
  return ~(Less(edges, SetF(part[15][i])) | Less(reached, SetF(part[16][i]))) & 0xff;
}

// The parts of a polygon.
constexpr uint32_t kPartEights = kPartsMost / 8;
struct SeenParts {
  const FlatPolygon* polygon = nullptr;  // whose
  uint32_t eights;                       // 0: there are none
  uint32_t bits[kPartEights];
  alignas(32) float part[kPartEights][kSeenRows][8];
};

RAYSHADE_KERNEL void SeeParts(const TraceView& view, const Bundle& b, const FlatPolygon& polygon,
                              SeenParts* seen) {
  seen->polygon = &polygon;
  seen->eights = 0;
  if (!b.pointed) return;
  const Slopes<float>& w = b.whole;
  const Corner corner = {SetF(w.u_low), SetF(w.u_high), SetF(w.v_low), SetF(w.v_high)};
  for (uint32_t k = 0; k < polygon.part_count; k += 8) {
    const uint32_t left = polygon.part_count - k, count = left < 8 ? left : 8;
    const size_t first = polygon.first_part + k;
    const SeenQuads s = SeeQuads(view.flat->parts + kQuadRows * first, count, b.viewpoint);
    const uint32_t bits = QuadsInPyramid(s, b.viewpoint, corner, w.most) & ((1u << count) - 1);
    seen->bits[seen->eights] = bits;
    if (bits != 0) StoreQuads(s, seen->part[seen->eights]);
    ++seen->eights;
  }
}

// As RaysAtQuad, for the polygon; its parts are looked at when they are first needed.
RAYSHADE_KERNEL uint32_t RaysAtParts(const TraceView& view, const Bundle& b, int g,
                                     const FlatPolygon& polygon, uint32_t asked, SeenParts* seen,
                                     uint32_t* surely) {
  if (seen->polygon != &polygon) SeeParts(view, b, polygon, seen);
  if (seen->eights == 0) return asked;
  uint32_t may = 0, sure = 0;
  for (uint32_t k = 0; k < seen->eights; ++k) {
    for (uint32_t m = seen->bits[k]; m != 0 && sure != asked; m &= m - 1) {
      const auto i = static_cast<uint32_t>(__builtin_ctz(m));
      uint32_t in = 0;
      may |= RaysAtQuad(b, g, seen->part[k], i, asked & ~sure, &in);
      sure |= in;
    }
  }
  if (surely != nullptr) *surely = sure;
  return may;
}
