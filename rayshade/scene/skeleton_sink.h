// A sink that hands everything on to its skeleton; what its objects' store is, in memory or on
// disk, is the heir's.
#pragma once

#include <utility>

#include "rayshade/scene/skeleton.h"

namespace rayshade {

class SkeletonSink : public SceneSink {
 public:
  SurfaceId AddSurface(const Surface& surface) override { return skeleton().AddSurface(surface); }
  TextureId AddTexture(const TextureSpec& texture) override {
    return skeleton().AddTexture(texture);
  }
  void AddLight(const LightSpec& light) override { skeleton().AddLight(light); }
  void SetAtmosphere(const Atmosphere& atmosphere) override {
    skeleton().SetAtmosphere(atmosphere);
  }
  void AddPrimitive(GeomSpec&& spec, Attributes&& attributes) override {
    skeleton().AddPrimitive(std::move(spec), std::move(attributes));
  }
  void AddInstance(DefinitionId definition, Attributes&& attributes) override {
    skeleton().AddInstance(definition, std::move(attributes));
  }
  void BeginAggregate(AggregateKind kind, const int counts[3]) override {
    skeleton().BeginAggregate(kind, counts);
  }
  bool EndAggregate(Attributes&& attributes) override {
    return skeleton().EndAggregate(std::move(attributes));
  }
  void BeginDefinition() override { skeleton().BeginDefinition(); }
  DefinitionId EndDefinition() override { return skeleton().EndDefinition(); }
  void OnSettings(const Settings& settings) override { skeleton().OnSettings(settings); }

  const std::vector<size_t>& kinds_read() { return skeleton().kinds_read(); }
  uint64_t primitives_placed() { return skeleton().primitives_placed(); }

 private:
  virtual Skeleton& skeleton() = 0;
};

}  // namespace rayshade
