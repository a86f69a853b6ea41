// The sink of the sequential tracer: a scene and one object set with everything in it. What is
// common with the parallel host's sink (which keeps objects on disk) is in scene/skeleton.h.
#pragma once

#include <memory>

#include "rayshade/accel/object_set.h"
#include "rayshade/scene/scene.h"
#include "rayshade/scene/skeleton_sink.h"

namespace rayshade {

class SceneBuilder : public SkeletonSink {
 public:
  SceneBuilder();
  ~SceneBuilder() override;

  void OnSettings(const Settings& settings) override;

  // After parsing: what file and command line say together.
  const Settings& settings() const;

  // After parsing: scene and objects of one frame, ready to trace. May be called once, or, where
  // the settings say that there is more than one frame, for each of them.
  struct Built {
    std::unique_ptr<Scene> scene;
    std::unique_ptr<ObjectSet> objects;
  };
  Built Build(int frame);

 private:
  Skeleton& skeleton() override;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayshade
