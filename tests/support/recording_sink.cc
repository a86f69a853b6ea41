// See recording_sink.h.
#include "tests/support/recording_sink.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "rayshade/scene/parse.h"

namespace rayshade {
namespace {

constexpr const char* kKinds[] = {"sphere", "box",       "plane",       "disc",     "triangle",
                                  "phong",  "trianglev", "poly",        "cylinder", "cone",
                                  "torus",  "blob",      "heightfield", "composite"};
constexpr const char* kAggregates[] = {"list", "grid", "union", "intersect", "difference"};

std::string Around(const Attributes& a) {
  std::string text;
  if (a.surface != kNoSurface) text += " s" + std::to_string(a.surface);
  if (!a.transforms.empty()) text += " x" + std::to_string(a.transforms.size());
  for (const TextureId texture : a.textures) text += " t" + std::to_string(texture);
  return text;
}

Reading Read(const std::function<bool(Diagnostics*, SceneSink*)>& parse) {
  Reading reading;
  char* text = nullptr;
  size_t size = 0;
  std::FILE* stream = open_memstream(&text, &size);
  Diagnostics diagnostics("rs", stream);
  reading.good = parse(&diagnostics, &reading.sink);
  reading.status = diagnostics.exit_status();
  std::fclose(stream);
  reading.messages.assign(text, size);
  std::free(text);
  return reading;
}

}  // namespace

SurfaceId RecordingSink::AddSurface(const Surface& surface) {
  surfaces.push_back(surface);
  return static_cast<SurfaceId>(surfaces.size() - 1);
}
TextureId RecordingSink::AddTexture(const TextureSpec& texture) {
  textures.push_back(texture);
  return static_cast<TextureId>(textures.size() - 1);
}
void RecordingSink::AddLight(const LightSpec& light) { lights.push_back(light); }
void RecordingSink::SetAtmosphere(const Atmosphere& atmosphere) {
  atmospheres.push_back(atmosphere);
}
void RecordingSink::AddPrimitive(GeomSpec&& spec, Attributes&& around) {
  calls.push_back(kKinds[spec.index()] + Around(around));
  geoms.push_back(std::move(spec));
  attributes.push_back(std::move(around));
  ++members_.back();
}
void RecordingSink::AddInstance(DefinitionId definition, Attributes&& around) {
  calls.push_back("object " + std::to_string(definition) + Around(around));
  ++members_.back();
}
void RecordingSink::BeginAggregate(AggregateKind kind, const int counts[3]) {
  std::string call = kAggregates[static_cast<int>(kind)];
  for (int i = 0; kind == AggregateKind::kGrid && i < 3; ++i) {
    call += " " + std::to_string(counts[i]);
  }
  calls.push_back(call);
  members_.push_back(0);
  csg_.push_back(IsCsg(kind));
}
bool RecordingSink::EndAggregate(Attributes&& around) {
  const bool kept = csg_.back() ? members_.back() == 2 : members_.back() > 0;
  members_.pop_back();
  csg_.pop_back();
  members_.back() += kept;
  calls.push_back((kept ? "end" : "end of nothing") + Around(around));
  return kept;
}
void RecordingSink::BeginDefinition() {
  calls.push_back("name");
  members_.push_back(0);
}
DefinitionId RecordingSink::EndDefinition() {
  const bool kept = members_.back() > 0;
  members_.pop_back();
  calls.push_back(kept ? "named " + std::to_string(definitions_) : "named nothing");
  return kept ? definitions_++ : kNoDefinition;
}
void RecordingSink::OnSettings(const Settings& s) { settings.push_back(s); }

Reading ReadText(const std::string& text, const Options& options) {
  return Read([&](Diagnostics* diagnostics, SceneSink* sink) {
    return ParseText(text, options, diagnostics, sink);
  });
}

Reading ReadFile(const std::string& file, Options options) {
  options.input = file;
  return Read([&](Diagnostics* diagnostics, SceneSink* sink) {
    return ParseScene(options, diagnostics, sink);
  });
}

std::string SharedFolder() {
  const char* named = std::getenv("RAYSHADE_SHARED");
  const std::string folder = named ? named : "../shared";
  return std::filesystem::is_directory(folder) ? folder : "";
}

}  // namespace rayshade
