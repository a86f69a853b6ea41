// The objects of a set as they are held: flat arrays for spheres, triangles and polygons that stand
// in place, a Geom each for everything else.
//
//   1. Objects are numbered: spheres first, then all others, in the order in which they were added;
//   after Settle and Permute, in the order of the hierarchy's leaves, unbounded ones last.
//   2. After Settle what is flat stands in place, and no rank occurs twice.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "rayshade/accel/build.h"
#include "rayshade/accel/flat_objects.h"
#include "rayshade/accel/growing_array.h"
#include "rayshade/accel/object_set.h"

namespace rayshade {

struct OtherObject {
  std::unique_ptr<const GeomSpec> spec;  // null for members
  std::shared_ptr<const Geom> geom;      // of a spec: since Settle
  Bounds box;                            // in the world; since Settle
  bool bounded = true;
  bool inclusive = false;
};

class StoredObjects {
 public:
  explicit StoredObjects(const Scene* scene) : scene_(scene) {}

  void Add(const GeomSpec& spec, ObjectKey key);
  void Add(std::shared_ptr<const Geom> member, uint8_t kind, ObjectKey key);
  void Resolve(const ObjectSet::Resolve& resolve);

  // Makes geoms and moves what is not in place out of the flat arrays; placements must be final.
  void Settle();
  // What the hierarchy is to be built over: refs[i].index is the number of an item.
  std::vector<BuildRef> RefsOfBounded(const double center[3]) const;
  // Items in the order of the refs; those without a ref follow. Returns how many have one.
  uint32_t Permute(std::span<const BuildRef> refs);

  size_t size() const { return spheres_.size() + items_.size(); }
  uint32_t sphere_count() const { return static_cast<uint32_t>(spheres_.size()); }
  bool is_sphere(uint32_t object) const { return object < spheres_.size(); }
  const ObjectKey& key(uint32_t object) const {
    return object < keys_.size() ? keys_[object] : item_keys_[object - spheres_.size()];
  }
  const Item& item(uint32_t object) const { return items_[object - spheres_.size()]; }
  const FlatTriangle& triangle(const Item& item) const { return triangles_[item.index]; }
  const FlatPolygon& polygon(const Item& item) const { return polygons_[item.index]; }
  const OtherObject& other(const Item& item) const { return others_[item.index]; }
  std::span<const Vector> PointsOf(const FlatPolygon& p) const {
    return {points_.data() + p.first_point, p.point_count};
  }
  SphereSpec sphere(uint32_t object) const;
  // Its x, y, z and radius, which lie *stride apart once leaves were made.
  const double* SphereRow(uint32_t object, uint32_t* stride) const;

  Bounds WorldBox(uint32_t object) const;
  Bounds BoxOfSpheres() const;  // around the world boxes of all; before Permute
  Quad QuadAround(uint32_t object, const double center[3]) const;  // of one that is no sphere
  // The parts of all polygons, as FlatObjects has them.
  void CutPolygons(const double center[3], std::vector<float>* parts);
  GeomSpec SpecOf(uint32_t object) const;  // of a flat one, or an other one with a spec

  const Scene& scene() const { return *scene_; }
  GrowingArray<SphereRecord>& spheres() { return spheres_; }
  GrowingArray<ObjectKey>& keys() { return keys_; }
  std::span<const double> growth() const { return growth_; }
  FlatObjects flat() const;            // for the kernels
  GrowingArray<uint64_t> leaf_begins;  // of spheres, from the builder; empty before
  size_t bytes() const;

 private:
  void AddOther(OtherObject&& other, uint8_t kind, ObjectKey key);
  void SettleSpheres();
  void SettleItems();
  void RemoveDuplicates();
  double RoomOf(uint32_t object) const;
  void GrowAsPlaced(PlacementId placement, Bounds* box) const;
  bool StaysFlat(PlacementId placement) const { return scene_->placement(placement).in_place; }

  const Scene* scene_;
  GrowingArray<SphereRecord> spheres_;
  GrowingArray<ObjectKey> keys_;       // of the spheres; since Permute, of all
  GrowingArray<ObjectKey> item_keys_;  // until Permute
  std::vector<Item> items_;
  std::vector<FlatTriangle> triangles_;
  std::vector<FlatPolygon> polygons_;
  std::vector<Vector> points_;
  std::vector<OtherObject> others_;
  std::vector<double> growth_;  // of a box in place, by placement: that often kEpsilon
};

}  // namespace rayshade
