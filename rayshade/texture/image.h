// Image: the pixels of a picture change the surface or tilt the normal [rayshade4/3 s.11.3].
#pragma once

#include "rayshade/texture/mapping.h"
#include "rayshade/texture/texture_space.h"

namespace rayshade {

class ImageTexture : public PlacedTexture {
 public:
  // surface: of textsurf; null: none. REQUIRES: the image has as many bytes as its sizes say, and
  // at least one pixel.
  ImageTexture(const ImageSpec& spec, const Surface* surface, const TransformChain& transforms);

  void Apply(TextureHit* hit) const override;
  size_t bytes() const override;

 private:
  // A place within the image: pixel, and fractions within it.
  struct Place {
    int x, y;
    double fx, fy;
  };
  bool Outside(double u, double v) const;
  Place PlaceOf(double u, double v) const;
  Color Look(const Place& place) const;
  double LookAlpha(const Place& place) const;
  // Value(x, y) of the pixel or, smoothed, of four pixels.
  template <typename Value>
  auto Interpolate(const Place& place, const Value& value) const;

  double Ranged(double v) const {
    return spec_.range_low + v * (spec_.range_high - spec_.range_low);
  }
  Color Ranged(const Color& c) const { return {Ranged(c.r), Ranged(c.g), Ranged(c.b)}; }
  Vector Bumped(const Vector& normal, const MappedPoint& at, const Place& place) const;
  void ApplyColor(const Color& pixel, Surface* surface) const;

  ImageSpec spec_;
  const ImageData& image_;
  Mapping mapping_;
  bool has_surface_;
  Surface surface_;
};

}  // namespace rayshade
