// The parsed scene with its objects on disk: the sink of a parallel run's host. Memory does not
// grow with the number of objects; the host reads them back in passes.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "parallel/message.h"
#include "rayshade/scene/scene.h"
#include "rayshade/scene/skeleton_sink.h"

namespace rayshade::parallel {

// A placed object as a pass over the spool gives it.
struct SpooledObject {
  bool bounded = true;
  Bounds bounds;       // world, as WorldBounds gives them
  uint64_t bytes = 0;  // that it will occupy in a process, estimated
  WireObject object;   // decoded only where asked for
};

class ObjectSpool : public SkeletonSink {
 public:
  // Files are made in $TMPDIR or /tmp and vanish with the process. Throws std::runtime_error where
  // they cannot be written (a full disk).
  ObjectSpool();
  ~ObjectSpool() override;

  // After parsing. Places all objects as they stand in this frame; must be called before what
  // follows.
  void Place(int frame);
  const Settings& settings() const;  // known after parsing, before Place
  const SceneSpec& scene() const;
  const Placement& placement(uint32_t number) const;
  uint64_t size() const;  // placed objects

  // A pass over the placed objects, in an order that is always the same: Rewind, then Next until it
  // gives false. geometry: whether object->object is wanted.
  void Rewind();
  bool Next(bool geometry, SpooledObject* object);

 private:
  Skeleton& skeleton() override;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayshade::parallel
