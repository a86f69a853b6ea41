// What a composite is made of: a tree of members, primitives at its leaves, lists, grids and CSG
// nodes above them. Members are searched by Rayshade's rules of order and ties [rayshade4/2 s.8,
// s.9]; the same objects outside of composites are expanded and never become members.
#pragma once

#include <memory>
#include <vector>

#include "rayshade/geom/geom.h"

namespace rayshade {

class Primitive;

// A hit on a leaf; distance: in the space of whoever asked, all else in the leaf's own.
struct MemberHit {
  double distance = kFar;
  const Primitive* leaf = nullptr;
  ObjectRay ray;
  double min_distance = 0, leaf_distance = 0;
  Stamp stamp = Stamp::kNone;

  bool found() const { return leaf != nullptr; }
  // The flag of an inner CSG node, else the primitive's own rule.
  bool Entering() const;
  void SetEntering(bool entering) { stamp = entering ? Stamp::kEntering : Stamp::kLeaving; }
};

class Member {
 public:
  // placed: must outlive the member; null for the root of a composite. parent: null for the root.
  Member(const PlacedSpec* placed, const Member* parent, const ShutterInterval& shutter);
  virtual ~Member() = default;
  Member(const Member&) = delete;
  Member& operator=(const Member&) = delete;

  // The nearest hit from outside of the member's transformations; fills *hit only where it returns
  // true. The ends of the window are each kind's own matter.
  bool Search(const ObjectRay& ray, double min, double max, MemberHit* hit) const;

  const Attributes* attributes() const { return placed_ ? &placed_->attributes : nullptr; }
  const Member* parent() const { return parent_; }
  bool unbounded() const { return box_.low.x > box_.high.x; }
  const Bounds& box() const { return box_; }  // outside of the transformations
  virtual size_t bytes() const = 0;

 protected:
  virtual bool SearchOwn(const ObjectRay& ray, double min, double max, MemberHit* hit) const = 0;
  // False keeps Rayshade from looking at the box first.
  virtual bool culled_by_box() const { return false; }

 private:
  const PlacedSpec* placed_;
  const Member* parent_;
  Bounds box_;
};

// A leaf.
class Primitive final : public Member {
 public:
  Primitive(const PlacedSpec* placed, const Member* parent, const ShutterInterval& shutter);
  const Geom& geom() const { return *geom_; }
  size_t bytes() const override { return sizeof *this + geom_->bytes(); }

 protected:
  bool SearchOwn(const ObjectRay& ray, double min, double max, MemberHit* hit) const override;
  bool culled_by_box() const override { return true; }

 private:
  std::unique_ptr<const Geom> geom_;
};

// The member that a spec describes, with everything below it. placed null: `root` is made.
std::unique_ptr<const Member> MakeMember(const PlacedSpec* placed, const Member* parent,
                                         const ShutterInterval& shutter);
std::unique_ptr<const Member> MakeRoot(const CompositeSpec& root, const ShutterInterval& shutter);

// Rayshade's box of an object before its transformations; "unbounded" is low x above high x, and
// takes part in CSG as it stands [rayshade4/2 s.9.2].
Bounds OwnBox(const GeomSpec& spec, const ShutterInterval& shutter);
// The same outside of its transformations.
Bounds OuterBox(const PlacedSpec& placed, const ShutterInterval& shutter);

}  // namespace rayshade
