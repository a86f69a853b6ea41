// Where a texture lies: its own transformations, and the base of all textures, which keeps them
// [rayshade4/3 s.9.1].
#pragma once

#include "rayshade/texture/texture.h"

namespace rayshade {

// Toward zero, as a machine of Rayshade's converts: what no int can hold becomes the least int.
int Truncated(double x);
// 0 to 1; NaN becomes 0.
double Clamped(double x);

// REQUIRES: a map of 256 entries. Index: a number truncated and clamped to the map.
const Color& MapEntry(const ColorMap& map, double index);

class TextureSpace {
 public:
  explicit TextureSpace(const TransformChain& transforms);

  // T: texture space to model space. The links of an animated chain are composed the last written
  // first, those of a constant one the first written first (s.14, K12).
  Transform At(const Moment& moment) const;
  // The hit's point in texture space.
  Vector PointOf(const TextureHit& hit) const;

  size_t bytes() const;  // beyond sizeof(*this)

 private:
  bool identity_ = true;
  Transform constant_;
  TransformChain animated_;  // empty where the transformations are constant
};

// A texture with its own space.
class PlacedTexture : public Texture {
 public:
  explicit PlacedTexture(const TransformChain& transforms) : space_(transforms) {}

 protected:
  const TextureSpace& space() const { return space_; }
  Vector PointOf(const TextureHit& hit) const { return space_.PointOf(hit); }

 private:
  TextureSpace space_;
};

}  // namespace rayshade
