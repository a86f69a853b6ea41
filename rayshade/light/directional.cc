// See directional.h.
#include "rayshade/light/directional.h"

namespace rayshade {

LightDirection DirectionalLight::Toward(const Vector&, const LightKey&) const {
  return {toward_, kFar};
}

std::optional<LightArrival> DirectionalLight::Arrive(const Vector&, const LightDirection& direction,
                                                     const LightKey&) const {
  return LightArrival{intensity(), direction.toward, direction.distance};
}

}  // namespace rayshade
