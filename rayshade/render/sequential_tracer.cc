// Level by level: nearest hits of a whole bundle, then one light after the other for all of its
// hits, then all secondary rays as the bundle of the next level; see sequential_tracer.h.
#include "rayshade/render/sequential_tracer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rayshade/common/check.h"
#include "rayshade/shade/hit_rows.h"

namespace rayshade {
namespace {

// What is in work at a time should stay in the processor's second cache.
constexpr size_t kBundleSize = HitRows::kMost;

// Puts the rays of `from` behind those of *to, with their media; `from` is used up.
void AppendBundle(RayBundle&& from, RayBundle* to) {
  if (to->empty()) {
    std::swap(from, *to);
    return;
  }
  const auto shift = static_cast<uint32_t>(to->media.size());
  to->media.insert(to->media.end(), from.media.begin(), from.media.end());
  for (Ray ray : from.rays) {
    ray.media_begin += shift;
    to->rays.push_back(ray);
  }
}

void CountRays(std::span<const Ray> rays, OpCounts* counts) {
  for (const Ray& ray : rays) {
    if (ray.kind == RayKind::kReflected) {
      ++counts->reflected_rays;
    } else if (ray.kind == RayKind::kRefracted) {
      ++counts->refracted_rays;
    } else {
      ++counts->primary_rays;
    }
  }
}

// What one level of a bundle is worked on with.
struct Level {
  std::vector<Hit> hits;
  std::vector<SurfaceHit> surfaces;  // of the rays that hit something
  std::vector<uint32_t> owners;      // their rays
  std::vector<Color> colors;         // ambient light and lights, by surface
  std::vector<Secondary> secondary;  // by surface
  RayBundle children, reflected;     // transmitted rays, then the reflected ones
  std::vector<RayResult> child_results;

  Level()
      : hits(kBundleSize),
        surfaces(kBundleSize),
        owners(kBundleSize),
        colors(kBundleSize),
        secondary(kBundleSize) {}
};

// Shadow rays of one light.
struct ShadowBatch {
  std::vector<Ray> rays;
  std::vector<LightSample> samples;
  std::vector<uint32_t> surfaces;  // whose they are
  std::vector<double> limits;
  std::vector<Color> colors;
  std::vector<uint8_t> blocked;

  ShadowBatch()
      : rays(kBundleSize),
        samples(kBundleSize),
        surfaces(kBundleSize),
        limits(kBundleSize),
        colors(kBundleSize),
        blocked(kBundleSize) {}
};

}  // namespace

void ShadowTracer::Trace(std::span<const Ray> rays, std::span<const double> limits,
                         std::span<Color> colors, std::span<uint8_t> blocked, OpCounts* counts) {
  std::fill(blocked.begin(), blocked.end(), uint8_t{0});
  if (rays.empty()) return;
  const bool any_transparent = scene_->any_transparent;
  crossed_.assign(any_transparent ? rays.size() : 0, 0);
  objects_->Block(rays, limits, blocked, crossed_, counts);
  for (size_t i = 0; i < rays.size(); ++i) {
    if (blocked[i]) {
      ++counts->shadow_hits;
    } else if (any_transparent && crossed_[i]) {
      blocked[i] = !Pass(rays[i], limits[i], &colors[i], counts);
    }
  }
}

bool ShadowTracer::Pass(const Ray& ray, double limit, Color* color, OpCounts* counts) {
  crossings_.clear();
  const bool passed = PassTransparent(ray, limit, color, counts);
  counts->shadow_hits += !passed || !crossings_.empty();
  return passed;
}

bool ShadowTracer::PassTransparent(const Ray& ray, double limit, Color* color, OpCounts* counts) {
  if (!scene_->settings().shadow_transparency) {
    Hit hit;
    hit.distance = limit;
    objects_->Nearest({&ray, 1}, {&hit, 1}, counts);
    return !hit.found();
  }
  CollectCrossings(*scene_, *objects_, ray, limit, &crossings_, counts);
  if (crossings_.empty()) return true;
  const std::optional<Color> left = FoldCrossings(&crossings_, *color);
  if (left) *color = *left;
  return left.has_value();
}

struct SequentialTracer::Impl {
  Impl(const Scene* the_scene, const ObjectSet* the_objects)
      : scene(*the_scene), objects(*the_objects), shadow_tracer(the_scene, the_objects) {}

