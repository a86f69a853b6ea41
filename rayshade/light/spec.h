// Light sources as the scene language writes them [rayshade4/3 s.6]; ambient light is a setting,
// not a source.
#pragma once

#include <variant>

#include "rayshade/common/color.h"
#include "rayshade/common/vector.h"

namespace rayshade {

struct PointLightSpec {
  Vector position;
};
struct DirectionalLightSpec {
  Vector direction;
};  // towards the light
struct SpotLightSpec {
  Vector from, at;
  double exponent = 0, inner = 0, outer = 0;
};  // degrees
struct ExtendedLightSpec {
  double radius = 0;
  Vector position;
};
// One cell of an area light: corner and the two edge vectors.
struct AreaCellSpec {
  Vector corner, u, v;
  uint32_t area = 0;  // its area light's number in the scene
  uint32_t order = 0,
           cells = 1;  // its place among that light's cells: near in order, near in space
};

struct LightSpec {
  Color intensity;
  bool noshadow = false;
  std::variant<PointLightSpec, DirectionalLightSpec, SpotLightSpec, ExtendedLightSpec, AreaCellSpec>
      source;
};

}  // namespace rayshade
