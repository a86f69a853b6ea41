// Tracing and fetching in a trace process; see trace_impl.h.
#include <algorithm>

#include "parallel/trace_impl.h"
#include "rayshade/common/check.h"

namespace rayshade::parallel {

// Traces rays as far as this process can, and shades what they hit here.
void TraceProcess::Impl::TraceRays(const RayQueue& rays, Outbox* outbox) {
  for (size_t begin = 0; begin < rays.size(); begin += kRaysPerStep) {
    TraceSome(rays, begin, std::min(kRaysPerStep, rays.size() - begin), outbox);
    ShadeBatch(rays, outbox);
  }
}

// Each ray ends, goes to another process, or waits for a cell.
void TraceProcess::Impl::TraceSome(const RayQueue& rays, size_t begin, size_t count,
                                   Outbox* outbox) {
  hits.resize(count);
  halts.resize(count);
  tracer->Nearest(std::span(rays.bundle.rays).subspan(begin, count),
                  std::span(rays.travel).subspan(begin, count), hits, halts, &counts);
  for (size_t k = 0; k < count; ++k) {
    const size_t i = begin + k;
    if (k + PendingIntersections::kAhead < count)
      FetchAhead(rays.travel[i + PendingIntersections::kAhead].back);
    if (halts[k].cell != kNoCell) {
      GoOn(rays, i, hits[k], halts[k].cell, outbox);
    } else if (hits[k].found()) {
      OnHit(rays, i, hits[k], outbox);
    } else {
      Miss(rays.bundle.rays[i], rays.travel[i].back, outbox);
    }
  }
}

// A ray that cannot end here goes on in a cell that is not held.
void TraceProcess::Impl::GoOn(const RayQueue& rays, size_t i, const Hit& best, CellId cell,
                              Outbox* outbox) {
  Travel travel = rays.travel[i];
  travel.resume = cell;
  travel.best_distance = best.distance;
  travel.best_rank = best.rank;
  travel.own_done = !ForwardsRays(options.schedule);
  if (ForwardsRays(options.schedule)) {
    ++statistics.forwarded_rays;
    packer->AddRay(tree.cell(cell).owner, rays.bundle.rays[i], rays.media(i), travel, outbox);
  } else {
    WaitFor(cell).rays.Push(rays.bundle.rays[i], rays.media(i), travel);
    ++waiting_rays;
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
  Travel travel = rays.travel[i];
  travel.best_distance = found.distance;
  travel.best_rank = found.rank;
  if (TransfersHits(options.schedule)) {
    const ProcessId owner = tracer->OwnerAt(ray, found.distance);
    if (owner != self && owner != kHost) {
      packer->AddIntersection(owner, ray, rays.media(i), travel, outbox);
      return;
    }
  }
  if (found.set != nullptr) {
    AddToBatch(rays, i, found);
    return;
  }
  const Hit hit = tracer->Locate(ray, found.distance, found.rank, &counts);
  if (hit.set != nullptr) {
    AddToBatch(rays, i, hit);
    return;
  }
  WaitFor(tree.At(ray.origin + found.distance * ray.direction))
      .hits.Push(ray, rays.media(i), travel);
  ++waiting_rays;
}

void TraceProcess::Impl::AddToBatch(const RayQueue& rays, size_t i, const Hit& hit) {
  const size_t n = batch.size++;
  batch.rays[n] = static_cast<uint32_t>(i);
  batch.distances[n] = hit.distance;
  ResolveHit(*scene, rays.bundle.rays[i], hit, &path, &batch.surfaces[n]);
}

// Hits known by distance and rank: found by other processes on objects of this one, or met in a
// cell that was dropped since.
void TraceProcess::Impl::ShadeLocated(const RayQueue& rays, Outbox* outbox) {
  for (size_t begin = 0; begin < rays.size(); begin += kRaysPerStep) {
    const size_t end = std::min(begin + kRaysPerStep, rays.size());
    for (size_t i = begin; i < end; ++i) {
      const Travel& travel = rays.travel[i];
      Hit hit;
      if (ranks != nullptr) hit = ranks->Find(travel.best_distance, travel.best_rank);
      if (hit.set == nullptr) {
        hit = tracer->LocateHeld(rays.bundle.rays[i], travel.best_distance, travel.best_rank,
                                 &counts);
      }
      AddToBatch(rays, i, hit);
    }
    ShadeBatch(rays, outbox);
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
  objects_fetched += reply.parcel.objects.size();
  objects->Build();
  cache->Put(reply.cell, std::move(objects));
  const auto node = waiting.extract(reply.cell);
  WaitingForCell& waiters = node.mapped();
  waiting_rays -= waiters.rays.size() + waiters.hits.size();
  ShadeLocated(waiters.hits, outbox);
  TraceRays(waiters.rays, outbox);
  ResumeShadows(waiters.shadows, reply.cell, outbox);
}

}  // namespace rayshade::parallel
