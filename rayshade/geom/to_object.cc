// Through chains of transformations; see to_object.h.
#include "rayshade/geom/to_object.h"

#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

constexpr int kMomentsOfBounds = 64;  // within the shutter interval

bool ThroughLink(const Transform& link, ObjectRay* ray, double* scale) {
  ray->origin = link.InversePoint(ray->origin);
  ray->direction = link.InverseDirection(ray->direction);
  const double length = NormalizeAny(&ray->direction);
  *scale *= length;
  return length > 0;
}

Bounds BoundsAt(const TransformChain& chain, Bounds box, const Moment& moment) {
  for (size_t i = 0; i < chain.size(); ++i) box = chain.At(i, moment).Box(box);
  return box;
}

}  // namespace

bool ToObject(const TransformChain& chain, ObjectRay* ray, double* scale) {
  for (size_t i = chain.size(); i-- > 0;) {
    const Transform* constant = std::get_if<Transform>(&chain.links()[i]);
    const bool visible = constant != nullptr ? ThroughLink(*constant, ray, scale)
                                             : ThroughLink(chain.At(i, ray->moment), ray, scale);
    if (!visible) return false;
  }
  return true;
}

Bounds ChainBounds(const TransformChain& chain, const Bounds& own, const ShutterInterval& shutter) {
  Bounds grown = own;
  grown.Grow(kEpsilon);
  Bounds box = BoundsAt(chain, grown, {shutter.frame, shutter.open});
  if (chain.animated() && shutter.close > shutter.open) {
    for (int i = 1; i <= kMomentsOfBounds; ++i) {
      const double part = static_cast<double>(i) / kMomentsOfBounds;
      const double time = i == kMomentsOfBounds
                              ? shutter.close
                              : shutter.open + part * (shutter.close - shutter.open);
      box.Include(BoundsAt(chain, grown, {shutter.frame, time}));
    }
  }
  box.Grow(kEpsilon);
  return box;
}

}  // namespace rayshade
