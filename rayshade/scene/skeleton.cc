// Gathering the tree of a scene file while its objects pass through to the store; see skeleton.h.
#include "rayshade/scene/skeleton.h"

#include <algorithm>
#include <unordered_map>

#include "rayshade/common/check.h"
#include "rayshade/geom/kind_name.h"
#include "rayshade/geom/make_geom.h"
#include "rayshade/geom/member.h"
#include "rayshade/scene/skeleton_tree.h"

namespace rayshade {
namespace {

// Something between its beginning and its end.
struct OpenAggregate {
  bool csg = false;  // CSG, or inside of it: collected in `members`
  NodeId node = 0;   // !csg
  AggregateKind kind = AggregateKind::kList;
  int counts[3] = {1, 1, 1};
  std::vector<PlacedSpec> members;
  // Local placements of objects that have a surface at most.
  std::unordered_map<uint64_t, LocalPlacement> interned;
  uint64_t last_key = ~uint64_t{0};
  LocalPlacement last_local = 0;
};

uint64_t LeavesOf(const GeomSpec& spec) {
  const auto* composite = std::get_if<CompositeSpec>(&spec);
  if (!composite) return 1;
  uint64_t leaves = 0;
  for (const PlacedSpec& member : *composite->members) leaves += LeavesOf(member.geom);
  return leaves;
}

// The same object with something more around it, as one level where that makes no difference.
PlacedSpec Wrap(const PlacedSpec& inner, Attributes&& outer) {
  const Attributes& own = inner.attributes;
  if (own.plain() || outer.plain()) {
    const SurfaceId surface = own.surface != kNoSurface ? own.surface : outer.surface;
    PlacedSpec both{inner.geom, outer.plain() ? own : std::move(outer)};
    both.attributes.surface = surface;
    return both;
  }
  CompositeSpec list;
  list.kind = AggregateKind::kList;
  list.members = std::make_shared<const std::vector<PlacedSpec>>(1, inner);
  return {std::move(list), std::move(outer)};
}

}  // namespace

struct Skeleton::Impl {
  explicit Impl(ObjectStore* object_store) : store(object_store) {
    tree.nodes.emplace_back();
    tree.attributes.emplace_back();
    open.emplace_back();
  }

  OpenAggregate& top() { return open.back(); }
  TreeNode& node() { return tree.nodes[top().node]; }
  bool in_definition() const { return !open_definitions.empty(); }

  LocalPlacement Intern(Attributes&& attributes, bool bounded, bool endless);
  void PlaceNested(NodeId child, Attributes&& attributes);
  void Open(TreeNode&& node);
  std::vector<PlacedSpec> ReadMembers(NodeId id);
  PlacedSpec ReadDefinition(NodeId id);
  void NoteSurfaces(const PlacedSpec& placed);
  void NoteKind(size_t kind);

