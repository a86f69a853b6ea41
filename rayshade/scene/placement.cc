// Rays into object space, boxes into the world; see placement.h.
#include "rayshade/scene/placement.h"

#include <variant>

#include "rayshade/geom/unit.h"

namespace rayshade {
namespace {

// Does the ray meet the closed box within the window? Rayshade's test of an aggregate's box
// [rayshade4/2 s.2.3, 2.4]: a start inside of it is a yes.
bool Meets(const Bounds& box, const ObjectRay& ray, double min_distance, double max_distance) {
  if (box.Contains(ray.origin + min_distance * ray.direction)) return true;
  double near = min_distance, far = max_distance;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < box.low[axis] || o > box.high[axis]) return false;
      continue;
    }
    const double leave = ((d > 0 ? box.high[axis] : box.low[axis]) - o) / d;
    const double enter = ((d > 0 ? box.low[axis] : box.high[axis]) - o) / d;
    if (leave < near) return false;
    if (leave <= far) far = leave;
    if (enter >= near) {
      if (enter > far) return false;
      near = enter;
    }
  }
  return (near == min_distance ? far : near) < max_distance;
}

// Brings *ray through one link, backwards; false where its direction vanishes. Rayshade loses
// objects that are enlarged by more than 1e5 here [rayshade4/2 s.3.6].
bool IntoLink(const Transform& link, ObjectRay* ray, double* scale) {
  ray->origin = link.InversePoint(ray->origin);
  ray->direction = link.InverseDirection(ray->direction);
  const double length = NormalizeAny(&ray->direction);
  *scale *= length;
  return length != 0;
}

bool IntoChain(const TransformChain& chain, ObjectRay* ray, double* scale) {
  for (size_t i = chain.size(); i-- > 0;) {
    const auto* constant = std::get_if<Transform>(&chain.links()[i]);
    if (!(constant != nullptr ? IntoLink(*constant, ray, scale)
                              : IntoLink(chain.At(i, ray->moment), ray, scale))) {
      return false;
    }
  }
  return true;
}

Bounds ChainBox(const TransformChain& chain, Bounds box, const Moment& moment) {
  for (size_t i = 0; i < chain.size(); ++i) box = chain.At(i, moment).Box(box);
  return box;
}

}  // namespace

void Placement::Finish() {
  plain = true;
  in_place = true;
  surface = kNoSurface;
  for (const PathLevel& level : levels) {
    if (!level.attributes.plain() || level.clip) plain = false;
    if (!level.attributes.transforms.empty() || level.clip) in_place = false;
    if (surface == kNoSurface) surface = level.attributes.surface;
  }
}

bool ToObject(const Placement& placement, const ObjectRay& world, double min_distance,
              double max_distance, ObjectRay* object, double* scale) {
  *object = world;
  *scale = 1;
  for (size_t i = placement.levels.size(); i-- > 0;) {
    const PathLevel& level = placement.levels[i];
    if (level.clip && !Meets(*level.clip, *object, min_distance * *scale, max_distance * *scale)) {
      return false;
    }
    if (!IntoChain(level.attributes.transforms, object, scale)) return false;
  }
  return true;
}

Bounds OuterBounds(const Attributes& attributes, const Bounds& own,
                   const ShutterInterval& shutter) {
  const TransformChain& chain = attributes.transforms;
  Bounds box = own;
  box.Grow(kEpsilon);
  if (chain.size() == 0) {
    // Millions of objects have none.
  } else if (chain.animated() && shutter.close > shutter.open) {
    Bounds swept;
    for (int i = 0; i <= kBoundsMoments; ++i) {
      const double part = static_cast<double>(i) / kBoundsMoments;
      const double time = i == kBoundsMoments
                              ? shutter.close
                              : shutter.open + part * (shutter.close - shutter.open);
      swept.Include(ChainBox(chain, box, {shutter.frame, time}));
    }
    box = swept;
  } else {
    box = ChainBox(chain, box, {shutter.frame, shutter.open});
  }
  box.Grow(kEpsilon);
  return box;
}

Bounds WorldBounds(const Placement& placement, const Bounds& own, const ShutterInterval& shutter) {
  Bounds box = own;
  for (const PathLevel& level : placement.levels) {
    box = OuterBounds(level.attributes, box, shutter);
  }
  return box;
}

}  // namespace rayshade