  void TraceLevel(size_t depth, std::span<const Ray> rays, const std::vector<Medium>& media,
                  std::span<RayResult> results, OpCounts* counts);
  size_t Resolve(std::span<const Ray> rays, std::span<RayResult> results, Level* level);
  void Illuminate(std::span<const Ray> rays, size_t count, Level* level, OpCounts* counts);
  void AddThroughTransparent(uint32_t light, std::span<const Ray> rays, const Level& level,
                             OpCounts* counts);
  void IlluminateBy(uint32_t light, std::span<const Ray> rays, size_t count, Level* level,
                    OpCounts* counts);
  void Spawn(std::span<const Ray> rays, const std::vector<Medium>& media, size_t count,
             Level* level);
  void Fold(std::span<const Ray> rays, size_t count, size_t transmitted, const Level& level,
            std::span<RayResult> results);

  const Scene& scene;
  const ObjectSet& objects;
  ShadowTracer shadow_tracer;
  ShadowBatch shadows;
  std::unique_ptr<HitRows> rows = std::make_unique<HitRows>();
  HitPath path;
  std::vector<std::unique_ptr<Level>> levels;
};

// Hits become surfaces, misses are done with. Returns how many hits there are.
size_t SequentialTracer::Impl::Resolve(std::span<const Ray> rays, std::span<RayResult> results,
                                       Level* level) {
  size_t count = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    const Hit& hit = level->hits[i];
    if (!hit.found()) {
      results[i] = ShadeMiss(scene, rays[i], rays[i].media_count == 0);
      continue;
    }
    SurfaceHit& surface = level->surfaces[count];
    ResolveHit(scene, rays[i], hit, &path, &surface);
    level->owners[count] = static_cast<uint32_t>(i);
    level->colors[count] = ShadeAmbient(scene, surface);
    ++count;
  }
  return count;
}

// One light after the other, in visiting order.
void SequentialTracer::Impl::Illuminate(std::span<const Ray> rays, size_t count, Level* level,
                                        OpCounts* counts) {
  if (count == 0) return;
  rows->Set(scene, rays, {level->surfaces.data(), count}, {level->owners.data(), count},
            {level->colors.data(), count});
  for (uint32_t light = 0; light < scene.lights.size(); ++light) {
    const Light& source = *scene.lights[light];
    if (HitRows::Suit(scene, source)) {
      rows->Trace(scene, objects, source, counts);
      if (scene.any_transparent) AddThroughTransparent(light, rays, *level, counts);
      rows->AddUp(objects, source);
    } else {
      rows->Clear();
    }
    if (!rows->all_done()) IlluminateBy(light, rays, count, level, counts);
  }
  rows->Finish();
}

// What something transparent leaves of a light that the rows have traced.
void SequentialTracer::Impl::AddThroughTransparent(uint32_t light, std::span<const Ray> rays,
                                                   const Level& level, OpCounts* counts) {
  rows->ForEachCrossed([&](size_t s) {
    rows->TakeOut(s);
    LightSample sample = rows->Sample(*scene.lights[light], light, s);
    Ray shadow;
    MakeShadowRay(rays[level.owners[s]], level.surfaces[s], sample.toward, &shadow);
    if (shadow_tracer.Pass(shadow, sample.limit, &sample.color, counts))
      rows->Add(s, sample, sample.color);
  });
}

