// Spotlight: a point light that shines into a cone with soft borders [rayshade4/3 s.6.5]. Without
// angles it is dark, as Rayshade's is (s.14, K5).
#pragma once

#include "rayshade/light/light.h"

namespace rayshade {

class SpotLight : public Light {
 public:
  SpotLight(const LightSpec& spec, const SpotLightSpec& source);

  LightDirection Toward(const Vector& point, const LightKey& key) const override;
  std::optional<LightArrival> Arrive(const Vector& point, const LightDirection& direction,
                                     const LightKey& key) const override;

 private:
  // The fraction of the intensity that leaves towards a point seen from there in this direction.
  double Attenuation(const Vector& toward) const;

  Vector from_;
  Vector axis_;  // unit
  double exponent_;
  double cos_inner_, cos_outer_;
};

}  // namespace rayshade
