// See point.h.
#include "rayshade/light/point.h"

namespace rayshade {

LightDirection PointLight::Toward(const Vector& point, const LightKey&) const {
  return TowardPosition(position_, point);
}

std::optional<LightArrival> PointLight::Arrive(const Vector&, const LightDirection& direction,
                                               const LightKey&) const {
  return LightArrival{intensity(), direction.toward, direction.distance};
}

}  // namespace rayshade
