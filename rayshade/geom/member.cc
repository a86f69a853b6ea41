// Members in general, and leaves; see member.h.
#include "rayshade/geom/member.h"

#include <algorithm>

#include "rayshade/geom/csg.h"
#include "rayshade/geom/list.h"
#include "rayshade/geom/make_geom.h"
#include "rayshade/geom/slab.h"
#include "rayshade/geom/to_object.h"

namespace rayshade {
namespace {

constexpr Bounds kUnboundedBox{{1, kFar, kFar}, {-1, -kFar, -kFar}};

Bounds OwnBox(const CompositeSpec& spec, const ShutterInterval& shutter) {
  const std::vector<PlacedSpec>& members = *spec.members;
  if (!IsCsg(spec.kind)) {
    Bounds hull = kUnboundedBox;
    bool any = false;
    for (const PlacedSpec& member : members) {
      const Bounds box = OuterBox(member, shutter);
      if (box.low.x > box.high.x) continue;
      if (any) hull.Include(box);
      if (!any) hull = box;
      any = true;
    }
    return hull;
  }
  Bounds box = OuterBox(members[0], shutter);
  if (spec.kind == AggregateKind::kDifference) return box;
  const Bounds other = OuterBox(members[1], shutter);
  if (spec.kind == AggregateKind::kUnion) {
    box.Include(other);
    return box;
  }
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::max(box.low[axis], other.low[axis]);
    box.high[axis] = std::min(box.high[axis], other.high[axis]);
  }
  return box;
}

std::unique_ptr<const Member> MakeAggregate(const CompositeSpec& spec, const PlacedSpec* placed,
                                            const Member* parent, const ShutterInterval& shutter) {
  if (IsCsg(spec.kind)) return std::make_unique<Csg>(spec, placed, parent, shutter);
  return std::make_unique<List>(spec, placed, parent, shutter);
}

}  // namespace

bool MemberHit::Entering() const {
  if (stamp != Stamp::kNone) return stamp == Stamp::kEntering;
  return leaf->geom().Enters(ray, min_distance, leaf_distance);
}

Member::Member(const PlacedSpec* placed, const Member* parent, const ShutterInterval& shutter)
    : placed_(placed), parent_(parent) {
  if (placed != nullptr) box_ = OuterBox(*placed, shutter);
}

bool Member::Search(const ObjectRay& ray, double min, double max, MemberHit* hit) const {
  if (placed_ == nullptr) return SearchOwn(ray, min, max, hit);
  if (culled_by_box() && !unbounded() && !MeetsBox(box_, ray.origin, ray.direction, min, max)) {
    return false;
  }
  const TransformChain& transforms = placed_->attributes.transforms;
  if (transforms.empty()) return SearchOwn(ray, min, max, hit);
  ObjectRay inner = ray;
  double scale = 1;
  if (!ToObject(transforms, &inner, &scale)) return false;
  if (!SearchOwn(inner, min * scale, max * scale, hit)) return false;
  hit->distance /= scale;
  return true;
}

Primitive::Primitive(const PlacedSpec* placed, const Member* parent, const ShutterInterval& shutter)
    : Member(placed, parent, shutter), geom_(MakeGeom(placed->geom, shutter)) {}

bool Primitive::SearchOwn(const ObjectRay& ray, double min, double max, MemberHit* hit) const {
  double distance;
  if (!geom_->Intersect(ray, min, max, &distance)) return false;
  *hit = {distance, this, ray, min, distance, Stamp::kNone};
  return true;
}

std::unique_ptr<const Member> MakeMember(const PlacedSpec* placed, const Member* parent,
                                         const ShutterInterval& shutter) {
  if (const auto* composite = std::get_if<CompositeSpec>(&placed->geom)) {
    return MakeAggregate(*composite, placed, parent, shutter);
  }
  return std::make_unique<Primitive>(placed, parent, shutter);
}

std::unique_ptr<const Member> MakeRoot(const CompositeSpec& root, const ShutterInterval& shutter) {
  return MakeAggregate(root, nullptr, nullptr, shutter);
}

Bounds OwnBox(const GeomSpec& spec, const ShutterInterval& shutter) {
  if (const auto* composite = std::get_if<CompositeSpec>(&spec)) return OwnBox(*composite, shutter);
  if (std::holds_alternative<PlaneSpec>(spec)) return kUnboundedBox;
  return BoundsOf(spec, shutter);
}

Bounds OuterBox(const PlacedSpec& placed, const ShutterInterval& shutter) {
  const Bounds own = OwnBox(placed.geom, shutter);
  if (own.low.x > own.high.x) return own;
  return ChainBounds(placed.attributes.transforms, own, shutter);
}

}  // namespace rayshade
