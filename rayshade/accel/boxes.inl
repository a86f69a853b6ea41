// Boxes in leaves and nodes against the single rays of a group; part of trace.inl. Rays are lines
// of no width among the pyramids of pyramid.inl, rounded outwards in the same way.

RAYSHADE_KERNEL Slopes<F8> RaysAsPyramids(const Bundle& b, int g) {
  const F8 u = LoadF(b.ray_u[g]), v = LoadF(b.ray_v[g]), slack = SetF(3 * kSlopeSlack);
  return {u - slack, u + slack, v - slack, v + slack, LoadF(b.ray_most[g])};
}

// The boxes of a leaf of other objects (quads.h) that the bundle may meet: bits. part: their
// planes.
RAYSHADE_KERNEL uint32_t SeeBoxes(const TraceView& view, uint64_t branch, const Bundle& b,
                                  float (*part)[8]) {
  const uint32_t count = CountOf(branch);
  const float* rows =
      view.flat->quads + static_cast<size_t>(kQuadRows) * (ChildOf(branch) - view.sphere_count);
  for (uint32_t k = 0; k < 6; ++k) Store(LoadF(rows + k * count), part[k]);
  const Slopes<float>& w = b.whole;
  const Slopes<F8> p = {SetF(w.u_low), SetF(w.u_high), SetF(w.v_low), SetF(w.v_high), SetF(w.most)};
  F8 depth;
  return MeetPyramids(b, p, LoadF(part[b.near_plane]), LoadF(part[b.far_plane]), LoadF(part[b.u]),
                      LoadF(part[3 + b.u]), LoadF(part[b.v]), LoadF(part[3 + b.v]), &depth);
}

// The rays of a group that may meet one of the boxes.
RAYSHADE_KERNEL uint32_t RaysAtSeenBox(const Bundle& b, int g, const float (*part)[8], uint32_t i) {
  F8 depth;
  return MeetPyramids(b, RaysAsPyramids(b, g), SetF(part[b.near_plane][i]),
                      SetF(part[b.far_plane][i]), SetF(part[b.u][i]), SetF(part[3 + b.u][i]),
                      SetF(part[b.v][i]), SetF(part[3 + b.v][i]), &depth);
}

// One child of a node against the rays of a group: bits of the rays.
RAYSHADE_KERNEL uint32_t RaysAtChild(const Bundle& b, const Slopes<F8>& rays, const Node& node,
                                     uint32_t i) {
  F8 depth;
  return MeetPyramids(b, rays, SetF(node.plane[b.near_plane][i]), SetF(node.plane[b.far_plane][i]),
                      SetF(node.plane[b.u][i]), SetF(node.plane[3 + b.u][i]),
                      SetF(node.plane[b.v][i]), SetF(node.plane[3 + b.v][i]), &depth);
}
