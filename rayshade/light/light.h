// A light says in which direction it is seen from a point and which shadow ray it wants; it never
// traces one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "rayshade/light/spec.h"

namespace rayshade {

// Where the light stands as seen from the point that is lit, for the cosine and the highlight.
struct LightDirection {
  Vector toward;        // L, unit
  double distance = 0;  // kFar for directional lights
};

// The shadow ray that decides whether the light arrives, and how much arrives when nothing is in
// its way.
struct LightArrival {
  Color color;              // intensity, after the spot's cone
  Vector shadow_direction;  // unit
  double shadow_distance = 0;
};

// What the random numbers of a light are a function of.
struct LightKey {
  uint64_t key = 0;    // of the ray being shaded
  uint32_t light = 0;  // place in the scene's list of lights
  uint32_t sample_number = 0;
  int samples = 1;     // N, the sample setting
  int area_cells = 0;  // of an area light, that one sample asks; 0: all
};

class Light {
 public:
  explicit Light(const LightSpec& spec) : intensity_(spec.intensity), noshadow_(spec.noshadow) {}
  virtual ~Light() = default;

  virtual LightDirection Toward(const Vector& point, const LightKey& key) const = 0;
  // Nothing where the light does not reach the point at all (outside a spot's cone). direction:
  // what Toward gave.
  virtual std::optional<LightArrival> Arrive(const Vector& point, const LightDirection& direction,
                                             const LightKey& key) const = 0;
  // How many lights this one stands for in the sample: 0 where another one stands for it. REQUIRES:
  // key.area_cells > 0.
  virtual double Share(const LightKey&) const { return 1; }

  // Where a light stands that shines from one point and alike in all directions: Arrive then gives
  // the intensity and what Toward gave. Null for all others.
  virtual const Vector* position() const { return nullptr; }

  const Color& intensity() const { return intensity_; }
  bool noshadow() const { return noshadow_; }

 private:
  Color intensity_;
  bool noshadow_;
};

std::unique_ptr<const Light> MakeLight(const LightSpec& spec);

}  // namespace rayshade
