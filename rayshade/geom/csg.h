// Union, intersection and difference of two members [rayshade4/2 s.9].
#pragma once

#include "rayshade/geom/member.h"

namespace rayshade {

class Csg final : public Member {
 public:
  Csg(const CompositeSpec& spec, const PlacedSpec* placed, const Member* parent,
      const ShutterInterval& shutter);
  size_t bytes() const override { return sizeof *this + first_->bytes() + second_->bytes(); }

 protected:
  bool SearchOwn(const ObjectRay& ray, double min, double max, MemberHit* hit) const override;

 private:
  bool SearchUnion(const ObjectRay& ray, double min, MemberHit* hit) const;
  bool SearchIntersection(const ObjectRay& ray, double min, MemberHit* hit) const;
  bool SearchDifference(const ObjectRay& ray, double min, MemberHit* hit) const;

  AggregateKind kind_;
  std::unique_ptr<const Member> first_, second_;
};

}  // namespace rayshade
