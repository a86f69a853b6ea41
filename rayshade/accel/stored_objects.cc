// Holding objects; see stored_objects.h.
#include "rayshade/accel/stored_objects.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "rayshade/accel/polygon_parts.h"
#include "rayshade/common/check.h"
#include "rayshade/geom/make_geom.h"

namespace rayshade {

namespace {

// Hits on objects other than spheres are off by less than this part of their coordinates.
constexpr double kRounding = 1e-10;

// Points of a polygon are off its plane by no more than rounding makes them.
bool IsPlanar(const PolygonPlane& plane, std::span<const Vector> points) {
  return std::all_of(points.begin(), points.end(), [&](const Vector& p) {
    return std::abs(Dot(plane.normal, p) - plane.offset) <= 1e-12 * plane.reach;
  });
}

double LargestCoordinate(const Bounds& b) {
  return std::max({std::abs(b.low.x), std::abs(b.low.y), std::abs(b.low.z), std::abs(b.high.x),
                   std::abs(b.high.y), std::abs(b.high.z)});
}

// A world box relative to the center, around all hits.
void RoundOutwards(const Bounds& box, const double center[3], float low[3], float high[3]) {
  const double margin = kRounding * LargestCoordinate(box);
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = RoundedDown(box.low[axis] - center[axis] - margin);
    high[axis] = RoundedUp(box.high[axis] - center[axis] + margin);
  }
}

// All ranks in ascending or in descending order, as scene files give them.
bool Ordered(const GrowingArray<ObjectKey>& keys) {
  const auto before = [](const ObjectKey& a, const ObjectKey& b) { return a.rank < b.rank; };
  const auto after = [](const ObjectKey& a, const ObjectKey& b) { return a.rank > b.rank; };
  const auto none_equal = [](const auto* begin, const auto* end) {
    return std::adjacent_find(begin, end, [](const ObjectKey& a, const ObjectKey& b) {
             return a.rank == b.rank;
           }) == end;
  };
  return (std::is_sorted(keys.begin(), keys.end(), before) ||
          std::is_sorted(keys.begin(), keys.end(), after)) &&
         none_equal(keys.begin(), keys.end());
}

static_assert(std::variant_size_v<GeomSpec> == kGeomKinds);
template <int kKind>
using SpecOfKind = std::variant_alternative_t<kKind, GeomSpec>;
static_assert(std::is_same_v<SpecOfKind<kSphereGeom>, SphereSpec>);
static_assert(std::is_same_v<SpecOfKind<kTriangleGeom>, TriangleSpec>);
static_assert(std::is_same_v<SpecOfKind<kPolygonGeom>, PolygonSpec>);
static_assert(std::is_same_v<SpecOfKind<kCompositeGeom>, CompositeSpec>);

uint8_t KindOf(const GeomSpec& spec) { return static_cast<uint8_t>(spec.index()); }

}  // namespace

void StoredObjects::Add(const GeomSpec& spec, ObjectKey key) {
  if (const auto* s = std::get_if<SphereSpec>(&spec)) {
    spheres_.push_back({s->center.x, s->center.y, s->center.z, s->radius});
    keys_.push_back(key);
  } else if (const auto* t = std::get_if<TriangleSpec>(&spec)) {
    items_.push_back({kTriangleLeaf, KindOf(spec), static_cast<uint32_t>(triangles_.size())});
    item_keys_.push_back(key);
    triangles_.push_back({MakeTriangleShape(t->point, t->flip), t->flip});
  } else if (const auto* p = std::get_if<PolygonSpec>(&spec)) {
    items_.push_back({kPolygonLeaf, KindOf(spec), static_cast<uint32_t>(polygons_.size())});
    item_keys_.push_back(key);
    const PolygonPlane plane = MakePolygonPlane(p->points, p->flip);
    polygons_.push_back({plane, static_cast<uint32_t>(points_.size()),
                         static_cast<uint32_t>(p->points.size()), p->flip,
                         IsPlanar(plane, p->points)});
    points_.insert(points_.end(), p->points.begin(), p->points.end());
  } else {
    OtherObject other;
    other.spec = std::make_unique<const GeomSpec>(spec);
    AddOther(std::move(other), KindOf(spec), key);
  }
}

void StoredObjects::Add(std::shared_ptr<const Geom> member, uint8_t kind, ObjectKey key) {
  OtherObject other;
  other.geom = std::move(member);
  AddOther(std::move(other), kind, key);
}

void StoredObjects::AddOther(OtherObject&& other, uint8_t kind, ObjectKey key) {
  items_.push_back({kOtherLeaf, kind, static_cast<uint32_t>(others_.size())});
  item_keys_.push_back(key);
  others_.push_back(std::move(other));
}

