// Placed objects and the hierarchy over them; see object_set.h.
#include "rayshade/accel/object_set.h"

#include <algorithm>
#include <cmath>

#include "rayshade/accel/build.h"
#include "rayshade/accel/other_objects.h"
#include "rayshade/accel/stored_objects.h"
#include "rayshade/accel/trace_view.h"
#include "rayshade/common/check.h"
#include "rayshade/geom/make_geom.h"

namespace rayshade {

namespace {

constexpr uint32_t kSampled = 1024;  // objects looked at for the center

// The medians of a sample of the objects' places, so that a few huge objects do not cost the others
// their digits.
void FindCenter(const StoredObjects& objects, double center[3]) {
  const uint32_t count = static_cast<uint32_t>(objects.size());
  const uint32_t step = std::max(1u, count / kSampled);
  std::vector<double> places[3];
  for (uint32_t i = 0; i < count; i += step) {
    const Bounds box = objects.WorldBox(i);
    if (box.empty()) continue;
    for (int axis = 0; axis < 3; ++axis) {
      places[axis].push_back(0.5 * (box.low[axis] + box.high[axis]));
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& p = places[axis];
    center[axis] = 0;
    if (p.empty()) continue;
    std::nth_element(p.begin(), p.begin() + p.size() / 2, p.end());
    if (std::isfinite(p[p.size() / 2])) center[axis] = p[p.size() / 2];
  }
}

}  // namespace

struct ObjectSet::Impl {
  explicit Impl(const Scene* scene) : objects(scene) {}

  StoredObjects objects;
  GrowingArray<Node> nodes;
  std::vector<uint32_t> unbounded;
  std::vector<uint8_t> opaque;  // by placement
  std::vector<float> quads;     // around all but spheres (quads.h)
  std::vector<float> parts;     // of polygons (polygon_parts.h)
  Bounds bounds;
  OtherObjects others{&objects};
  FlatObjects flat;
  TraceView view;
  const Kernels* kernels = nullptr;  // since Build

