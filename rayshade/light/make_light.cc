// From what the language wrote to what shines; see light.h.
#include "rayshade/light/area_cell.h"
#include "rayshade/light/directional.h"
#include "rayshade/light/extended.h"
#include "rayshade/light/light.h"
#include "rayshade/light/point.h"
#include "rayshade/light/spot.h"

namespace rayshade {
namespace {

struct Maker {
  const LightSpec& spec;

  std::unique_ptr<const Light> operator()(const PointLightSpec& source) const {
    return std::make_unique<PointLight>(spec, source);
  }
  std::unique_ptr<const Light> operator()(const DirectionalLightSpec& source) const {
    return std::make_unique<DirectionalLight>(spec, source);
  }
  std::unique_ptr<const Light> operator()(const SpotLightSpec& source) const {
    return std::make_unique<SpotLight>(spec, source);
  }
  std::unique_ptr<const Light> operator()(const ExtendedLightSpec& source) const {
    return std::make_unique<ExtendedLight>(spec, source);
  }
  std::unique_ptr<const Light> operator()(const AreaCellSpec& source) const {
    return std::make_unique<AreaCellLight>(spec, source);
  }
};

}  // namespace

std::unique_ptr<const Light> MakeLight(const LightSpec& spec) {
  return std::visit(Maker{spec}, spec.source);
}

}  // namespace rayshade
