// Tracing in one process: bundles level by level through the shading functions, with everything at
// hand.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/shade/crossing.h"
#include "rayshade/shade/shade.h"

namespace rayshade {

// Room for shadow rays that are traced together. Its arrays grow to the largest bundle and stay.
class ShadowTracer {
 public:
  // scene, objects: not owned. REQUIRES: `objects` holds everything.
  ShadowTracer(const Scene* scene, const ObjectSet* objects) : scene_(scene), objects_(objects) {}

  // Follows shadow rays to their limits: colors[i] becomes what arrives, blocked[i] 1 where nothing
  // does.
  void Trace(std::span<const Ray> rays, std::span<const double> limits, std::span<Color> colors,
             std::span<uint8_t> blocked, OpCounts* counts);

  // What something transparent in its way leaves of a shadow ray's light; false: nothing.
  bool Pass(const Ray& ray, double limit, Color* color, OpCounts* counts);

 private:
  // What is in the way of rays[i] lets light through, more or less.
  bool PassTransparent(const Ray& ray, double limit, Color* color, OpCounts* counts);

  const Scene* scene_;
  const ObjectSet* objects_;
  std::vector<uint8_t> crossed_;  // rays that something transparent is in the way of
  std::vector<ShadowCrossing> crossings_;
};

// Traces bundle after bundle; keeps its room from one to the next.
class SequentialTracer {
 public:
  // scene, objects: not owned. REQUIRES: `objects` holds everything.
  SequentialTracer(const Scene* scene, const ObjectSet* objects);
  ~SequentialTracer();

  // results[i] for rays[i] of the bundle, of any size. Secondary rays are traced in bundles too:
  // all transmitted rays of up to 1024 rays, then all reflected ones.
  void Trace(const RayBundle& bundle, std::span<RayResult> results, OpCounts* counts);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// A single bundle. Many are traced faster by one SequentialTracer.
void TraceBundle(const Scene& scene, const ObjectSet& objects, const RayBundle& bundle,
                 std::span<RayResult> results, OpCounts* counts);

}  // namespace rayshade
