// Bundles look at the objects of a leaf in single precision before they test them: most can be left
// out for all rays at once, others ray by ray for a few operations; part of trace.inl. Only bundles
// that are pointed do: their rays pass through a common apex (quads.inl, invariants 1 and 2). There
// a sphere lies inside of a circle in the plane of slopes.

// Spheres, one a lane: circles among the slopes, and smaller ones that are surely within the
// spheres' own.
struct SeenSpheres {
  F8 u, v, radius, inner;
  F8 nearest, farthest;  // depth
  uint32_t around;       // bits of those that are not left out: the apex is too near
};

RAYSHADE_KERNEL SeenSpheres SeeSpheres(const TraceView& view, uint64_t branch, const Viewpoint& p,
                                       const double apex[3]) {
  const uint32_t count = CountOf(branch);
  const double* rows = view.spheres + 4 * static_cast<size_t>(ChildOf(branch));
  const auto along = [&](int axis) {
    return Rounded(LoadD(rows + static_cast<uint32_t>(axis) * count) - SetD(apex[axis]));
  };
  const F8 w = along(p.w) * SetF(p.sign);
  const F8 radius = Rounded(LoadD(rows + 3 * count)) * SetF(1.00001f) + SetF(2 * p.loose);
  const F8 inverse = SetF(1) / w;
  SeenSpheres s;
  s.u = along(p.u) * inverse;
  s.v = along(p.v) * inverse;
  // In the plane of this depth, a ray that meets the sphere is not farther from its center than
  // radius / cos of the ray's angle with the axis.
  s.radius = radius * SetF(p.q_size) * inverse + SetF(2e-6f);
  // And one that is less than the true radius away from the center there meets it.
  s.inner = Max((radius * SetF(0.9999f) - SetF(8 * p.loose)) * inverse - SetF(4e-6f), SetF(0));
  s.nearest = (w - radius) * SetF(2 - kSlack);
  s.farthest = (w + radius) * SetF(kSlack);
  s.around = ~Less(radius * SetF(1.0001f), w) & 0xff;
  return s;
}

RAYSHADE_KERNEL uint32_t SpheresInPyramid(const SeenSpheres& s, const Corner& c, float most) {
  const uint32_t out = Less(s.u + s.radius, c.u_low) | Less(c.u_high, s.u - s.radius) |
                       Less(s.v + s.radius, c.v_low) | Less(c.v_high, s.v - s.radius) |
                       Less(SetF(most), s.nearest);
  return s.around | (~out & 0xff);
}

// The objects of a leaf as the rays of a bundle see them: lanes in memory, to be read one by one.
struct SeenLeaf {
  bool known;     // else nothing may be left out
  uint32_t bits;  // objects that some ray may meet
  uint32_t around;
  alignas(32) float part[19][8];
};

RAYSHADE_KERNEL void SeeLeaf(const TraceView& view, const Bundle& b, uint64_t branch,
                             SeenLeaf* leaf) {
  const LeafKind kind = KindOf(branch);
  leaf->bits = (1u << CountOf(branch)) - 1;
  leaf->known = leaf->bits != 0 && (b.pointed || kind == kOtherLeaf);
  if (!leaf->known) return;
  if (kind == kOtherLeaf) {
    leaf->bits &= SeeBoxes(view, branch, b, leaf->part);
    return;
  }
  const Slopes<float>& w = b.whole;
  const Corner corner = {SetF(w.u_low), SetF(w.u_high), SetF(w.v_low), SetF(w.v_high)};
  if (kind == kSphereLeaf) {
    const SeenSpheres s = SeeSpheres(view, branch, b.viewpoint, b.apex);
    leaf->bits &= SpheresInPyramid(s, corner, w.most);
    if (leaf->bits == 0) return;
    leaf->around = s.around;
    Store(s.u, leaf->part[0]);
    Store(s.v, leaf->part[1]);
    Store(s.radius, leaf->part[2]);
    Store(s.radius * s.radius * SetF(1.00001f), leaf->part[3]);
    Store(s.nearest, leaf->part[4]);
    if (!b.sure) return;
    Store(s.inner * s.inner, leaf->part[5]);
    Store(s.farthest * SetF(1.0001f), leaf->part[6]);
    return;
  }
  const SeenQuads s = SeeQuads(view, branch, b.viewpoint);
  leaf->bits &= QuadsInPyramid(s, b.viewpoint, corner, w.most);
  if (leaf->bits != 0) StoreQuads(s, leaf->part);
}

// The rays of a group that may meet an object: bits. *surely, where it is not null: those that its
// own test surely counts as hits.
RAYSHADE_KERNEL uint32_t RaysThatMayMeet(const Bundle& b, int g, const SeenLeaf& leaf,
                                         LeafKind kind, uint32_t i, uint32_t* surely = nullptr) {
  if (surely != nullptr) *surely = 0;
  if (!leaf.known) return b.live[g];
  if (kind == kOtherLeaf) return RaysAtSeenBox(b, g, leaf.part, i) & b.live[g];
  const F8 u = LoadF(b.ray_u[g]), v = LoadF(b.ray_v[g]), depth = LoadF(b.ray_most[g]);
  const auto part = [&](int k) { return SetF(leaf.part[k][i]); };
  if (kind == kSphereLeaf) {
    if ((leaf.around >> i & 1) != 0) return b.live[g];
    const F8 du = u - part(0), dv = v - part(1), squared = du * du + dv * dv;
    const uint32_t may = ~(Less(part(3), squared) | Less(depth, part(4))) & b.live[g];
    // The whole sphere lies between the apex and where hits begin to count: the nearer of two hits
    // is within the ray's ends.
    if (surely != nullptr && b.sure) *surely = Less(squared, part(5)) & Less(part(6), depth) & may;
    return may;
  }
  return RaysAtQuad(b, g, leaf.part, i, b.live[g], surely);
}

// The groups of which some ray may meet an object, out of those asked about: bits.
RAYSHADE_KERNEL uint32_t GroupsThatMayMeet(const Bundle& b, const SeenLeaf& leaf, LeafKind kind,
                                           uint32_t i, uint32_t asked) {
  const bool flat = kind == kTriangleLeaf || kind == kPolygonLeaf;
  if (!leaf.known || !flat || (asked & (asked - 1)) == 0) return asked;
  return asked & GroupsAtQuad(b, leaf.part, i);
}
