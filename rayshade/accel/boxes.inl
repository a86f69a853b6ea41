// Boxes in leaves against the single rays of a group; part of trace.inl. Rays are lines of no width
// among the pyramids of pyramid.inl, rounded outwards in the same way.

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
  F8 depth;
  return BoxesInPyramid(b, part, -1, &depth);
}

// The rays of a group that may meet one of the boxes.
RAYSHADE_KERNEL uint32_t RaysAtSeenBox(const Bundle& b, int g, const float (*part)[8], uint32_t i) {
  return PyramidsAtBox(b, RaysAsPyramids(b, g), part, i);
}