void StoredObjects::Resolve(const ObjectSet::Resolve& resolve) {
  for (GrowingArray<ObjectKey>* keys : {&keys_, &item_keys_}) {
    for (ObjectKey& key : *keys) {
      const auto [placement, rank] = resolve(key.placement, key.rank);
      key = {placement, rank};
    }
  }
}

void StoredObjects::Settle() {
  CHECK(keys_.size() == spheres_.size());
  growth_.resize(scene_->spec.placements.size());
  for (PlacementId i = 0; i < growth_.size(); ++i) {
    const Placement& placement = scene_->placement(i);
    growth_[i] = 2 * kEpsilon * static_cast<double>(placement.levels.size());
  }
  if (items_.size() > 0 || !Ordered(keys_)) RemoveDuplicates();
  SettleSpheres();
  SettleItems();
}

// Drops all but the first object of each rank.
void StoredObjects::RemoveDuplicates() {
  std::vector<Rank> ranks;
  ranks.reserve(size());
  for (const ObjectKey& key : keys_) ranks.push_back(key.rank);
  for (const ObjectKey& key : item_keys_) ranks.push_back(key.rank);
  std::sort(ranks.begin(), ranks.end());
  std::vector<Rank> twice;
  for (size_t i = 1; i < ranks.size(); ++i) {
    if (ranks[i] == ranks[i - 1] && (twice.empty() || twice.back() != ranks[i])) {
      twice.push_back(ranks[i]);
    }
  }
  if (twice.empty()) return;
  std::vector<bool> seen(twice.size());
  const auto keep = [&](Rank rank) {
    const auto at = std::lower_bound(twice.begin(), twice.end(), rank);
    if (at == twice.end() || *at != rank) return true;
    const bool first = !seen[at - twice.begin()];
    seen[at - twice.begin()] = true;
    return first;
  };
  uint32_t kept = 0;
  for (uint32_t i = 0; i < spheres_.size(); ++i) {
    if (!keep(keys_[i].rank)) continue;
    spheres_[kept] = spheres_[i];
    keys_[kept++] = keys_[i];
  }
  spheres_.resize(kept);
  keys_.resize(kept);
  kept = 0;
  for (uint32_t i = 0; i < items_.size(); ++i) {
    if (!keep(item_keys_[i].rank)) continue;
    items_[kept] = items_[i];
    item_keys_[kept++] = item_keys_[i];
  }
  items_.resize(kept);
  item_keys_.resize(kept);
}

// Spheres that do not stand in place become other objects.
void StoredObjects::SettleSpheres() {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < spheres_.size(); ++i) {
    if (StaysFlat(keys_[i].placement)) {
      spheres_[kept] = spheres_[i];
      keys_[kept++] = keys_[i];
      continue;
    }
    const SphereRecord& s = spheres_[i];
    OtherObject other;
    other.spec = std::make_unique<const GeomSpec>(SphereSpec{s.radius, {s.x, s.y, s.z}});
    const uint8_t kind = KindOf(*other.spec);
    AddOther(std::move(other), kind, keys_[i]);
  }
  spheres_.resize(kept);
  keys_.resize(kept);
  spheres_.ShrinkToFit(2);  // kernels load eight doubles from the last row of a leaf
}

void StoredObjects::SettleItems() {
  for (uint32_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    const PlacementId placement = item_keys_[i].placement;
    if (item.kind != kOtherLeaf) {
      if (StaysFlat(placement)) continue;
      OtherObject other;
      other.spec = std::make_unique<const GeomSpec>(SpecOf(sphere_count() + i));
      item = {kOtherLeaf, item.geom, static_cast<uint32_t>(others_.size())};
      others_.push_back(std::move(other));
    }
    OtherObject& other = others_[item.index];
    if (other.spec) other.geom = MakeGeom(*other.spec, scene_->shutter);
    other.inclusive = other.geom->inclusive();
    other.bounded = other.geom->bounded();
    if (other.bounded) {
      other.box = rayshade::WorldBounds(scene_->placement(placement), other.geom->bounds(),
                                        scene_->shutter);
    }
  }
}

std::vector<BuildRef> StoredObjects::RefsOfBounded(const double center[3]) const {
  std::vector<BuildRef> refs;
  refs.reserve(items_.size());
  for (uint32_t i = 0; i < items_.size(); ++i) {
    if (items_[i].kind == kOtherLeaf && !others_[items_[i].index].bounded) continue;
    const Bounds box = WorldBox(sphere_count() + i);
    if (box.empty()) continue;
    BuildRef ref{};
    RoundOutwards(box, center, ref.low, ref.high);
    ref.index = i;
    ref.kind = items_[i].kind;
    refs.push_back(ref);
  }
  return refs;
}

