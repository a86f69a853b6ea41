// The kernels. Included once per instruction set, inside an unnamed namespace and after the set's
// simd_*.inl; nothing here may depend on more than that and on trace_view.h.
// Each builds on those before:
// clang-format off
#include "rayshade/accel/quads.inl"
#include "rayshade/accel/single_rays.inl"
#include "rayshade/accel/walkers.inl"
#include "rayshade/accel/pyramid.inl"
#include "rayshade/accel/boxes.inl"
#include "rayshade/accel/seen_quads.inl"
#include "rayshade/accel/filter.inl"
#include "rayshade/accel/flat_kinds.inl"
#include "rayshade/accel/bundles.inl"
#include "rayshade/accel/ray_arrays.inl"
#include "rayshade/accel/group.inl"
#include "rayshade/accel/box_rows.inl"
#include "rayshade/accel/light_rows.inl"
#include "rayshade/accel/rows.inl"
// clang-format on

RAYSHADE_KERNEL void AddTo(OpCounts* counts, Counters counters) {
  counts->node_visits += counters.nodes;
  counts->lone_visits += counters.lone_nodes;
  counts->lone_tests += counters.lone_tests;
  counters.kinds[kSphereGeom].tests += counters.flat_tests[kSphereLeaf];
  counters.kinds[kTriangleGeom].tests += counters.flat_tests[kTriangleLeaf];
  counters.kinds[kPolygonGeom].tests += counters.flat_tests[kPolygonLeaf];
  for (int i = 0; i < kGeomKinds; ++i) {
    counts->primitive_tests += counters.kinds[i].tests;
    counts->kinds[i].tests += counters.kinds[i].tests;
    counts->kinds[i].hits += counters.kinds[i].hits;
  }
}

// Rays come in an order that has neighbours together: up to 64 at a time are taken for a bundle if
// they are coherent, else eight at a time; those that are not are traced one by one in the end.
void Nearest(const TraceView& view, const Ray* rays, Hit* hits, uint32_t count, OpCounts* counts) {
  Counters counters;
  for (uint32_t i = 0; i < count; i += kLoneMost) {
    const uint32_t size = count - i < kLoneMost ? count - i : kLoneMost;
    NearestOfMany(view, rays + i, hits + i, size, &counters);
  }
  AddTo(counts, counters);
}

void Block(const TraceView& view, const Ray* rays, const double* limits, uint8_t* blocked,
           uint8_t* crossed, uint32_t count, OpCounts* counts) {
  Counters counters;
  const Fate fate = {blocked, crossed};
  for (uint32_t i = 0; i < count; i += kLoneMost) {
    const uint32_t size = count - i < kLoneMost ? count - i : kLoneMost;
    BlockMany(view, rays + i, limits + i, FateFrom(fate, i), size, &counters);
  }
  AddTo(counts, counters);
}

void BlockRows(const TraceView& view, const ShadowRows& rows, OpCounts* counts) {
  Counters counters;
  LoneRays lone;
  uint64_t last_blocker = 0;
  for (uint32_t i = 0; i < rows.count; i += kBundleSize) {
    const uint32_t size = rows.count - i < kBundleSize ? rows.count - i : kBundleSize;
    BlockRowsOfBundle(view, rows, i, size, &lone, &last_blocker, &counters);
    if (lone.count <= kLoneMost - kBundleSize && i + size < rows.count) continue;
    BlockLoneOfRows(view, rows, lone, &counters);
    lone.Clear();
  }
  AddTo(counts, counters);
}
