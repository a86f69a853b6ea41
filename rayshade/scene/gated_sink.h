// A sink that hands on what it gets until the first error; what follows is read for its mistakes
// only.
#pragma once

#include <utility>

#include "rayshade/scene/reporter.h"
#include "rayshade/scene/scene_sink.h"

namespace rayshade {

class GatedSink final : public SceneSink {
 public:
  GatedSink(SceneSink* sink, const Reporter* reporter) : sink_(sink), reporter_(reporter) {}

  SurfaceId AddSurface(const Surface& surface) override {
    return open() ? sink_->AddSurface(surface) : 0;
  }
  TextureId AddTexture(const TextureSpec& texture) override {
    return open() ? sink_->AddTexture(texture) : 0;
  }
  void AddLight(const LightSpec& light) override {
    if (open()) sink_->AddLight(light);
  }
  void SetAtmosphere(const Atmosphere& atmosphere) override {
    if (open()) sink_->SetAtmosphere(atmosphere);
  }
  void AddPrimitive(GeomSpec&& spec, Attributes&& attributes) override {
    if (open()) sink_->AddPrimitive(std::move(spec), std::move(attributes));
  }
  void AddInstance(DefinitionId definition, Attributes&& attributes) override {
    if (open()) sink_->AddInstance(definition, std::move(attributes));
  }
  void BeginAggregate(AggregateKind kind, const int counts[3]) override {
    if (open()) sink_->BeginAggregate(kind, counts);
  }
  bool EndAggregate(Attributes&& attributes) override {
    return open() ? sink_->EndAggregate(std::move(attributes)) : true;
  }
  void BeginDefinition() override {
    if (open()) sink_->BeginDefinition();
  }
  DefinitionId EndDefinition() override { return open() ? sink_->EndDefinition() : 0; }
  void OnSettings(const Settings& settings) override {
    if (open()) sink_->OnSettings(settings);
  }

 private:
  bool open() const { return !reporter_->failed(); }

  SceneSink* sink_;
  const Reporter* reporter_;
};

}  // namespace rayshade
