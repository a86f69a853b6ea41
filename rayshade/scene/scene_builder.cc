// Objects go into the object set as they are read, with local placement and sequence in place of
// placement and rank, and are resolved at the end; see scene_builder.h.
//
// Members of named objects wait beside the set, since they may come to stand in many places or in
// none. So does everything where there are several frames, each of which needs a set of its own.
#include "rayshade/scene/scene_builder.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "rayshade/common/check.h"
#include "rayshade/geom/make_geom.h"
#include "rayshade/scene/skeleton.h"

namespace rayshade {
namespace {

// An object that waits for its placements. Spheres, the commonest kind, take no allocation.
struct WaitingObject {
  uint64_t sequence;
  LocalPlacement local;
  std::variant<SphereSpec, std::unique_ptr<const GeomSpec>> content;

  WaitingObject(uint64_t at, LocalPlacement placement, GeomSpec&& spec)
      : sequence(at), local(placement) {
    if (const auto* sphere = std::get_if<SphereSpec>(&spec)) {
      content = *sphere;
    } else {
      content = std::make_unique<const GeomSpec>(std::move(spec));
    }
  }
  GeomSpec spec() const {
    if (const auto* sphere = std::get_if<SphereSpec>(&content)) return *sphere;
    return *std::get<1>(content);
  }
};

// While an object is in the set unresolved, its placement holds the local one and, in the highest
// bit, whether it is of an inclusive kind; its rank holds its sequence.
constexpr PlacementId kInclusiveBit = PlacementId{1} << 31;

class MemoryStore : public ObjectStore {
 public:
  explicit MemoryStore(const Scene* scene) : set_(std::make_unique<ObjectSet>(scene)) {}

  void Add(uint64_t sequence, LocalPlacement local, bool in_definition, GeomSpec&& spec) override {
    CHECK(sequence < kMaxPlacedObjects && local < kInclusiveBit);
    if (in_definition) {
      waiting_.emplace_back(sequence, local, std::move(spec));
    } else {
      set_->Add(spec, IsInclusive(spec) ? local | kInclusiveBit : local,
                static_cast<Rank>(sequence));
    }
  }

  void ReadBack(uint64_t first, uint64_t end, const Visit& visit) override {
    for (auto object = Find(first); object != waiting_.end() && object->sequence < end; ++object) {
      visit(object->local, object->spec());
    }
  }

  // Takes everything out of the set: it will be needed for several frames.
  void HoldAll() {
    for (size_t i = 0; i < set_->size(); ++i) {
      ObjectSet::Entry entry = set_->entry(static_cast<uint32_t>(i));
      waiting_.emplace_back(entry.rank, entry.placement & ~kInclusiveBit, std::move(entry.spec));
    }
    set_.reset();
    std::sort(waiting_.begin(), waiting_.end(),
              [](const auto& a, const auto& b) { return a.sequence < b.sequence; });
  }

  std::unique_ptr<ObjectSet> Resolve(const Scene* scene, const Expansion& expansion) {
    std::unique_ptr<ObjectSet> set = std::move(set_);
    if (set == nullptr) set = std::make_unique<ObjectSet>(scene);
    ResolveDirect(expansion, set.get());
    PlaceWaiting(*scene, expansion, set.get());
    return set;
  }

 private:
  std::vector<WaitingObject>::const_iterator Find(uint64_t sequence) const {
    return std::lower_bound(
        waiting_.begin(), waiting_.end(), sequence,
        [](const WaitingObject& object, uint64_t wanted) { return object.sequence < wanted; });
  }

  static void ResolveDirect(const Expansion& expansion, ObjectSet* set) {
    RunCursor cursor(&expansion.runs);
    set->ResolveAll([&](PlacementId unresolved, Rank sequence) {
      const ObjectRun *run, *end;
      cursor.Find(sequence, &run, &end);
      CHECK(end == run + 1);
      return std::pair(run->placement(unresolved & ~kInclusiveBit),
                       expansion.rank(*run, sequence, (unresolved & kInclusiveBit) != 0));
    });
  }

  // Members of what is placed more than once are made once and shared.
  void PlaceWaiting(const Scene& scene, const Expansion& expansion, ObjectSet* set) const {
    RunCursor cursor(&expansion.runs);
    for (const WaitingObject& object : waiting_) {
      const ObjectRun *run, *end;
      cursor.Find(object.sequence, &run, &end);
      const GeomSpec spec = object.spec();
      const bool inclusive = IsInclusive(spec);
      std::shared_ptr<const Geom> shared;
      if (end - run > 1) shared = MakeGeom(spec, scene.shutter);
      for (; run != end; ++run) {
        const PlacementId placement = run->placement(object.local);
        const Rank rank = expansion.rank(*run, object.sequence, inclusive);
        if (shared == nullptr || scene.placement(placement).in_place) {
          set->Add(spec, placement, rank);
        } else {
          set->Add(shared, spec.index(), placement, rank);
        }
      }
    }
  }

  std::unique_ptr<ObjectSet> set_;      // null once taken, or where everything waits
  std::vector<WaitingObject> waiting_;  // by sequence
};

}  // namespace

struct SceneBuilder::Impl {
  // The set refers to its scene from the start; Build fills it in.
  std::unique_ptr<Scene> scene = std::make_unique<Scene>(SceneSpec{}, 0);
  MemoryStore store{scene.get()};
  Skeleton skeleton{&store};
  bool several_frames = false;
};

SceneBuilder::SceneBuilder() : impl_(std::make_unique<Impl>()) {}
SceneBuilder::~SceneBuilder() = default;

Skeleton& SceneBuilder::skeleton() { return impl_->skeleton; }

void SceneBuilder::OnSettings(const Settings& settings) {
  impl_->skeleton.OnSettings(settings);
  impl_->several_frames = settings.frames > 1;
  if (impl_->several_frames) impl_->store.HoldAll();
}

const Settings& SceneBuilder::settings() const { return impl_->skeleton.settings(); }

SceneBuilder::Built SceneBuilder::Build(int frame) {
  Built built;
  built.scene =
      impl_->several_frames ? std::make_unique<Scene>(SceneSpec{}, frame) : std::move(impl_->scene);
  CHECK(built.scene != nullptr);
  Expansion expansion = impl_->skeleton.Expand(frame);
  *built.scene = Scene(impl_->skeleton.Spec(std::move(expansion.placements)), frame);
  built.objects = impl_->store.Resolve(built.scene.get(), expansion);
  built.objects->Build();
  return built;
}

}  // namespace rayshade
