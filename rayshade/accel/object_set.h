// Placed objects and one hierarchy over them: what a process can trace rays against. The sequential
// tracer has one set with everything; a trace process has one for its own and resident objects and
// one for each cached cell.
//
//   1. Flat arrays per kind (spheres, triangles, polygons that stand in place) are tested without a
//   virtual call; all
//      other objects go through Geom and their placement.
//   2. Boxes are rounded outwards: no hit is lost to the hierarchy. Answers do not depend on the
//   order in which objects
//      were added, nor on which other objects the set holds: the nearest hit is the one with least
//      (distance, rank).
//   3. After Build nothing changes.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "rayshade/accel/trace_view.h"
#include "rayshade/common/op_counts.h"
#include "rayshade/common/ray.h"
#include "rayshade/geom/geom.h"
#include "rayshade/geom/spec.h"
#include "rayshade/scene/scene.h"

namespace rayshade {

// Decides between hits at equal distances, and names a placed object in all processes alike
// (scene/rank.h).
using Rank = uint32_t;
inline constexpr Rank kNoRank = ~Rank{0};

class ObjectSet;

struct Hit {
  double distance = kFar;  // along the ray, world space; kFar where nothing was hit
  Rank rank = kNoRank;
  uint32_t object = 0;             // in *set
  const ObjectSet* set = nullptr;  // of this process; null: known by rank only, or nothing hit

  bool found() const { return rank != kNoRank; }
  bool nearer_than(const Hit& o) const {
    return distance < o.distance || (distance == o.distance && rank < o.rank);
  }
};

class ObjectSet {
 public:
  // scene: for placements and the shutter interval; must outlive the set.
  explicit ObjectSet(const Scene* scene);
  ~ObjectSet();
  ObjectSet(ObjectSet&&) noexcept;
  ObjectSet& operator=(ObjectSet&&) noexcept;

  // Adds an object; ranks must be unique within the set. Returns false (and adds nothing) where
  // this rank is in the set already, if checked (Build removes duplicates otherwise).
  void Add(const GeomSpec& spec, PlacementId placement, Rank rank);
  // The same for a member of a definition, which several placed objects share; kind:
  // GeomSpec::index().
  void Add(std::shared_ptr<const Geom> member, size_t kind, PlacementId placement, Rank rank);
  // Rewrites placement and rank of every object added so far, before Build: both may be known only
  // at the end of the file. Objects whose new placement is not in place move out of the flat
  // arrays.
  using Resolve = std::function<std::pair<PlacementId, Rank>(PlacementId, Rank)>;
  void ResolveAll(const Resolve& resolve);
  void Build();

  // Improves hits[i]: the nearest hit of rays[i] in [rays[i].min_distance, hits[i].distance] that
  // is nearer_than hits[i]. Rays: any number; coherent ones are traced together.
  void Nearest(std::span<const Ray> rays, std::span<Hit> hits, OpCounts* counts) const;

  // The same for one ray and one object of the set, whatever else is in the way.
  void NearestOf(const Ray& ray, uint32_t object, Hit* hit) const;

  // blocked[i] becomes 1 where something opaque (bound surface with transp < kEpsilon) lies on
  // rays[i] within [min_distance, limits[i]] (each kind's own rule at the ends). Entries that are 1
  // already are skipped.
  // crossed, where it is not empty: crossed[i] becomes 1 where a ray that is not blocked may meet
  // something that is not opaque; it stays as it is where nothing at all is in the way.
  void Block(std::span<const Ray> rays, std::span<const double> limits, std::span<uint8_t> blocked,
             std::span<uint8_t> crossed, OpCounts* counts) const;
  void Block(std::span<const Ray> rays, std::span<const double> limits, std::span<uint8_t> blocked,
             OpCounts* counts) const {
    Block(rays, limits, blocked, {}, counts);
  }

  // The same for rays that all end at one position, in rows (trace_view.h).
  void Block(const ShadowRows& rows, OpCounts* counts) const;
  // Where a position stands as seen from points, with this set's kernels.
  void Aim(const AimRows& rows) const;
  // Before and after the shadow rays of a light.
  void Sort(const SortRows& rows) const;
  void AddDiffuse(const DiffuseRows& rows) const;
  void Shine(const ShineRows& rows) const;

  // The hit described in the space of its primitive; hit.set == this.
  void Describe(const Ray& ray, const Hit& hit, HitPath* path) const;
  // A sphere that stands in place, without textures: all that there is to say about hits on it.
  struct PlainSphere {
    const double* center;  // x, y and z lie `stride` apart, then the radius
    uint32_t stride;
    SurfaceId surface;
  };
  bool IsPlainSphere(uint32_t object, PlainSphere* plain) const;
  PlacementId placement_of(uint32_t object) const;
  Rank rank_of(uint32_t object) const;
  size_t kind_of(uint32_t object) const;  // GeomSpec::index()

  // Calls visit(object) for each object whose world bounds overlap the closed box; unbounded
  // objects are not visited.
  void ForEachIn(const Bounds& box, const std::function<void(uint32_t object)>& visit) const;
  // Back to what was added, for sending it on.
  struct Entry {
    GeomSpec spec;
    std::shared_ptr<const Geom> member;
    PlacementId placement;
    Rank rank;
  };
  Entry entry(uint32_t object) const;

  size_t size() const;    // objects
  size_t bytes() const;   // everything that the set occupies, its hierarchy included
  Bounds bounds() const;  // of the bounded objects

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayshade
