// Random primitives with coordinates over 16 decades.
#pragma once

#include <random>
#include <string>

#include "rayshade/geom/spec.h"

namespace rayshade::stability {

using Random = std::mt19937_64;

inline constexpr const char* kKinds[] = {
    "sphere",  "box",      "plane", "disc",  "triangle", "Phong triangle",
    "polygon", "cylinder", "cone",  "torus", "blob",     "heightfield"};

struct RandomObject {
  PlacedSpec placed;
  Vector center;     // in the object's own space
  double reach = 1;  // radius of a ball around it, in its own space
};

double Uniform(Random* random, double low, double high);
Vector RandomDirection(Random* random);

// One that the language takes: sizes and coordinates of any magnitude from 1e-8 to 1e8 (sizes as
// small as that are refused for most kinds), every other one placed by scaling, rotation and
// translation.
RandomObject MakeRandomObject(const std::string& kind, Random* random);

}  // namespace rayshade::stability
