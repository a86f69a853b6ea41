// Lists and grids as members of composites [rayshade4/2 s.8.2, s.8.3]. A grid is searched as a
// list: it differs in its order of ties only.
#pragma once

#include "rayshade/geom/member.h"

namespace rayshade {

class List final : public Member {
 public:
  List(const CompositeSpec& spec, const PlacedSpec* placed, const Member* parent,
       const ShutterInterval& shutter);
  size_t bytes() const override;

 protected:
  bool SearchOwn(const ObjectRay& ray, double min, double max, MemberHit* hit) const override;

 private:
  std::vector<std::unique_ptr<const Member>> unbounded_;  // in written order
  std::vector<std::unique_ptr<const Member>> bounded_;    // in the order of search
  Bounds hull_;                                           // of the bounded members
};

}  // namespace rayshade
