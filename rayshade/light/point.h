// Point light: shines alike in all directions, without falloff [rayshade4/3 s.6.3].
#pragma once

#include "rayshade/light/light.h"

namespace rayshade {

// Direction and distance from a point to a position; what point, spot, extended and area lights
// share.
inline LightDirection TowardPosition(const Vector& position, const Vector& point) {
  LightDirection direction;
  direction.toward = position - point;
  direction.distance = Normalize(&direction.toward);
  return direction;
}

class PointLight : public Light {
 public:
  PointLight(const LightSpec& spec, const PointLightSpec& source)
      : Light(spec), position_(source.position) {}

  LightDirection Toward(const Vector& point, const LightKey& key) const override;
  std::optional<LightArrival> Arrive(const Vector& point, const LightDirection& direction,
                                     const LightKey& key) const override;
  const Vector* position() const override { return &position_; }

 private:
  Vector position_;
};

}  // namespace rayshade
