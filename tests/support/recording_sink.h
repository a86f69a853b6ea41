// A sink that writes down what a scene file says, one line per call, and what its messages were.
#pragma once

#include <string>
#include <vector>

#include "rayshade/scene/options.h"
#include "rayshade/scene/scene_sink.h"

namespace rayshade {

class RecordingSink : public SceneSink {
 public:
  SurfaceId AddSurface(const Surface& surface) override;
  TextureId AddTexture(const TextureSpec& texture) override;
  void AddLight(const LightSpec& light) override;
  void SetAtmosphere(const Atmosphere& atmosphere) override;
  void AddPrimitive(GeomSpec&& spec, Attributes&& attributes) override;
  void AddInstance(DefinitionId definition, Attributes&& attributes) override;
  void BeginAggregate(AggregateKind kind, const int counts[3]) override;
  bool EndAggregate(Attributes&& attributes) override;
  void BeginDefinition() override;
  DefinitionId EndDefinition() override;
  void OnSettings(const Settings& settings) override;

  // Objects and aggregates: "sphere s0 x1 t2" is a sphere with surface 0, one link, textures 2.
  std::vector<std::string> calls;
  std::vector<GeomSpec> geoms;
  std::vector<Attributes> attributes;  // of primitives
  std::vector<Surface> surfaces;
  std::vector<TextureSpec> textures;
  std::vector<LightSpec> lights;
  std::vector<Atmosphere> atmospheres;
  std::vector<Settings> settings;  // at most one

 private:
  std::vector<int> members_{0};
  std::vector<bool> csg_;  // of open aggregates
  DefinitionId definitions_ = 0;
};

struct Reading {
  RecordingSink sink;
  bool good = false;
  int status = 0;
  std::string messages;  // program name: rs; a text's file name: stdin
};

Reading ReadText(const std::string& text, const Options& options = {});
Reading ReadFile(const std::string& file, Options options = {});

// The folder ../shared (RAYSHADE_SHARED), "" where it is absent.
std::string SharedFolder();

}  // namespace rayshade
