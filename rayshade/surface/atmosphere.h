// What the air does to the colour of a ray [rayshade4/3 s.8].
#pragma once

#include <variant>
#include <vector>

#include "rayshade/common/color.h"
#include "rayshade/common/vector.h"

namespace rayshade {

struct Fog {
  Color color;
  Color half_distance;
};
struct Mist {
  Color color;
  Color half_distance;
  double zero = 0, scale = 1;
};
struct FogDeck {
  double altitude = 0, offset = 0;
  Vector scale{1, 1, 1};
  double chaos_scale = 0;
  int octaves = 0;
  Color color, half_distance;
};

using Effect = std::variant<Fog, Mist, FogDeck>;

struct Atmosphere {
  double index = 1;             // of the outermost medium
  std::vector<Effect> effects;  // as written; the last one is applied first

  // The colour of a ray after `distance` through this air; the ray is in world space.
  Color Apply(const Vector& origin, const Vector& direction, double distance, Color color) const;
  // Whether fog leaves nothing of any colour after `distance`, in every channel.
  bool Hides(double distance) const;
};

}  // namespace rayshade