uint32_t StoredObjects::Permute(std::span<const BuildRef> refs) {
  std::vector<uint32_t> order;
  std::vector<bool> has_ref(items_.size());
  for (const BuildRef& ref : refs) {
    order.push_back(ref.index);
    has_ref[ref.index] = true;
  }
  for (uint32_t i = 0; i < items_.size(); ++i) {
    if (!has_ref[i]) order.push_back(i);
  }
  std::vector<Item> items;
  std::vector<FlatTriangle> triangles;
  std::vector<FlatPolygon> polygons;
  std::vector<Vector> points;
  std::vector<OtherObject> others;
  items.reserve(items_.size());
  triangles.reserve(triangles_.size());
  polygons.reserve(polygons_.size());
  points.reserve(points_.size());
  others.reserve(others_.size());
  keys_.resize(sphere_count() + items_.size());
  keys_.ShrinkToFit();
  for (size_t i = 0; i < order.size(); ++i) {
    const Item& item = items_[order[i]];
    keys_[sphere_count() + i] = item_keys_[order[i]];
    if (item.kind == kTriangleLeaf) {
      items.push_back({item.kind, item.geom, static_cast<uint32_t>(triangles.size())});
      triangles.push_back(triangles_[item.index]);
    } else if (item.kind == kPolygonLeaf) {
      FlatPolygon polygon = polygons_[item.index];
      const std::span<const Vector> old = PointsOf(polygon);
      polygon.first_point = static_cast<uint32_t>(points.size());
      points.insert(points.end(), old.begin(), old.end());
      items.push_back({item.kind, item.geom, static_cast<uint32_t>(polygons.size())});
      polygons.push_back(polygon);
    } else {
      items.push_back({item.kind, item.geom, static_cast<uint32_t>(others.size())});
      others.push_back(std::move(others_[item.index]));
    }
  }
  items_ = std::move(items);
  triangles_ = std::move(triangles);
  polygons_ = std::move(polygons);
  points_ = std::move(points);
  others_ = std::move(others);
  item_keys_ = GrowingArray<ObjectKey>();
  return static_cast<uint32_t>(refs.size());
}

SphereSpec StoredObjects::sphere(uint32_t object) const {
  uint32_t stride;
  const double* const row = SphereRow(object, &stride);
  return {row[3 * stride], {row[0], row[stride], row[2 * stride]}};
}

const double* StoredObjects::SphereRow(uint32_t object, uint32_t* stride) const {
  if (leaf_begins.empty()) {
    *stride = 1;
    return &spheres_[object].x;
  }
  // A leaf begins at one of the kLeafSize objects up to this one, and the next, or what is behind
  // the last, at one of as many behind it.
  const uint32_t from = object < kLeafSize ? 0 : object - kLeafSize + 1;
  const uint32_t word = from / 64, shift = from % 64, at = object - from;
  static_assert(2 * kLeafSize <= 64);
  const uint64_t begins = leaf_begins[word] >> shift | leaf_begins[word + 1] << 1 << (63 - shift);
  const uint64_t up_to = begins & ((uint64_t{2} << at) - 1);
  const uint32_t first = from + static_cast<uint32_t>(std::bit_width(up_to)) - 1;
  const uint32_t end = object + 1 + static_cast<uint32_t>(std::countr_zero(begins >> at >> 1));
  *stride = end - first;
  return &spheres_[first].x + (object - first);
}

Bounds StoredObjects::WorldBox(uint32_t object) const {
  Bounds box;
  if (is_sphere(object)) {
    const SphereSpec s = sphere(object);
    const Vector r{s.radius, s.radius, s.radius};
    box = {s.center - r, s.center + r};
  } else {
    const Item& at = item(object);
    if (at.kind == kOtherLeaf) return others_[at.index].box;
    if (at.kind == kTriangleLeaf) {
      for (const Vector& p : triangles_[at.index].shape.point) box.Include(p);
    } else {
      for (const Vector& p : PointsOf(polygons_[at.index])) box.Include(p);
    }
  }
  GrowAsPlaced(key(object).placement, &box);
  return box;
}

// Spheres of one placement grow together: the least of what has grown is what has grown of the
// least.
Bounds StoredObjects::BoxOfSpheres() const {
  Bounds all;
  for (size_t begin = 0, end; begin < spheres_.size(); begin = end) {
    const PlacementId placement = keys_[begin].placement;
    Bounds box;
    for (end = begin; end < spheres_.size() && keys_[end].placement == placement; ++end) {
      const SphereRecord& s = spheres_[end];
      const Vector center{s.x, s.y, s.z}, r{s.radius, s.radius, s.radius};
      box.Include({center - r, center + r});
    }
    GrowAsPlaced(placement, &box);
    all.Include(box);
  }
  return all;
}

