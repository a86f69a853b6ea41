// Lists and grids inside composites; see list.h. Unbounded members come first, always; the others
// only for rays that meet their hull. A list looks at what was written last first, a grid at what
// was written first.
#include "rayshade/geom/list.h"

#include <algorithm>

#include "rayshade/geom/slab.h"

namespace rayshade {

List::List(const CompositeSpec& spec, const PlacedSpec* placed, const Member* parent,
           const ShutterInterval& shutter)
    : Member(placed, parent, shutter) {
  for (const PlacedSpec& member : *spec.members) {
    auto made = MakeMember(&member, this, shutter);
    if (made->unbounded()) {
      unbounded_.push_back(std::move(made));
    } else {
      hull_.Include(made->box());
      bounded_.push_back(std::move(made));
    }
  }
  if (spec.kind == AggregateKind::kList) std::reverse(bounded_.begin(), bounded_.end());
}

bool List::SearchOwn(const ObjectRay& ray, double min, double max, MemberHit* hit) const {
  bool found = false;
  const auto search = [&](const std::vector<std::unique_ptr<const Member>>& members) {
    for (const auto& member : members) {
      if (!member->Search(ray, min, max, hit)) continue;
      max = hit->distance;
      found = true;
    }
  };
  search(unbounded_);
  if (!bounded_.empty() && MeetsBox(hull_, ray.origin, ray.direction, min, max)) search(bounded_);
  return found;
}

size_t List::bytes() const {
  size_t sum = sizeof *this;
  for (const auto& member : unbounded_) sum += sizeof member + member->bytes();
  for (const auto& member : bounded_) sum += sizeof member + member->bytes();
  return sum;
}

}  // namespace rayshade
