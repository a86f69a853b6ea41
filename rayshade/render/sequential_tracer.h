// Tracing in one process: bundles level by level through the shading functions, with everything at
// hand.
#pragma once

#include <span>

#include "rayshade/accel/object_set.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/shade/shade.h"

namespace rayshade {

// results[i] for rays[i] of the bundle. Secondary rays are traced in bundles too: all transmitted
// rays of this one, then all reflected ones.
void TraceBundle(const Scene& scene, const ObjectSet& objects, const RayBundle& bundle,
                 std::span<RayResult> results, OpCounts* counts);

// Follows shadow rays to their limits: shadows[i].color becomes what arrives, arrived[i] whether
// anything does.
void TraceShadows(const Scene& scene, const ObjectSet& objects, std::span<ShadowRay> shadows,
                  std::span<uint8_t> arrived, OpCounts* counts);

}  // namespace rayshade
