// Everything that a scene file says except its objects: surfaces, lights, settings, and the tree of
// aggregates, definitions and instances, as a sink of the parser. Objects go straight to a store,
// in memory or on disk, as they are read; what becomes of them is known at the end of the file only
// and is then a matter of arithmetic:
//
//   1. Objects are numbered 0, 1, 2 … in file order (their sequence). What is written around an
//   object itself is its local placement: a small number, interned within the innermost aggregate.
//   2. A CSG aggregate with everything in it is one object (a CompositeSpec). Lists and grids leave
//   no object of their own: they are paths.
//   3. Expand gives runs: ranges of the sequence whose objects have one path to the world.
//   Placement and rank of every object in a run follow from its sequence and local placement. A
//   definition placed k times gives k runs over the same range; one never placed gives none.
//   4. Two runs cover the same range or have no object in common. Runs are sorted by range, so a
//   store is walked once, in file order, with the runs beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "rayshade/scene/rank.h"
#include "rayshade/scene/scene.h"
#include "rayshade/scene/scene_sink.h"

namespace rayshade {

using LocalPlacement = uint32_t;

class ObjectStore {
 public:
  virtual ~ObjectStore() = default;
  // sequence: 0, 1, 2 … in the order of the calls. in_definition: a member of a named object, which
  // may come to stand in several places, or in none.
  virtual void Add(uint64_t sequence, LocalPlacement local, bool in_definition,
                   GeomSpec&& spec) = 0;
  // Calls visit, in order, for the objects [first, end), all of which are in_definition; between
  // calls of Add. Needed where a named object stands inside CSG.
  using Visit = std::function<void(LocalPlacement, const GeomSpec&)>;
  virtual void ReadBack(uint64_t first, uint64_t end, const Visit& visit) = 0;
};

// Objects with one path to the world.
struct ObjectRun {
  uint64_t first = 0, end = 0;      // sequence
  PlacementId first_placement = 0;  // of local placement 0
  uint32_t first_order = 0;         // least place in the order of testing
  bool backwards = false;           // the last object of the run is tested first

  PlacementId placement(LocalPlacement local) const { return first_placement + local; }
  uint32_t order(uint64_t sequence) const {
    return first_order + static_cast<uint32_t>(backwards ? end - 1 - sequence : sequence - first);
  }
};

struct Expansion {
  std::vector<ObjectRun> runs;        // sorted by first
  std::vector<Placement> placements;  // for SceneSpec
  uint32_t objects = 0;               // placed objects in all

  Rank rank(const ObjectRun& run, uint64_t sequence, bool inclusive) const {
    return RankOf(run.order(sequence), inclusive, objects);
  }
};

// Finds the runs of one object after the other. Cheapest where sequences ascend; any order will do.
class RunCursor {
 public:
  explicit RunCursor(const std::vector<ObjectRun>* runs) : runs_(runs) {}
  // The runs that the object belongs to: [*begin, *end) of runs; none for members of definitions
  // that were never placed.
  void Find(uint64_t sequence, const ObjectRun** begin, const ObjectRun** end);

 private:
  const std::vector<ObjectRun>* runs_;
  size_t begin_ = 0, end_ = 0;  // runs of the range found last
};

class Skeleton : public SceneSink {
 public:
  // store: not owned.
  explicit Skeleton(ObjectStore* store);
  ~Skeleton() override;

  SurfaceId AddSurface(const Surface& surface) override;
  TextureId AddTexture(const TextureSpec& texture) override;
  void AddLight(const LightSpec& light) override;
  void SetAtmosphere(const Atmosphere& atmosphere) override;
  void AddPrimitive(GeomSpec&& spec, Attributes&& attributes) override;
  void AddInstance(DefinitionId definition, Attributes&& attributes) override;
  void BeginAggregate(AggregateKind kind, const int counts[3]) override;
  bool EndAggregate(Attributes&& attributes) override;
  void BeginDefinition() override;
  DefinitionId EndDefinition() override;
  void OnSettings(const Settings& settings) override;

  const Settings& settings() const;
  uint64_t objects_stored() const;  // the next sequence
  // Kinds of objects (geom/kind_name.h) in the order of their first appearance in the file.
  const std::vector<size_t>& kinds_read() const;
  // Those of CSG objects one by one, and all as often as they are placed.
  uint64_t primitives_placed() const;

  // After parsing. Paths of one frame (clip boxes of moving aggregates differ between frames).
  // Throws std::runtime_error where instances of instances make more objects than ranks can tell
  // apart.
  Expansion Expand(int frame) const;
  // The scene's specification with these placements.
  SceneSpec Spec(std::vector<Placement> placements) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rayshade
