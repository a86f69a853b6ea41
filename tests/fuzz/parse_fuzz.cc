// libFuzzer's way into the parser: any bytes are a scene, read without preprocessor into a sink
// that only counts. Built with clang++ -fsanitize=fuzzer,address,undefined together with the core's
// sources; the reference scenes are a good corpus to start from, the keywords a dictionary.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

#include "rayshade/scene/parse.h"

namespace rayshade {
namespace {

class CountingSink : public SceneSink {
 public:
  SurfaceId AddSurface(const Surface&) override { return surfaces_++; }
  TextureId AddTexture(const TextureSpec&) override { return textures_++; }
  void AddLight(const LightSpec&) override {}
  void SetAtmosphere(const Atmosphere&) override {}
  void AddPrimitive(GeomSpec&&, Attributes&&) override { ++members_.back(); }
  void AddInstance(DefinitionId id, Attributes&&) override {
    if (id >= definitions_) __builtin_trap();
    ++members_.back();
  }
  void BeginAggregate(AggregateKind, const int[3]) override { members_.push_back(0); }
  bool EndAggregate(Attributes&&) override { return Close(); }
  void BeginDefinition() override { members_.push_back(0); }
  DefinitionId EndDefinition() override {
    const bool kept = members_.back() > 0;
    members_.pop_back();
    return kept ? definitions_++ : kNoDefinition;
  }
  void OnSettings(const Settings&) override {
    if (members_.size() != 1 || members_[0] == 0) __builtin_trap();  // unbalanced, or empty
  }

 private:
  bool Close() {
    const bool kept = members_.back() > 0;
    members_.pop_back();
    members_.back() += kept;
    return kept;
  }

  std::vector<int> members_{0};
  SurfaceId surfaces_ = 0;
  TextureId textures_ = 0;
  DefinitionId definitions_ = 0;
};

}  // namespace
}  // namespace rayshade

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static std::FILE* const nowhere = std::fopen("/dev/null", "w");
  rayshade::Diagnostics diagnostics("fuzz", nowhere);
  rayshade::CountingSink sink;
  const bool good = rayshade::ParseText({reinterpret_cast<const char*>(data), size},
                                        rayshade::Options(), &diagnostics, &sink);
  if (good != (diagnostics.exit_status() == 0)) __builtin_trap();
  return 0;
}