  ObjectStore* store;
  SceneSpec spec;
  SkeletonTree tree;
  std::vector<OpenAggregate> open;       // the world first
  std::vector<size_t> open_definitions;  // their places in `open`
  std::vector<NodeId> definitions;
  std::unordered_map<NodeId, PlacedSpec> definitions_read;  // those that stand inside CSG
  uint64_t sequence = 0;
  std::vector<size_t> kinds_read;
  size_t last_kind = std::variant_npos;
};

LocalPlacement Skeleton::Impl::Intern(Attributes&& attributes, bool bounded, bool endless) {
  std::vector<LocalAttributes>& locals = node().locals;
  const auto fresh = static_cast<LocalPlacement>(locals.size());
  if (!attributes.plain() || endless) {
    locals.push_back({std::move(attributes), bounded, endless});
    return fresh;
  }
  OpenAggregate& aggregate = top();
  const uint64_t key = uint64_t{attributes.surface} << 1 | (bounded ? 1 : 0);
  if (key != aggregate.last_key) {
    const auto [found, is_new] = aggregate.interned.try_emplace(key, fresh);
    if (is_new) locals.push_back({std::move(attributes), bounded, false});
    aggregate.last_key = key;
    aggregate.last_local = found->second;
  }
  return aggregate.last_local;
}

void Skeleton::Impl::PlaceNested(NodeId child_id, Attributes&& attributes) {
  const TreeNode& child = tree.nodes[child_id];
  TreeNode& parent = node();
  NodeItem item;
  item.nested = true;
  item.bounded = child.bounded;
  item.node = child_id;
  if (child.bounded) {
    parent.bounded = true;
    if (child.moving || attributes.transforms.animated()) {
      parent.moving = true;
    } else {
      parent.box.Include(OuterBounds(attributes, child.box, {}));
    }
  }
  if (!attributes.plain() || attributes.surface != kNoSurface) {
    item.attributes = static_cast<uint32_t>(tree.attributes.size());
    tree.attributes.push_back(std::move(attributes));
  }
  parent.items.push_back(item);
}

void Skeleton::Impl::Open(TreeNode&& node) {
  OpenAggregate aggregate;
  aggregate.node = static_cast<NodeId>(tree.nodes.size());
  aggregate.kind = node.kind;
  tree.nodes.push_back(std::move(node));
  open.push_back(std::move(aggregate));
}

// The members of a node as values, for CSG.
std::vector<PlacedSpec> Skeleton::Impl::ReadMembers(NodeId id) {
  const TreeNode& node = tree.nodes[id];
  std::vector<PlacedSpec> members;
  for (const NodeItem& item : node.items) {
    if (!item.nested) {
      store->ReadBack(item.first, item.end, [&](LocalPlacement local, const GeomSpec& geom) {
        members.push_back({geom, node.locals[local].attributes});
      });
      continue;
    }
    const TreeNode& child = tree.nodes[item.node];
    Attributes attributes = tree.attributes[item.attributes];
    if (child.is_definition) {
      members.push_back(Wrap(ReadDefinition(item.node), std::move(attributes)));
      continue;
    }
    CompositeSpec composite;
    composite.kind = child.kind;
    std::copy(child.counts, child.counts + 3, composite.counts);
    composite.members = std::make_shared<const std::vector<PlacedSpec>>(ReadMembers(item.node));
    members.push_back({std::move(composite), std::move(attributes)});
  }
  return members;
}

PlacedSpec Skeleton::Impl::ReadDefinition(NodeId id) {
  const auto known = definitions_read.find(id);
  if (known != definitions_read.end()) return known->second;
  std::vector<PlacedSpec> members = ReadMembers(id);
  CHECK(members.size() == 1);
  return definitions_read.emplace(id, std::move(members.front())).first->second;
}

void Skeleton::Impl::NoteSurfaces(const PlacedSpec& placed) {
  const SurfaceId surface = placed.attributes.surface;
  if (surface != kNoSurface && !(spec.surfaces[surface].transp < kEpsilon)) {
    spec.transparent_inside = true;
  }
  if (const auto* composite = std::get_if<CompositeSpec>(&placed.geom)) {
    for (const PlacedSpec& member : *composite->members) NoteSurfaces(member);
  }
}

void Skeleton::Impl::NoteKind(size_t kind) {
  if (kind == last_kind) return;
  last_kind = kind;
  kind = ReportedKind(kind);
  if (std::find(kinds_read.begin(), kinds_read.end(), kind) == kinds_read.end()) {
    kinds_read.push_back(kind);
  }
}

Skeleton::Skeleton(ObjectStore* store) : impl_(std::make_unique<Impl>(store)) {}
Skeleton::~Skeleton() = default;

SurfaceId Skeleton::AddSurface(const Surface& surface) {
  impl_->spec.surfaces.push_back(surface);
  return static_cast<SurfaceId>(impl_->spec.surfaces.size() - 1);
}

TextureId Skeleton::AddTexture(const TextureSpec& texture) {
  impl_->spec.textures.push_back(texture);
  return static_cast<TextureId>(impl_->spec.textures.size() - 1);
}

void Skeleton::AddLight(const LightSpec& light) { impl_->spec.lights.push_back(light); }

void Skeleton::SetAtmosphere(const Atmosphere& atmosphere) { impl_->spec.atmosphere = atmosphere; }

void Skeleton::AddPrimitive(GeomSpec&& spec, Attributes&& attributes) {
  impl_->NoteKind(spec.index());
  if (impl_->top().csg) {
    impl_->top().members.push_back({std::move(spec), std::move(attributes)});
    return;
  }
  TreeNode& node = impl_->node();
  // A CSG object with a plane in it may have a box and no end, or an end and no box [rayshade4/2
  // s.9.2].
  const Bounds own = OwnBox(spec, {});
  const bool bounded = !(own.low.x > own.high.x);
  const bool animated = attributes.transforms.animated();
  if (bounded) {
    node.bounded = true;
    if (!animated) node.box.Include(OuterBounds(attributes, own, {}));
  }
  const bool composite = std::holds_alternative<CompositeSpec>(spec);
  if (composite) node.primitives_in_csg += LeavesOf(spec) - 1;  // one is an item
  const bool endless = bounded && composite && !IsBounded(spec);
  const LocalPlacement local = impl_->Intern(std::move(attributes), bounded, endless);
  if (bounded && animated) {
    node.moving = true;
    node.moving_objects.push_back({own, local});
  }
  const uint64_t sequence = impl_->sequence++;
  if (!node.items.empty() && !node.items.back().nested && node.items.back().end == sequence &&
      node.items.back().bounded == bounded) {
    ++node.items.back().end;
  } else {
    NodeItem item;
    item.bounded = bounded;
    item.first = sequence;
    item.end = sequence + 1;
    node.items.push_back(item);
  }
  impl_->store->Add(sequence, local, impl_->in_definition(), std::move(spec));
}

void Skeleton::AddInstance(DefinitionId definition, Attributes&& attributes) {
  const NodeId node = impl_->definitions[definition];
  if (impl_->top().csg) {
    impl_->top().members.push_back(Wrap(impl_->ReadDefinition(node), std::move(attributes)));
  } else {
    impl_->PlaceNested(node, std::move(attributes));
  }
}

void Skeleton::BeginAggregate(AggregateKind kind, const int counts[3]) {
  if (!IsCsg(kind) && !impl_->top().csg) {
    TreeNode node;
    node.kind = kind;
    if (kind == AggregateKind::kGrid) std::copy(counts, counts + 3, node.counts);
    impl_->Open(std::move(node));
    return;
  }
  OpenAggregate aggregate;
  aggregate.csg = true;
  aggregate.kind = kind;
  if (kind == AggregateKind::kGrid) std::copy(counts, counts + 3, aggregate.counts);
  impl_->open.push_back(std::move(aggregate));
}

bool Skeleton::EndAggregate(Attributes&& attributes) {
  CHECK(impl_->open.size() > 1);
  OpenAggregate ended = std::move(impl_->top());
  impl_->open.pop_back();
  if (!ended.csg) {
    if (impl_->tree.nodes[ended.node].items.empty()) return false;
    impl_->PlaceNested(ended.node, std::move(attributes));
    return true;
  }
  // A CSG object has two operands; with any other number it is dropped [rayshade4/1 s.3.3, 13.C].
  if (ended.members.empty() || (IsCsg(ended.kind) && ended.members.size() != 2)) return false;
  CompositeSpec composite;
  composite.kind = ended.kind;
  std::copy(ended.counts, ended.counts + 3, composite.counts);
  ended.members.shrink_to_fit();
  composite.members = std::make_shared<const std::vector<PlacedSpec>>(std::move(ended.members));
  if (!impl_->top().csg) {
    for (const PlacedSpec& member : *composite.members) impl_->NoteSurfaces(member);
  }
  AddPrimitive(std::move(composite), std::move(attributes));
  return true;
}

void Skeleton::BeginDefinition() {
  impl_->open_definitions.push_back(impl_->open.size());
  TreeNode node;
  node.is_definition = true;
  impl_->Open(std::move(node));
}

DefinitionId Skeleton::EndDefinition() {
  CHECK(impl_->in_definition() && impl_->open_definitions.back() == impl_->open.size() - 1);
  const NodeId node = impl_->top().node;
  impl_->open.pop_back();
  impl_->open_definitions.pop_back();
  if (impl_->tree.nodes[node].items.empty()) return kNoDefinition;
  impl_->definitions.push_back(node);
  return static_cast<DefinitionId>(impl_->definitions.size() - 1);
}

void Skeleton::OnSettings(const Settings& settings) { impl_->spec.settings = settings; }

const Settings& Skeleton::settings() const { return impl_->spec.settings; }

uint64_t Skeleton::objects_stored() const { return impl_->sequence; }

const std::vector<size_t>& Skeleton::kinds_read() const { return impl_->kinds_read; }

uint64_t Skeleton::primitives_placed() const { return PrimitivesIn(impl_->tree, 0); }

Expansion Skeleton::Expand(int frame) const {
  CHECK(impl_->open.size() == 1);
  return ExpandTree(impl_->tree, FrameShutter(impl_->spec.settings, frame));
}

SceneSpec Skeleton::Spec(std::vector<Placement> placements) const {
  SceneSpec spec = impl_->spec;
  spec.placements = std::move(placements);
  return spec;
}

}  // namespace rayshade
