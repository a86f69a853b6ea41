// See spot.h.
#include "rayshade/light/spot.h"

#include <cmath>

#include "rayshade/light/point.h"

namespace rayshade {
namespace {

// 0 below low, 1 above high, a cubic between them.
double Ramp(double low, double high, double x) {
  if (x < low) return 0;
  if (x > high) return 1;
  if (high == low) return 0;
  const double t = (x - low) / (high - low);
  return t * t * (3.0 - 2.0 * t);
}

double CosOfDegrees(double degrees) { return std::cos(degrees * kPi / 180.0); }

}  // namespace

SpotLight::SpotLight(const LightSpec& spec, const SpotLightSpec& source)
    : Light(spec),
      from_(source.from),
      axis_(Normalized(source.at - source.from)),
      exponent_(source.exponent),
      cos_inner_(CosOfDegrees(source.inner)),
      cos_outer_(CosOfDegrees(source.outer)) {}

LightDirection SpotLight::Toward(const Vector& point, const LightKey&) const {
  return TowardPosition(from_, point);
}

double SpotLight::Attenuation(const Vector& toward) const {
  const double cosine = -Dot(toward, axis_);
  if (!(cosine > 0)) return 0;
  double attenuation = std::pow(cosine, exponent_);
  if (cos_inner_ > 0) attenuation *= Ramp(cos_outer_, cos_inner_, cosine);
  return attenuation;
}

std::optional<LightArrival> SpotLight::Arrive(const Vector&, const LightDirection& direction,
                                              const LightKey&) const {
  const double attenuation = Attenuation(direction.toward);
  if (attenuation == 0) return std::nullopt;
  return LightArrival{attenuation * intensity(), direction.toward, direction.distance};
}

}  // namespace rayshade
