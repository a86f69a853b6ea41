// A tree of members as one Geom; see composite.h and member.h.
#include "rayshade/geom/composite.h"

#include <algorithm>

#include "rayshade/geom/make_geom.h"
#include "rayshade/geom/member.h"
#include "rayshade/geom/to_object.h"

namespace rayshade {
namespace {

class Composite final : public Geom {
 public:
  Composite(const CompositeSpec& spec, const ShutterInterval& shutter)
      : members_(spec.members), root_(MakeRoot(spec, shutter)), reach_(ReachOf(spec, shutter)) {}

  bool bounded() const override { return reach_.has_value(); }
  bool closed() const override { return true; }
  bool inclusive() const override { return true; }
  Bounds bounds() const override { return reach_.value_or(Bounds{}); }
  size_t bytes() const override {
    return sizeof *this + members_->size() * sizeof(PlacedSpec) + root_->bytes();
  }

  bool Intersect(const ObjectRay& ray, double min, double max, double* distance) const override {
    MemberHit hit;
    if (!root_->Search(ray, min, max, &hit)) return false;
    *distance = hit.distance;
    return true;
  }

  // The search again: its hit does not depend on how far one looks.
  void Describe(const ObjectRay& ray, double min, double distance, HitPath* path) const override {
    const std::optional<MemberHit> hit = Find(ray, min, distance);
    if (!hit) return Nothing(ray, distance, path);
    hit->leaf->geom().Describe(hit->ray, hit->min_distance, hit->leaf_distance, path);
    path->stamp = hit->stamp;
    path->inner.clear();
    for (const Member* m = hit->leaf; m->attributes() != nullptr; m = m->parent()) {
      path->inner.push_back(m->attributes());
    }
  }

  bool Enters(const ObjectRay& ray, double min, double distance) const override {
    const std::optional<MemberHit> hit = Find(ray, min, distance);
    return hit && hit->Entering();
  }

 private:
  std::optional<MemberHit> Find(const ObjectRay& ray, double min, double distance) const {
    MemberHit hit;
    if (root_->Search(ray, min, std::max(distance, kFar), &hit)) return hit;
    return std::nullopt;
  }
  // A distance that no Intersect has reported: a description without a normal, but no crash.
  void Nothing(const ObjectRay& ray, double distance, HitPath* path) const {
    *path = {};
    path->primitive = this;
    path->ray = ray;
    path->distance = distance;
    path->point = ray.origin + distance * ray.direction;
    path->normal = path->geometric_normal = -ray.direction;
  }

  std::shared_ptr<const std::vector<PlacedSpec>> members_;  // the tree points into it
  std::unique_ptr<const Member> root_;
  std::optional<Bounds> reach_;
};

std::optional<Bounds> ReachOf(const PlacedSpec& placed, const ShutterInterval& shutter) {
  std::optional<Bounds> own;
  if (const auto* composite = std::get_if<CompositeSpec>(&placed.geom)) {
    own = ReachOf(*composite, shutter);
  } else if (IsBounded(placed.geom)) {
    own = BoundsOf(placed.geom, shutter);
  }
  if (!own) return own;
  return ChainBounds(placed.attributes.transforms, *own, shutter);
}

// What lies in both, never less than a point.
Bounds Common(const Bounds& a, const Bounds& b) {
  Bounds both;
  for (int axis = 0; axis < 3; ++axis) {
    both.low[axis] = std::max(a.low[axis], b.low[axis]);
    both.high[axis] = std::max(both.low[axis], std::min(a.high[axis], b.high[axis]));
  }
  return both;
}

}  // namespace

std::optional<Bounds> ReachOf(const CompositeSpec& spec, const ShutterInterval& shutter) {
  const std::vector<PlacedSpec>& members = *spec.members;
  if (spec.kind == AggregateKind::kDifference) return ReachOf(members[0], shutter);
  if (spec.kind == AggregateKind::kIntersect) {
    const auto a = ReachOf(members[0], shutter), b = ReachOf(members[1], shutter);
    return a && b ? Common(*a, *b) : a ? a : b;
  }
  Bounds hull;
  for (const PlacedSpec& member : members) {
    const auto reach = ReachOf(member, shutter);
    if (!reach) return std::nullopt;
    hull.Include(*reach);
  }
  return hull;
}

std::optional<Complaint> Check(const CompositeSpec& spec) {
  const size_t count = spec.members == nullptr ? 0 : spec.members->size();
  if (IsCsg(spec.kind)) {
    if (count < 2) return Refuse("CSG needs at least two objects.");
    if (count > 2) return Refuse("Currently, CSG only handles two objects.");
  }
  if (count == 0) return Refuse("Null object defined.");
  for (const PlacedSpec& member : *spec.members) {
    if (auto complaint = CheckGeom(member.geom); complaint && complaint->dropped) return complaint;
  }
  return std::nullopt;
}

std::unique_ptr<const Geom> MakeComposite(const CompositeSpec& spec,
                                          const ShutterInterval& shutter) {
  return std::make_unique<Composite>(spec, shutter);
}

}  // namespace rayshade
