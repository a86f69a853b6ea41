// See image.h.
#include "rayshade/texture/image.h"

#include <algorithm>
#include <cmath>

#include "rayshade/common/check.h"

namespace rayshade {

ImageTexture::ImageTexture(const ImageSpec& spec, const Surface* surface,
                           const TransformChain& transforms)
    : PlacedTexture(transforms),
      spec_(spec),
      image_(*spec.image),
      mapping_(spec.mapping),
      has_surface_(surface != nullptr),
      surface_(surface ? *surface : Surface{}) {
  CHECK(image_.width > 0 && image_.height > 0);
  CHECK(image_.channels == 1 || image_.channels == 3);
  const size_t pixels = static_cast<size_t>(image_.width) * static_cast<size_t>(image_.height);
  CHECK(image_.color.size() == pixels * static_cast<size_t>(image_.channels));
  CHECK(image_.alpha.empty() || image_.alpha.size() == pixels);
}

// The rules are tried in this order; the first that fits decides.
bool ImageTexture::Outside(double u, double v) const {
  constexpr double kNone = 0.001;
  const double tu = spec_.tile_u, tv = spec_.tile_v;
  if (std::abs(tu) < kNone && std::abs(tv) < kNone) return false;
  if (tu < -kNone && tv < -kNone && (u > -tu || u < 0 || v > -tv || v < 0)) return false;
  if (tu > kNone && (u > tu || u < 0)) return true;
  if (tv > kNone && (v > tv || v < 0)) return true;
  if (tu < -kNone && u > 0 && u < -tu) return true;
  if (tv < -kNone && v > 0 && v < -tv) return true;
  return false;
}

ImageTexture::Place ImageTexture::PlaceOf(double u, double v) const {
  const double x = (u - std::floor(u)) * image_.width;
  const double y = (v - std::floor(v)) * image_.height;
  Place place;
  place.x = std::clamp(Truncated(x), 0, image_.width - 1);
  place.y = std::clamp(Truncated(y), 0, image_.height - 1);
  place.fx = Clamped(x - place.x);
  place.fy = Clamped(y - place.y);
  return place;
}

template <typename Value>
auto ImageTexture::Interpolate(const Place& at, const Value& value) const {
  if (!spec_.smooth) return value(at.x, at.y);
  const int x1 = (at.x + 1) % image_.width, y1 = (at.y + 1) % image_.height;
  return value(at.x, at.y) * ((1.0 - at.fx) * (1.0 - at.fy)) +
         value(x1, at.y) * (at.fx * (1.0 - at.fy)) + value(at.x, y1) * ((1.0 - at.fx) * at.fy) +
         value(x1, y1) * (at.fx * at.fy);
}

Color ImageTexture::Look(const Place& place) const {
  return Interpolate(place, [this](int x, int y) {
    const size_t pixel =
        static_cast<size_t>(y) * static_cast<size_t>(image_.width) + static_cast<size_t>(x);
    const uint8_t* bytes = &image_.color[pixel * static_cast<size_t>(image_.channels)];
    const int step = image_.channels == 1 ? 0 : 1;
    return Color{bytes[0] / 255.0, bytes[step] / 255.0, bytes[2 * step] / 255.0};
  });
}

double ImageTexture::LookAlpha(const Place& place) const {
  if (image_.alpha.empty()) return 1;
  return Interpolate(place, [this](int x, int y) {
    return image_.alpha[static_cast<size_t>(y) * static_cast<size_t>(image_.width) +
                        static_cast<size_t>(x)] /
           255.0;
  });
}

Vector ImageTexture::Bumped(const Vector& normal, const MappedPoint& at, const Place& place) const {
  Place right = place, above = place;
  right.x = (place.x + 1) % image_.width;
  above.y = (place.y + 1) % image_.height;
  const double here = Look(place).r;
  // The low end of the range is added to the slopes, as in Rayshade (s.14, K16).
  return Tilted(normal, at, Ranged(Look(right).r - here), Ranged(Look(above).r - here));
}

void ImageTexture::ApplyColor(const Color& pixel, Surface* s) const {
  switch (spec_.component) {
    case ImageComponent::kAll:  // the range is not used (K16)
      s->specular = pixel * s->specular;
      s->diffuse = pixel * s->diffuse;
      s->ambient = pixel * s->ambient;
      return;
    case ImageComponent::kAmbient:
      s->ambient = Ranged(pixel) * s->ambient;
      return;
    case ImageComponent::kDiffuse:
      s->diffuse = Ranged(pixel) * s->diffuse;
      return;
    case ImageComponent::kSpecular:
      s->specular = Ranged(pixel) * s->specular;
      return;
    case ImageComponent::kBody:
      s->body = Ranged(pixel) * s->body;
      return;
    case ImageComponent::kReflect:
      s->reflect *= Ranged(pixel.r);
      return;
    case ImageComponent::kTransp:
      s->transp *= Ranged(pixel.r);
      return;
    case ImageComponent::kSpecpow:
      s->specpow *= Ranged(pixel.r);
      return;
    case ImageComponent::kIndex:
      s->index *= Ranged(pixel.r);
      return;
    case ImageComponent::kBump:
      return;  // Bumped
  }
}

void ImageTexture::Apply(TextureHit* hit) const {
  const bool bump = spec_.component == ImageComponent::kBump;
  const MappedPoint at = mapping_.Map(*hit, space(), bump);
  if (Outside(at.u, at.v)) return;
  const Place place = PlaceOf(at.u, at.v);
  const double alpha = LookAlpha(place);
  if (alpha < 0.001) return;
  if (bump) {
    hit->normal = Bumped(hit->normal, at, place);
    return;
  }
  const bool replaces = has_surface_ && spec_.component == ImageComponent::kAll;
  Surface base = replaces ? surface_ : hit->surface;
  ApplyColor(Look(place), &base);
  hit->surface = alpha < 0.999 ? Blend(hit->surface, base, 1.0 - alpha, alpha) : base;
}

size_t ImageTexture::bytes() const {
  return sizeof(*this) + space().bytes() + sizeof(image_) + image_.color.size() +
         image_.alpha.size();
}

}  // namespace rayshade