  void Build();
  void FindOpaque();
  void MakeQuads();
};

void ObjectSet::Impl::Build() {
  CHECK(kernels == nullptr);
  kernels = &ChooseKernels();
  objects.Settle();
  FindOpaque();
  FindCenter(objects, view.center);
  bounds = objects.BoxOfSpheres();
  for (uint32_t i = objects.sphere_count(); i < objects.size(); ++i) {
    if (others.bounded(i)) bounds.Include(objects.WorldBox(i));
  }
  // The hierarchy.
  std::vector<BuildRef> refs = objects.RefsOfBounded(view.center);
  BuildInput input;
  std::copy(view.center, view.center + 3, input.center);
  input.spheres = {objects.spheres().data(), objects.spheres().size()};
  input.keys = {objects.keys().data(), objects.sphere_count()};
  input.growth = objects.growth();
  input.refs = refs;
  BuildOutput built = BuildHierarchy(input);
  nodes = std::move(built.nodes);
  objects.leaf_begins = std::move(built.leaf_begins);
  // Objects in the order of its leaves.
  const uint32_t spheres = objects.sphere_count();
  for (uint32_t i = spheres + objects.Permute(refs); i < objects.size(); ++i) {
    if (!others.bounded(i)) unbounded.push_back(i);
  }
  for (Node& node : nodes) {
    for (int i = 0; i < kNodeWidth; ++i) {
      if (KindOf(node.branch[i]) > kSphereLeaf) node.branch[i] += spheres;
    }
  }
  // What the kernels see.
  view.nodes = nodes.data();
  view.node_count = static_cast<uint32_t>(nodes.size());
  view.set = &others;
  view.spheres = spheres == 0 ? nullptr : &objects.spheres()[0].x;
  view.sphere_count = spheres;
  flat = objects.flat();
  MakeQuads();
  view.flat = &flat;
  view.keys = objects.keys().data();
  view.unbounded = unbounded.data();
  view.unbounded_count = static_cast<uint32_t>(unbounded.size());
  view.opaque = opaque.data();
  view.callbacks = OtherObjects::Callbacks();
}

// Quadrilaterals of all leaves but those of spheres.
void ObjectSet::Impl::MakeQuads() {
  const uint32_t spheres = objects.sphere_count();
  // Kernels load eight numbers from the last row.
  if (objects.size() > spheres) quads.resize(kQuadRows * (objects.size() - spheres) + kLeafSize);
  for (const Node& node : nodes) {
    for (const uint64_t branch : node.branch) {
      if (KindOf(branch) <= kSphereLeaf) continue;
      const uint32_t first = ChildOf(branch), count = CountOf(branch);
      Quad leaf[kLeafSize];
      for (uint32_t i = 0; i < count; ++i) leaf[i] = objects.QuadAround(first + i, view.center);
      WriteQuads({leaf, count}, quads.data() + kQuadRows * size_t{first - spheres});
    }
  }
  flat.quads = quads.data();
  objects.CutPolygons(view.center, &parts);
  flat.parts = parts.data();
}

void ObjectSet::Impl::FindOpaque() {
  const Scene& scene = objects.scene();
  view.all_opaque = !scene.any_transparent;
  opaque.resize(scene.spec.placements.size());
  for (PlacementId i = 0; i < opaque.size(); ++i) {
    opaque[i] = !(scene.bound_surface(scene.placement(i).surface).transp >= kEpsilon);
  }
  others.set_opaque(&opaque, view.all_opaque);
}

ObjectSet::ObjectSet(const Scene* scene) : impl_(std::make_unique<Impl>(scene)) {}
ObjectSet::~ObjectSet() = default;
ObjectSet::ObjectSet(ObjectSet&&) noexcept = default;
ObjectSet& ObjectSet::operator=(ObjectSet&&) noexcept = default;

void ObjectSet::Add(const GeomSpec& spec, PlacementId placement, Rank rank) {
  impl_->objects.Add(spec, {placement, rank});
}

void ObjectSet::Add(std::shared_ptr<const Geom> member, size_t kind, PlacementId placement,
                    Rank rank) {
  impl_->objects.Add(std::move(member), static_cast<uint8_t>(kind), {placement, rank});
}

void ObjectSet::ResolveAll(const Resolve& resolve) { impl_->objects.Resolve(resolve); }

void ObjectSet::Build() { impl_->Build(); }

void ObjectSet::Nearest(std::span<const Ray> rays, std::span<Hit> hits, OpCounts* counts) const {
  CHECK(impl_->kernels != nullptr && rays.size() == hits.size());
  TraceView view = impl_->view;
  view.owner = this;
  impl_->kernels->nearest(view, rays.data(), hits.data(), static_cast<uint32_t>(rays.size()),
                          counts);
}

void ObjectSet::NearestOf(const Ray& ray, uint32_t object, Hit* hit) const {
  const Rank before = hit->rank;
  impl_->others.Nearest(ray, object, hit->distance, hit);
  if (hit->rank != before) hit->set = this;
}

void ObjectSet::Block(std::span<const Ray> rays, std::span<const double> limits,
                      std::span<uint8_t> blocked, std::span<uint8_t> crossed,
                      OpCounts* counts) const {
  CHECK(impl_->kernels != nullptr && rays.size() == limits.size() && rays.size() == blocked.size());
  CHECK(crossed.empty() || crossed.size() == rays.size());
  impl_->kernels->block(impl_->view, rays.data(), limits.data(), blocked.data(),
                        crossed.empty() ? nullptr : crossed.data(),
                        static_cast<uint32_t>(rays.size()), counts);
}

void ObjectSet::Block(const ShadowRows& rows, OpCounts* counts) const {
  CHECK(impl_->kernels != nullptr);
  impl_->kernels->block_rows(impl_->view, rows, counts);
}

void ObjectSet::Aim(const AimRows& rows) const { impl_->kernels->aim(rows); }
void ObjectSet::Sort(const SortRows& rows) const { impl_->kernels->sort(rows); }
void ObjectSet::AddDiffuse(const DiffuseRows& rows) const { impl_->kernels->add_diffuse(rows); }
void ObjectSet::Shine(const ShineRows& rows) const { impl_->kernels->shine(rows); }

void ObjectSet::Describe(const Ray& ray, const Hit& hit, HitPath* path) const {
  CHECK(hit.set == this);
  impl_->others.Describe(ray, hit.object, hit.distance, path);
}

bool ObjectSet::IsPlainSphere(uint32_t object, PlainSphere* plain) const {
  const StoredObjects& objects = impl_->objects;
  if (!objects.is_sphere(object)) return false;
  const Placement& placement = objects.scene().placement(objects.key(object).placement);
  if (!placement.plain) return false;
  plain->center = objects.SphereRow(object, &plain->stride);
  plain->surface = placement.surface;
  return true;
}

PlacementId ObjectSet::placement_of(uint32_t object) const {
  return impl_->objects.key(object).placement;
}

Rank ObjectSet::rank_of(uint32_t object) const { return impl_->objects.key(object).rank; }

size_t ObjectSet::kind_of(uint32_t object) const {
  return impl_->objects.is_sphere(object) ? kSphereGeom : impl_->objects.item(object).geom;
}

void ObjectSet::ForEachIn(const Bounds& box,
                          const std::function<void(uint32_t object)>& visit) const {
  if (impl_->nodes.empty()) return;
  float low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = RoundedDown(box.low[axis] - impl_->view.center[axis]);
    high[axis] = RoundedUp(box.high[axis] - impl_->view.center[axis]);
  }
  std::vector<uint32_t> stack{0};
  while (!stack.empty()) {
    const Node& node = impl_->nodes[stack.back()];
    stack.pop_back();
    for (int i = 0; i < kNodeWidth; ++i) {
      const uint64_t branch = node.branch[i];
      bool apart = KindOf(branch) == kEmptySlot;
      for (int axis = 0; axis < 3; ++axis) {
        apart |= node.plane[axis][i] > high[axis] || node.plane[3 + axis][i] < low[axis];
      }
      if (apart) continue;
      const uint32_t child = ChildOf(branch);
      if (KindOf(branch) == kInnerNode) {
        stack.push_back(child);
        continue;
      }
      for (uint32_t k = child; k < child + CountOf(branch); ++k) {
        if (impl_->objects.WorldBox(k).Overlaps(box)) visit(k);
      }
    }
  }
}

ObjectSet::Entry ObjectSet::entry(uint32_t object) const {
  const StoredObjects& objects = impl_->objects;
  Entry entry{objects.SpecOf(object), nullptr, objects.key(object).placement,
              objects.key(object).rank};
  if (!objects.is_sphere(object) && objects.item(object).kind == kOtherLeaf) {
    const OtherObject& other = objects.other(objects.item(object));
    if (!other.spec) entry.member = other.geom;
  }
  return entry;
}

size_t ObjectSet::size() const { return impl_->objects.size(); }

size_t ObjectSet::bytes() const {
  return sizeof *this + sizeof(Impl) + impl_->quads.capacity() * sizeof(float) +
         impl_->objects.bytes() + impl_->nodes.bytes() +
         impl_->unbounded.capacity() * sizeof(uint32_t) + impl_->opaque.capacity();
}

Bounds ObjectSet::bounds() const { return impl_->bounds; }

}  // namespace rayshade
