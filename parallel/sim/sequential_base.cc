// See sequential_base.h.
#include "parallel/sim/sequential_base.h"

#include <map>
#include <memory>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "rayshade/geom/make_geom.h"
#include "rayshade/render/camera.h"
#include "rayshade/render/pixel_sampling.h"
#include "rayshade/render/sequential_tracer.h"

namespace rayshade::parallel {

namespace {

constexpr size_t kBundle = 1024;

void AddObjects(ObjectSpool* spool, Scene* scene, ObjectSet* set) {
  std::map<uint32_t, PlacementId> placements;
  std::map<uint32_t, std::shared_ptr<const Geom>> members;
  spool->Rewind();
  for (SpooledObject spooled; spool->Next(true, &spooled);) {
    const WireObject& object = spooled.object;
    const auto [placement, added] = placements.try_emplace(
        object.placement, static_cast<PlacementId>(scene->spec.placements.size()));
    if (added) scene->spec.placements.push_back(spool->placement(object.placement));
    if (object.member == 0) {
      set->Add(object.geom, placement->second, object.rank);
      continue;
    }
    std::shared_ptr<const Geom>& member = members[object.member];
    if (member == nullptr) member = MakeGeom(object.geom, scene->shutter);
    set->Add(member, object.geom.index(), placement->second, object.rank);
  }
}

}  // namespace

WorkDone SequentialWork(ObjectSpool* spool, int frame, Picture* picture) {
  Scene scene(spool->scene(), frame);
  ObjectSet objects(&scene);
  AddObjects(spool, &scene, &objects);
  objects.Build();

  WorkDone work;
  const Camera camera(spool->scene().settings, frame);
  PixelSampling sampling(spool->scene().settings, camera, /*ahead=*/false);
  SequentialTracer tracer(&scene, &objects);
  RayBundle bundle;
  std::vector<RayResult> results;
  while (!sampling.done()) {
    const std::vector<Sample> samples = sampling.Next(kBundle);
    bundle.clear();
    camera.AppendPrimaryRays(samples, &bundle.rays);
    results.assign(samples.size(), {});
    tracer.Trace(bundle, results, &work.counts);
    sampling.Put(samples, results);
    work.samples += 2 * samples.size();
  }
  if (picture != nullptr) *picture = sampling.picture();
  return work;
}

}  // namespace rayshade::parallel
