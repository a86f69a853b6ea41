// The search for the first hit that survives; see csg.h. Both operands are searched forwards in
// turn, each time from kEpsilon behind the other's last hit; whether a hit leads in or out decides
// what is visible there.
#include "rayshade/geom/csg.h"

#include <algorithm>
#include <cmath>

#include "rayshade/common/check.h"

namespace rayshade {
namespace {

// An operand and its present hit; kFar where there is none.
struct Operand {
  const Member* member;
  MemberHit hit;

  void Begin(const ObjectRay& ray, double min) {
    hit = {};
    MemberHit found;
    if (member->Search(ray, min, kFar, &found)) hit = found;
  }
  // The next hit behind d. Where kEpsilon is lost in rounding, the next number will do.
  bool Advance(const ObjectRay& ray, double d) {
    Begin(ray, std::max(d + kEpsilon, std::nextafter(d, INFINITY)));
    return hit.found();
  }
};

}  // namespace

Csg::Csg(const CompositeSpec& spec, const PlacedSpec* placed, const Member* parent,
         const ShutterInterval& shutter)
    : Member(placed, parent, shutter), kind_(spec.kind) {
  CHECK(spec.members->size() == 2);
  first_ = MakeMember(&(*spec.members)[0], this, shutter);
  second_ = MakeMember(&(*spec.members)[1], this, shutter);
}

// A hit before `min` can only be one that rounding (of distances brought through scaled members)
// has put there: it was reported to an earlier search, and the next one is wanted.
bool Csg::SearchOwn(const ObjectRay& ray, double min, double max, MemberHit* hit) const {
  constexpr int kTries = 8;
  double from = min;
  for (int i = 0; i < kTries; ++i) {
    MemberHit found;
    const bool any = kind_ == AggregateKind::kUnion       ? SearchUnion(ray, from, &found)
                     : kind_ == AggregateKind::kIntersect ? SearchIntersection(ray, from, &found)
                                                          : SearchDifference(ray, from, &found);
    if (!any || found.distance > max) return false;
    if (found.distance >= min) {
      *hit = found;
      return true;
    }
    from = std::nextafter(from, INFINITY) * (1 + i * 0x1.0p-52);
  }
  return false;
}

bool Csg::SearchUnion(const ObjectRay& ray, double min, MemberHit* hit) const {
  Operand one{first_.get(), {}}, two{second_.get(), {}};
  one.Begin(ray, min);
  two.Begin(ray, min);
  if (!one.hit.found() && !two.hit.found()) return false;
  if (!one.hit.found() || (two.hit.found() && one.hit.distance > two.hit.distance)) {
    std::swap(one, two);
  }
  while (true) {
    // Outside of the other operand?
    if (!two.hit.found() || two.hit.Entering()) {
      *hit = one.hit;
      hit->SetEntering(one.hit.Entering());
      return true;
    }
    // Inside of it: what comes after its far side?
    if (!one.Advance(ray, two.hit.distance)) {
      *hit = two.hit;
      hit->SetEntering(false);
      return true;
    }
    std::swap(one, two);
  }
}

bool Csg::SearchIntersection(const ObjectRay& ray, double min, MemberHit* hit) const {
  Operand one{first_.get(), {}}, two{second_.get(), {}};
  one.Begin(ray, min);
  if (!one.hit.found()) return false;
  two.Begin(ray, min);
  if (!two.hit.found()) return false;
  if (one.hit.distance > two.hit.distance) std::swap(one, two);
  while (two.hit.Entering()) {
    if (!one.Advance(ray, two.hit.distance)) return false;
    std::swap(one, two);
  }
  *hit = one.hit;
  hit->SetEntering(one.hit.Entering());
  return true;
}

bool Csg::SearchDifference(const ObjectRay& ray, double min, MemberHit* hit) const {
  Operand one{first_.get(), {}}, two{second_.get(), {}};
  one.Begin(ray, min);
  if (!one.hit.found()) return false;
  two.Begin(ray, min);
  while (true) {
    if (!two.hit.found() || one.hit.distance < two.hit.distance) {
      if (!two.hit.found() || two.hit.Entering()) {
        *hit = one.hit;
        hit->SetEntering(one.hit.Entering());
        return true;
      }
      if (!one.Advance(ray, two.hit.distance)) return false;
    } else {
      if (!one.hit.Entering()) {
        *hit = two.hit;
        hit->SetEntering(!two.hit.Entering());
        return true;
      }
      if (!two.Advance(ray, one.hit.distance)) {
        *hit = one.hit;
        hit->SetEntering(true);
        return true;
      }
    }
  }
}

}  // namespace rayshade
