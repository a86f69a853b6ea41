// Tracing and fetching in a trace process; see trace_impl.h.
#include <algorithm>

#include "parallel/trace_impl.h"
#include "rayshade/common/check.h"

namespace rayshade::parallel {

// Traces rays as far as this process can; each ends, goes to another process, or waits for a cell.
void TraceProcess::Impl::TraceStep(const RayQueue& rays, Outbox* outbox) {
  const size_t n = rays.size();
  hits.resize(n);
  halts.resize(n);
  tracer->Nearest(rays.bundle.rays, rays.travel, hits, halts, &counts);
  for (size_t i = 0; i < n; ++i) {
    const Ray& ray = rays.bundle.rays[i];
    Travel travel = rays.travel[i];
    if (halts[i].cell != kNoCell) {
      travel.resume = halts[i].cell;
      travel.best_distance = hits[i].distance;
      travel.best_rank = hits[i].rank;
      if (ForwardsRays(options.schedule)) {
        travel.own_done = false;
        ++statistics.forwarded_rays;
        packer->AddRay(tree.cell(halts[i].cell).owner, ray, rays.media(i), travel, outbox);
      } else {
        travel.own_done = true;
        WaitFor(halts[i].cell).rays.Push(ray, rays.media(i), travel);
        ++waiting_rays;
      }
    } else if (hits[i].found()) {
      OnHit(rays, i, hits[i], outbox);
    } else {
      Miss(ray, travel.back, outbox);
    }
  }
}

// "When no intersection is found during demand-driven tracing of primary rays, this result is
// returned directly to the host process" [RJ s.4]; where the air does nothing, the host knows the
// colour.
void TraceProcess::Impl::Miss(const Ray& ray, const ReturnAddress& back, Outbox* outbox) {
  if (ray.kind == RayKind::kPrimary && scene->spec.atmosphere.effects.empty()) {
    packer->AddVoid(back.token, outbox);
  } else {
    Deliver(back, ray.kind, ShadeMiss(*scene, ray, ray.media_count == 0), outbox);
  }
}

// A conclusive hit: shaded by the process that keeps the object, which may be this one.
void TraceProcess::Impl::OnHit(const RayQueue& rays, size_t i, const Hit& found, Outbox* outbox) {
  const Ray& ray = rays.bundle.rays[i];
  Hit hit = found;
  if (TransfersHits(options.schedule)) {
    const CellId cell = tree.At(ray.origin + hit.distance * ray.direction);
    const ProcessId owner = cell == kNoCell ? self : tree.cell(cell).owner;
    if (owner != self) {
      Travel travel = rays.travel[i];
      travel.best_distance = hit.distance;
      travel.best_rank = hit.rank;
      packer->AddIntersection(owner, ray, rays.media(i), travel, outbox);
      return;
    }
  }
  if (hit.set == nullptr) {
    hit = tracer->Locate(ray, hit.distance, hit.rank, &counts);
    if (hit.set == nullptr) {
      Travel travel = rays.travel[i];
      travel.best_distance = hit.distance;
      travel.best_rank = hit.rank;
      const CellId cell = tree.At(ray.origin + hit.distance * ray.direction);
      WaitFor(cell).hits.Push(ray, rays.media(i), travel);
      ++waiting_rays;
      return;
    }
  }
  batch.Push(ray, rays.media(i), rays.travel[i]);
  distances.push_back(hit.distance);
  ResolveHit(*scene, ray, hit, &path, &resolved.emplace_back());
}

// Hits known by distance and rank: found by other processes on objects of this one, or met in a
// cell that was dropped since.
void TraceProcess::Impl::LocateHits(const RayQueue& rays) {
  hits.resize(rays.size());
  tracer->LocateAll(rays.bundle.rays, rays.travel, hits, &counts);
  for (size_t i = 0; i < rays.size(); ++i) {
    batch.Push(rays.bundle.rays[i], rays.media(i), rays.travel[i]);
    distances.push_back(hits[i].distance);
    ResolveHit(*scene, rays.bundle.rays[i], hits[i], &path, &resolved.emplace_back());
  }
}

WaitingForCell& TraceProcess::Impl::WaitFor(CellId cell) {
  CHECK(!tracer->owns(cell));
  const auto [it, added] = waiting.try_emplace(cell);
  if (added) wanted_cells.push_back(cell);
  return it->second;
}

void TraceProcess::Impl::RequestCells(Outbox* outbox) {
  while (!wanted_cells.empty() && cells_requested + arrived_cells.size() < kCellsAhead) {
    outbox->Send(tree.cell(wanted_cells.front()).owner, Encode(CellRequest{wanted_cells.front()}));
    wanted_cells.pop_front();
    ++cells_requested;
  }
}

// A fetched cell enters the cache, and everything that waits for it goes on at once: each fetch
// brings each of its rays forward, however small the cache.
void TraceProcess::Impl::TakeCell(CellReply&& reply, Outbox* outbox) {
  auto objects = std::make_unique<ObjectSet>(scene.get());
  Install(reply.parcel, objects.get());
  objects->Build();
  cache->Put(reply.cell, std::move(objects));
  const auto node = waiting.extract(reply.cell);
  WaitingForCell& waiters = node.mapped();
  waiting_rays -= waiters.rays.size() + waiters.hits.size();
  LocateHits(waiters.hits);
  if (!waiters.rays.empty()) TraceStep(waiters.rays, outbox);
  ResumeShadows(waiters.shadows, reply.cell, outbox);
}

}  // namespace rayshade::parallel
