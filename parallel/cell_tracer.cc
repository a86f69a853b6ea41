// Bundles against held cells; see cell_tracer.h.
#include "parallel/cell_tracer.h"

#include <algorithm>
#include <cmath>

#include "rayshade/common/check.h"

namespace rayshade::parallel {

namespace {

// A known hit is searched for from so much in front of it, relatively.
constexpr double kLocateWindow = 1e-6;

}  // namespace

CellTracer::CellTracer(const Scene* scene, const CellTree* tree, ProcessId self,
                       const ObjectSet* own, ObjectCache* cache)
    : scene_(scene), tree_(tree), own_(own), cache_(cache), boxes_(tree->Boxes()), walk_(tree) {
  for (CellId c = 0; c < tree->size(); ++c) {
    const Cell& cell = tree->cell(c);
    // A cell without objects is held by everyone: there is nothing to hold.
    owned_.push_back(cell.owner == self || cell.resident || cell.objects == 0);
  }
  const auto& nodes = tree->nodes();
  all_owned_.resize(nodes.size());
  owners_.resize(nodes.size());
  for (size_t i = nodes.size(); i-- > 0;) {  // children come after their parents
    const CellNode& n = nodes[i];
    all_owned_[i] = n.axis == 3 ? owned_[n.low] : all_owned_[n.low] && all_owned_[n.high];
    if (n.axis == 3) {
      owners_[i] = tree->cell(n.low).owner;
    } else {
      owners_[i] = owners_[n.low] == owners_[n.high] ? owners_[n.low] : kHost;
    }
  }
}

size_t CellTracer::bytes() const {
  return tree_->bytes() + owned_.capacity() + all_owned_.capacity() +
         owners_.capacity() * sizeof(ProcessId) + boxes_.capacity() * sizeof(Bounds);
}

// Is the cell before the one in which the ray resumes, in the ray's order?
bool CellTracer::Before(const RayInterval& interval, CellId cell, const Ray& ray,
                        CellId resume) const {
  if (resume == kNoCell) return false;
  const double entry = Intersect(boxes_[resume], ray.origin, ray.direction).entry;
  return interval.entry < entry || (interval.entry == entry && cell < resume);
}

// Visits the cells on the ray's path that are not owned, in the ray's order, until visit returns
// false.
template <class Visit>
void CellTracer::Walk(const Ray& ray, double limit, Visit visit, OpCounts* counts) {
  const auto skip = [this](uint32_t node) { return all_owned_[node] != 0; };
  counts->cell_steps += walk_.Visit(ray.origin, ray.direction, limit, skip, visit);
}

// The cells that a pyramid meets and that are not owned.
std::vector<ClippedCell> CellTracer::ClipList(const Pyramid& pyramid, double limit) const {
  return PyraClip(*tree_, pyramid, limit, [this](uint32_t node) { return all_owned_[node] != 0; });
}

void CellTracer::Nearest(std::span<const Ray> rays, std::span<const Travel> travel,
                         std::span<Hit> hits, std::span<Halt> halts, OpCounts* counts) {
  const size_t n = rays.size();
  size_t fresh = 0;
  for (size_t i = 0; i < n; ++i) {
    hits[i] = Hit();
    hits[i].distance = travel[i].best_distance;
    hits[i].rank = travel[i].best_rank;
    halts[i] = Halt();
    fresh += !travel[i].own_done;
  }
  if (fresh == n) {
    own_->Nearest(rays, hits, counts);
  } else if (fresh > 0) {
    some_.clear();
    some_rays_.clear();
    some_hits_.clear();
    for (size_t i = 0; i < n; ++i) {
      if (travel[i].own_done) continue;
      some_.push_back(static_cast<uint32_t>(i));
      some_rays_.push_back(rays[i]);
      some_hits_.push_back(hits[i]);
    }
    own_->Nearest(some_rays_, some_hits_, counts);
    for (size_t k = 0; k < some_.size(); ++k) hits[some_[k]] = some_hits_[k];
  }
  if (all_owned_[0]) return;

  const Pyramid pyramid = Pyramid::Around(rays);
  if (n >= 8 && pyramid.narrow()) {
    NearestByClipList(pyramid, rays, travel, hits, halts, counts);
  } else {
    for (size_t i = 0; i < n; ++i) NearestByWalk(rays[i], travel[i], &hits[i], &halts[i], counts);
  }
  for (size_t i = 0; i < n; ++i) {
    if (hits[i].found() && hits[i].distance < halts[i].entry) halts[i] = Halt();
  }
}

void CellTracer::NearestByClipList(const Pyramid& pyramid, std::span<const Ray> rays,
                                   std::span<const Travel> travel, std::span<Hit> hits,
                                   std::span<Halt> halts, OpCounts* counts) {
  double limit = 0;
  rows_.Clear(rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    limit = std::max(limit, hits[i].distance);
    rows_.Set(i, rays[i].origin, rays[i].direction, hits[i].distance);
  }
  for (const ClippedCell& clipped : ClipList(pyramid, limit)) {
    ++counts->cell_steps;
    counts->cell_tests += rays.size();
    some_.clear();
    some_rays_.clear();
    some_hits_.clear();
    const ObjectSet* set = Searched(clipped.cell);
    rows_.ForEachMeeting(boxes_[clipped.cell], [&](size_t i) {
      if (set == nullptr && clipped.entry > halts[i].entry) return;
      const RayInterval interval =
          Intersect(boxes_[clipped.cell], rays[i].origin, rays[i].direction);
      if (interval.empty() || interval.exit < 0 || interval.entry > hits[i].distance ||
          Before(interval, clipped.cell, rays[i], travel[i].resume)) {
        return;
      }
      if (set != nullptr) {
        some_.push_back(static_cast<uint32_t>(i));
        some_rays_.push_back(rays[i]);
        some_hits_.push_back(hits[i]);
      } else if (interval.entry < halts[i].entry ||
                 (interval.entry == halts[i].entry && clipped.cell < halts[i].cell)) {
        halts[i] = {clipped.cell, interval.entry};
      }
    });
    if (set == nullptr || some_.empty()) continue;
    CountTrace(some_.size(), counts);
    set->Nearest(some_rays_, some_hits_, counts);
    for (size_t k = 0; k < some_.size(); ++k) {
      hits[some_[k]] = some_hits_[k];
      rows_.SetLimit(some_[k], some_hits_[k].distance);
    }
  }
  for (const Halt& halt : halts) cache_misses_ += halt.cell != kNoCell;
}

void CellTracer::NearestByWalk(const Ray& ray, const Travel& travel, Hit* hit, Halt* halt,
                               OpCounts* counts) {
  Walk(
      ray, hit->distance,
      [&](CellId cell, const RayInterval& interval) {
        if (interval.entry > hit->distance) return false;
        if (Before(interval, cell, ray, travel.resume)) return true;
        const ObjectSet* set = Searched(cell);
        if (set == nullptr) {
          ++cache_misses_;
          *halt = {cell, interval.entry};
          return false;
        }
        CountTrace(1, counts);
        set->Nearest({&ray, 1}, {hit, 1}, counts);
        return true;
      },
      counts);
}

Hit CellTracer::Locate(const Ray& ray, double distance, Rank rank, OpCounts* counts) {
  Hit hit;
  const auto find = [&](const ObjectSet& set) {
    hit = Hit();
    hit.distance = distance;
    hit.rank = rank + 1;  // the hit itself is the only one that comes before this
    set.Nearest({&ray, 1}, {&hit, 1}, counts);
    if (hit.distance != distance || hit.rank != rank) hit = Hit();
    return hit.found();
  };
  if (find(*own_)) return hit;
  const CellId cell = tree_->At(ray.origin + distance * ray.direction);
  CHECK(cell != kNoCell && !owned_[cell]);  // it would have been found
  if (const ObjectSet* set = cache_->Find(cell)) {
    CHECK(find(*set));
    return hit;
  }
  hit = Hit();
  hit.distance = distance;
  hit.rank = rank;
  return hit;
}

Hit CellTracer::LocateHeld(const Ray& ray, double distance, Rank rank, OpCounts* counts) {
  // Alone, the ray visits only what lies at the place of its hit.
  Ray near = ray;
  near.min_distance = std::max(ray.min_distance, distance * (1 - kLocateWindow));
  Hit hit;
  hit.distance = distance;
  hit.rank = rank + 1;  // the hit itself is the only one that comes before this
  own_->Nearest({&near, 1}, {&hit, 1}, counts);
  if (hit.distance == distance && hit.rank == rank) return hit;
  // A kind whose arithmetic depends on where the search begins: once more from there.
  hit = Locate(ray, distance, rank, counts);
  CHECK(hit.set != nullptr);
  return hit;
}

ProcessId CellTracer::OwnerAt(const Ray& ray, double distance) {
  const Vector point = ray.origin + distance * ray.direction;
  // Hits that follow each other mostly lie in one region. A border belongs to the upper one.
  Bounds& last = last_region_;
  if (last.low.x <= point.x && point.x < last.high.x && last.low.y <= point.y &&
      point.y < last.high.y && last.low.z <= point.z && point.z < last.high.z) {
    return owners_[last_node_];
  }
  if (!tree_->bounds().Contains(point)) return kHost;
  last = tree_->bounds();
  uint32_t node = 0;
  while (owners_[node] == kHost) {
    const CellNode& n = tree_->nodes()[node];
    const bool low = point[n.axis] < n.plane;
    (low ? last.high : last.low)[n.axis] = n.plane;
    node = low ? n.low : n.high;
  }
  last_node_ = node;
  return owners_[node];
}

// The shadow rays against one set: the opaque objects in it block, the transparent ones are noted.
void CellTracer::Cross(const ObjectSet& set, std::span<Shadow*> shadows, OpCounts* counts) {
  some_rays_.clear();
  limits_.clear();
  blocked_.assign(shadows.size(), 0);
  for (const Shadow* s : shadows) {
    some_rays_.push_back(*s->ray);
    limits_.push_back(s->limit);
  }
  crossed_.assign(scene_->any_transparent ? shadows.size() : 0, 0);
  set.Block(some_rays_, limits_, blocked_, crossed_, counts);
  for (size_t i = 0; i < shadows.size(); ++i) {
    Shadow& s = *shadows[i];
    s.blocked = blocked_[i] != 0;
    if (!s.blocked && s.crossings != nullptr && crossed_[i]) {
      CollectCrossings(*scene_, set, *s.ray, s.limit, s.crossings, counts);
    }
  }
}

void CellTracer::Shadows(std::span<Shadow> shadows, OpCounts* counts) {
  std::vector<Shadow*> active;
  for (Shadow& s : shadows) {
    s.halt = Halt();
    if (!s.own_done) active.push_back(&s);
  }
  if (!active.empty()) Cross(*own_, active, counts);
  if (all_owned_[0]) return;
  active.clear();
  Pyramid pyramid;
  for (Shadow& s : shadows) {
    if (s.blocked) continue;
    active.push_back(&s);
    pyramid.origins.Include(s.ray->origin);
    pyramid.directions.Include(s.ray->direction);
  }
  if (active.size() >= 8 && pyramid.narrow()) {
    ShadowsByClipList(pyramid, active, counts);
  } else {
    for (Shadow* s : active) ShadowByWalk(s, counts);
  }
  for (Shadow& s : shadows) {
    if (s.blocked) s.halt = Halt();
  }
}

void CellTracer::ShadowsByClipList(const Pyramid& pyramid, std::span<Shadow*> shadows,
                                   OpCounts* counts) {
  double limit = 0;
  rows_.Clear(shadows.size());
  for (size_t i = 0; i < shadows.size(); ++i) {
    limit = std::max(limit, shadows[i]->limit);
    rows_.Set(i, shadows[i]->ray->origin, shadows[i]->ray->direction, shadows[i]->limit);
  }
  std::vector<Shadow*> here;
  for (const ClippedCell& clipped : ClipList(pyramid, limit)) {
    ++counts->cell_steps;
    counts->cell_tests += shadows.size();
    here.clear();
    some_.clear();
    const ObjectSet* set = cache_->Find(clipped.cell);
    rows_.ForEachMeeting(boxes_[clipped.cell], [&](size_t i) {
      Shadow* const s = shadows[i];
      if (set == nullptr && clipped.entry > s->halt.entry) return;
      const Ray& ray = *s->ray;
      const RayInterval interval = Intersect(boxes_[clipped.cell], ray.origin, ray.direction);
      if (interval.empty() || interval.exit < 0 || interval.entry > s->limit ||
          Before(interval, clipped.cell, ray, s->resume)) {
        return;
      }
      if (set != nullptr) {
        here.push_back(s);
        some_.push_back(static_cast<uint32_t>(i));
      } else if (interval.entry < s->halt.entry ||
                 (interval.entry == s->halt.entry && clipped.cell < s->halt.cell)) {
        s->halt = {clipped.cell, interval.entry};
      }
    });
    if (set == nullptr || here.empty()) continue;
    CountTrace(here.size(), counts);
    Cross(*set, here, counts);
    for (size_t k = 0; k < here.size(); ++k) {
      if (here[k]->blocked) rows_.SetLimit(some_[k], -1);
    }
  }
  for (const Shadow* s : shadows) cache_misses_ += !s->blocked && s->halt.cell != kNoCell;
}

void CellTracer::FindForeign(const ShadowRows& rows, uint8_t* foreign, OpCounts* counts) {
  std::fill_n(foreign, rows.count, uint8_t{0});
  for (size_t begin = 0; begin < rows.count; begin += RayRows::kRow) {
    const size_t end = std::min<size_t>(begin + RayRows::kRow, rows.count);
    Pyramid pyramid;
    double limit = 0;
    size_t left = 0;
    rows_.Clear(RayRows::kRow);
    for (size_t i = begin; i < end; ++i) {
      if (rows.blocked[i]) continue;
      const Vector origin{rows.origin[0][i], rows.origin[1][i], rows.origin[2][i]};
      const Vector direction{rows.direction[0][i], rows.direction[1][i], rows.direction[2][i]};
      pyramid.origins.Include(origin);
      pyramid.directions.Include(direction);
      limit = std::max(limit, rows.limits[i]);
      rows_.Set(i - begin, origin, direction, rows.limits[i]);
      ++left;
    }
    if (left == 0) continue;
    for (const ClippedCell& clipped : ClipList(pyramid, limit)) {
      ++counts->cell_steps;
      counts->cell_tests += left;
      rows_.ForEachMeeting(boxes_[clipped.cell], [&](size_t i) {
        foreign[begin + i] = 1;
        rows_.SetLimit(i, -1);
        --left;
      });
      if (left == 0) break;
    }
  }
}

void CellTracer::ShadowByWalk(Shadow* shadow, OpCounts* counts) {
  Walk(
      *shadow->ray, shadow->limit,
      [&](CellId cell, const RayInterval& interval) {
        if (Before(interval, cell, *shadow->ray, shadow->resume)) return true;
        const ObjectSet* set = cache_->Find(cell);
        if (set == nullptr) {
          ++cache_misses_;
          shadow->halt = {cell, interval.entry};
          return false;
        }
        CountTrace(1, counts);
        Shadow* one[] = {shadow};
        Cross(*set, one, counts);
        return !shadow->blocked;
      },
      counts);
}

}  // namespace rayshade::parallel