// One light, for the hits that are not done by rows.
void SequentialTracer::Impl::IlluminateBy(uint32_t light, std::span<const Ray> rays, size_t count,
                                          Level* level, OpCounts* counts) {
  ShadowBatch& batch = shadows;
  size_t traced = 0;
  for (size_t s = 0; s < count; ++s) {
    if (rows->done(s)) continue;
    LightSample& sample = batch.samples[traced];
    if (!SampleLight(scene, light, rays[level->owners[s]], level->surfaces[s], &sample,
                     &batch.rays[traced], counts)) {
      continue;
    }
    if (!sample.traced) {
      rows->Add(s, sample, sample.color);
      continue;
    }
    batch.surfaces[traced] = static_cast<uint32_t>(s);
    batch.limits[traced] = sample.limit;
    batch.colors[traced] = sample.color;
    ++traced;
  }
  shadow_tracer.Trace({batch.rays.data(), traced}, {batch.limits.data(), traced},
                      {batch.colors.data(), traced}, {batch.blocked.data(), traced}, counts);
  for (size_t i = 0; i < traced; ++i) {
    if (!batch.blocked[i]) rows->Add(batch.surfaces[i], batch.samples[i], batch.colors[i]);
  }
}

void SequentialTracer::Impl::Spawn(std::span<const Ray> rays, const std::vector<Medium>& media,
                                   size_t count, Level* level) {
  level->children.clear();
  level->reflected.clear();
  for (size_t s = 0; s < count; ++s) {
    const Ray& ray = rays[level->owners[s]];
    SpawnSecondary(scene, ray, std::span(media).subspan(ray.media_begin, ray.media_count),
                   level->surfaces[s], &level->children, &level->reflected, &level->secondary[s]);
  }
}

void SequentialTracer::Impl::Fold(std::span<const Ray> rays, size_t count, size_t transmitted,
                                  const Level& level, std::span<RayResult> results) {
  const RayResult* next_transmitted = level.child_results.data();
  const RayResult* next_reflected = next_transmitted + transmitted;
  const RayResult none;
  for (size_t s = 0; s < count; ++s) {
    const uint32_t i = level.owners[s];
    const Secondary& secondary = level.secondary[s];
    results[i] =
        Shade(scene, rays[i], rays[i].media_count == 0, level.hits[i].distance, level.colors[s],
              secondary, secondary.transmitted.wanted ? *next_transmitted++ : none,
              secondary.reflected.wanted ? *next_reflected++ : none);
  }
}

void SequentialTracer::Impl::TraceLevel(size_t depth, std::span<const Ray> rays,
                                        const std::vector<Medium>& media,
                                        std::span<RayResult> results, OpCounts* counts) {
  if (levels.size() <= depth) levels.push_back(std::make_unique<Level>());
  Level& level = *levels[depth];
  CountRays(rays, counts);
  std::fill_n(level.hits.begin(), rays.size(), Hit());
  objects.Nearest(rays, {level.hits.data(), rays.size()}, counts);
  const size_t count = Resolve(rays, results, &level);
  counts->hits += count;
  counts->shades += count;
  Illuminate(rays, count, &level, counts);

  // The next level.
  Spawn(rays, media, count, &level);
  const size_t transmitted = level.children.size();
  AppendBundle(std::move(level.reflected), &level.children);
  const size_t children = level.children.size();
  if (level.child_results.size() < children) level.child_results.resize(children);
  for (size_t begin = 0; begin < children; begin += kBundleSize) {
    const size_t size = std::min(kBundleSize, children - begin);
    TraceLevel(depth + 1, {level.children.rays.data() + begin, size}, level.children.media,
               {level.child_results.data() + begin, size}, counts);
  }
  Fold(rays, count, transmitted, level, results);
}

SequentialTracer::SequentialTracer(const Scene* scene, const ObjectSet* objects)
    : impl_(std::make_unique<Impl>(scene, objects)) {}
SequentialTracer::~SequentialTracer() = default;

void SequentialTracer::Trace(const RayBundle& bundle, std::span<RayResult> results,
                             OpCounts* counts) {
  CHECK(results.size() == bundle.size());
  for (size_t begin = 0; begin < bundle.size(); begin += kBundleSize) {
    const size_t size = std::min(kBundleSize, bundle.size() - begin);
    impl_->TraceLevel(0, {bundle.rays.data() + begin, size}, bundle.media,
                      results.subspan(begin, size), counts);
  }
}

void TraceBundle(const Scene& scene, const ObjectSet& objects, const RayBundle& bundle,
                 std::span<RayResult> results, OpCounts* counts) {
  SequentialTracer(&scene, &objects).Trace(bundle, results, counts);
}

}  // namespace rayshade