// The very steps of WorldBounds.
void StoredObjects::GrowAsPlaced(PlacementId placement, Bounds* box) const {
  const size_t levels = scene_->placement(placement).levels.size();
  for (size_t i = 0; i < 2 * levels; ++i) box->Grow(kEpsilon);
}

Quad StoredObjects::QuadAround(uint32_t object, const double center[3]) const {
  const Item& at = item(object);
  if (at.kind == kOtherLeaf) {
    float low[3], high[3];
    RoundOutwards(others_[at.index].box, center, low, high);
    return BoxAsQuad(low, high);
  }
  if (at.kind == kTriangleLeaf) {
    const TriangleShape& t = triangles_[at.index].shape;
    return rayshade::QuadAround(t.point, t.normal, t.offset, center,
                                std::numeric_limits<double>::infinity());
  }
  const FlatPolygon& p = polygons_[at.index];
  return rayshade::QuadAround(PointsOf(p), p.plane.normal, p.plane.offset, center, RoomOf(object));
}

// How much larger a polygon's box is than its points'; infinite where the box does not matter.
double StoredObjects::RoomOf(uint32_t object) const {
  if (polygons_[item(object).index].planar) return std::numeric_limits<double>::infinity();
  return growth_[key(object).placement];
}

void StoredObjects::CutPolygons(const double center[3], std::vector<float>* parts) {
  for (uint32_t i = 0; i < items_.size(); ++i) {
    if (items_[i].kind != kPolygonLeaf) continue;
    FlatPolygon& p = polygons_[items_[i].index];
    const std::span<const Vector> points = PointsOf(p);
    if (QuadIsObject(points, p.plane.normal)) continue;
    std::vector<Quad> quads;
    for (const PolygonPart& part : CutIntoParts(points, p.plane.normal)) {
      Vector corner[4];
      for (uint32_t k = 0; k < part.count; ++k) corner[k] = points[part.corner[k]];
      quads.push_back(rayshade::QuadAround({corner, part.count}, p.plane.normal, p.plane.offset,
                                           center, RoomOf(sphere_count() + i)));
    }
    p.first_part = static_cast<uint32_t>(parts->size() / kQuadRows);
    p.part_count = static_cast<uint32_t>(quads.size());
    parts->resize(parts->size() + kQuadRows * quads.size());
    for (size_t k = 0; k < quads.size(); k += kLeafSize) {
      const size_t count = std::min<size_t>(kLeafSize, quads.size() - k);
      WriteQuads({quads.data() + k, count}, parts->data() + kQuadRows * (p.first_part + k));
    }
  }
  parts->resize(parts->size() + kLeafSize);  // kernels load eight numbers from the last row
}

GeomSpec StoredObjects::SpecOf(uint32_t object) const {
  if (is_sphere(object)) return sphere(object);
  const Item& at = item(object);
  if (at.kind == kTriangleLeaf) {
    const FlatTriangle& t = triangles_[at.index];
    return TriangleSpec{{t.shape.point[0], t.shape.point[1], t.shape.point[2]}, t.flip};
  }
  if (at.kind == kPolygonLeaf) {
    const FlatPolygon& p = polygons_[at.index];
    const std::span<const Vector> points = PointsOf(p);
    return PolygonSpec{{points.begin(), points.end()}, p.flip};
  }
  const OtherObject& other = others_[at.index];
  return other.spec ? *other.spec : GeomSpec{};
}

FlatObjects StoredObjects::flat() const {
  return {items_.data(), triangles_.data(), polygons_.data(), points_.data(), nullptr, nullptr};
}

size_t StoredObjects::bytes() const {
  size_t bytes = sizeof *this + spheres_.bytes() + keys_.bytes() + item_keys_.bytes() +
                 items_.capacity() * sizeof(Item) + triangles_.capacity() * sizeof(FlatTriangle) +
                 polygons_.capacity() * sizeof(FlatPolygon) + points_.capacity() * sizeof(Vector) +
                 others_.capacity() * sizeof(OtherObject) + growth_.capacity() * sizeof(double) +
                 leaf_begins.bytes();
  for (const OtherObject& other : others_) {
    if (other.spec) bytes += sizeof(GeomSpec);
    if (other.geom) bytes += other.geom->bytes();
  }
  return bytes;
}

}  // namespace rayshade
