// Directional light: infinitely far away [rayshade4/3 s.6.4].
#pragma once

#include "rayshade/light/light.h"

namespace rayshade {

class DirectionalLight : public Light {
 public:
  DirectionalLight(const LightSpec& spec, const DirectionalLightSpec& source)
      : Light(spec), toward_(Normalized(source.direction)) {}

  LightDirection Toward(const Vector& point, const LightKey& key) const override;
  std::optional<LightArrival> Arrive(const Vector& point, const LightDirection& direction,
                                     const LightKey& key) const override;

 private:
  Vector toward_;
};

}  // namespace rayshade
