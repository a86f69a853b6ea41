// Fog, mist and fog deck [rayshade4/3 s.8]; see atmosphere.h.
#include "rayshade/surface/atmosphere.h"

#include <algorithm>
#include <cmath>

#include "rayshade/common/constants.h"
#include "rayshade/texture/noise.h"

namespace rayshade {
namespace {

constexpr double kLnHalf = -0.69314718;  // eight digits, as in Rayshade [rayshade4/3 s.1]

// The fraction of light left after `distance`, where half of it is left after `half_distance`.
double Left(double distance, double half_distance) {
  if (half_distance < kEpsilon) return 0;
  const double power = kLnHalf * distance / half_distance;
  return power >= -10.0 ? std::exp(power) : 0;  // NaN: nothing is left
}

Color Mix(const Color& color, const Color& fog, const Color& half_distance, double distance) {
  Color mixed;
  for (int c = 0; c < 3; ++c) {
    const double left = Left(distance, half_distance[c]);
    mixed[c] = left * color[c] + (1.0 - left) * fog[c];
  }
  return mixed;
}

struct Way {
  const Vector& origin;
  const Vector& direction;
  double distance;
  const Color& color;

  Color operator()(const Fog& fog) const {
    return Mix(color, fog.color, fog.half_distance, distance);
  }

  // Thickness falls exponentially with height: the mean over the way stands for the whole.
  Color operator()(const Mist& mist) const {
    const double s = 1.0 / mist.scale;
    const double z0 = origin.z, z1 = origin.z + distance * direction.z;
    const double rise = s * (z1 - z0);
    const double at_end = std::exp(-z1 * s + mist.zero);
    const double mean =
        std::abs(rise) > kEpsilon ? (std::exp(-z0 * s + mist.zero) - at_end) / rise : at_end;
    return Mix(color, mist.color, mist.half_distance, distance * mean);
  }

  // Fog behind the plane z = altitude. Rayshade's guard against level rays takes the absolute value
  // of an integer, so that only rays exactly along z see the deck (s.14, K7: kept).
  Color operator()(const FogDeck& deck) const {
    if (std::trunc(std::abs(direction.z)) < kEpsilon) return color;
    const double t = (deck.altitude - origin.z) / direction.z;
    if (!(t >= kEpsilon && t <= distance)) return color;
    const Vector crossing = origin + t * direction;
    const Vector e{crossing.x * deck.scale.x, crossing.y * deck.scale.y, crossing.z * deck.scale.z};
    const double density = deck.offset + deck.chaos_scale * PAChaos(e, deck.octaves);
    if (!(density >= kEpsilon)) return color;
    const Color& h = deck.half_distance;
    return Mix(color, deck.color, {h.r / density, h.g / density, h.b / density}, distance - t);
  }
};

}  // namespace

bool Atmosphere::Hides(double distance) const {
  return std::any_of(effects.begin(), effects.end(), [distance](const Effect& effect) {
    const Fog* fog = std::get_if<Fog>(&effect);
    if (fog == nullptr) return false;
    const Color& half = fog->half_distance;
    return Left(distance, half.r) == 0 && Left(distance, half.g) == 0 &&
           Left(distance, half.b) == 0;
  });
}

Color Atmosphere::Apply(const Vector& origin, const Vector& direction, double distance,
                        Color color) const {
  for (auto effect = effects.rbegin(); effect != effects.rend(); ++effect) {
    color = std::visit(Way{origin, direction, distance, color}, *effect);
  }
  return color;
}

}  // namespace rayshade
