// A scene from text, and single rays through it.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "rayshade/render/sequential_tracer.h"
#include "rayshade/scene/parse.h"
#include "rayshade/scene/scene_builder.h"

namespace rayshade::test {

class TextScene {
 public:
  explicit TextScene(const std::string& text, int frame = 0) {
    Options options;
    options.program = "test";
    Diagnostics diagnostics("test");
    EXPECT_TRUE(ParseText(text, options, &diagnostics, &builder_)) << text;
    built_ = builder_.Build(frame);
  }

  const Scene& scene() const { return *built_.scene; }
  const ObjectSet& objects() const { return *built_.objects; }
  const OpCounts& counts() const { return counts_; }

  static Ray RayTo(const Vector& origin, const Vector& direction) {
    Ray ray;
    ray.origin = origin;
    ray.direction = Normalized(direction);
    return ray;
  }
  RayResult Trace(const Ray& ray) {
    RayBundle bundle;
    bundle.rays = {ray};
    RayResult result;
    TraceBundle(scene(), objects(), bundle, {&result, 1}, &counts_);
    return result;
  }
  RayResult Trace(const Vector& origin, const Vector& direction) {
    return Trace(RayTo(origin, direction));
  }
  // The ray from the eye to the look point.
  RayResult AlongView() {
    const Settings& settings = scene().settings();
    return Trace(settings.eye, settings.look - settings.eye);
  }
  // What the ray hits, resolved.
  SurfaceHit HitBy(const Vector& origin, const Vector& direction) {
    const Ray ray = RayTo(origin, direction);
    Hit hit;
    objects().Nearest({&ray, 1}, {&hit, 1}, &counts_);
    EXPECT_TRUE(hit.found());
    SurfaceHit resolved;
    if (hit.found()) ResolveHit(scene(), ray, hit, &resolved);
    return resolved;
  }

 private:
  SceneBuilder builder_;
  SceneBuilder::Built built_;
  OpCounts counts_;
};

}  // namespace rayshade::test
