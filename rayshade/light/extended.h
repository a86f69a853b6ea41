// Extended light: lights like a point at its centre, but its shadow ray goes to a random place on a
// square that faces the point lit [rayshade4/3 s.6.7].
#pragma once

#include "rayshade/light/light.h"

namespace rayshade {

class ExtendedLight : public Light {
 public:
  ExtendedLight(const LightSpec& spec, const ExtendedLightSpec& source)
      : Light(spec), radius_(source.radius), center_(source.position) {}

  LightDirection Toward(const Vector& point, const LightKey& key) const override;
  std::optional<LightArrival> Arrive(const Vector& point, const LightDirection& direction,
                                     const LightKey& key) const override;

 private:
  double radius_;  // half the side of the square
  Vector center_;
};

}  // namespace rayshade
