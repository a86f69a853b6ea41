// Spawning, gathering and shading in a trace process [RJ s.2, s.4]; see trace_impl.h.
#include <algorithm>

#include "parallel/trace_impl.h"
#include "rayshade/common/check.h"

namespace rayshade::parallel {

// Shades the hits of a step: shadow rays are traced here, where they are spawned, light by light
// [RJ s.4]; secondary rays enter the queue.
void TraceProcess::Impl::ShadeBatch(const RayQueue& rays, Outbox* outbox) {
  const size_t count = std::exchange(batch.size, 0);
  counts.hits += count;
  for (size_t h = 0; h < count; ++h) {
    batch.lights[h] = ShadeAmbient(*scene, batch.surfaces[h]);
    batch.aside[h] = kNotAside;
  }
  if (count > 0) {
    rows->Set(*scene, rays.bundle.rays, {batch.surfaces.data(), count}, {batch.rays.data(), count},
              {batch.lights.data(), count});
  }
  for (uint32_t light = 0; count > 0 && light < scene->lights.size(); ++light) {
    Illuminate(rays, count, light, outbox);
  }
  if (count > 0) rows->Finish();
  for (size_t h = 0; h < count; ++h) {
    if (h + PendingIntersections::kAhead < count)
      FetchAhead(rays.travel[batch.rays[h + PendingIntersections::kAhead]].back);
    if (batch.aside[h] != kNotAside) continue;
    const size_t i = batch.rays[h];
    Lit(rays.bundle.rays[i], rays.media(i), batch.distances[h], batch.surfaces[h], batch.lights[h],
        rays.travel[i].back, outbox);
  }
}

// One light for all hits of the batch: its shadow rays form a pyramid.
void TraceProcess::Impl::Illuminate(const RayQueue& rays, size_t count, uint32_t light,
                                    Outbox* outbox) {
  rows->Clear();
  size_t done = 0;
  if (HitRows::Suit(*scene, *scene->lights[light])) {
    done = IlluminateByRows(rays, count, light);
  }
  const size_t traced = rows->all_done() ? done : SampleRest(rays, count, light, done);
  if (traced == 0) return;
  ShadowBatch& s = shadows;
  TraceShadows(done, traced);
  for (size_t k = 0; k < traced; ++k) {
    if (s.halted[k] != kNoCell) {
      Wait(rays, k, outbox);
      continue;
    }
    if (Arrives(s.blocked[k] != 0, &s.crossings[k], &s.samples[k].color))
      Fold(rays, s.hits[k], s.samples[k]);
  }
}

// The hits that rows can do, against the objects that are held for good. Those that this does not
// decide, since something transparent or a cell that is not held may be in the way, become shadow
// rays, of which there are as many as it returns.
size_t TraceProcess::Impl::IlluminateByRows(const RayQueue& rays, size_t count, uint32_t number) {
  const Light& light = *scene->lights[number];
  rows->Trace(*scene, *own, light, &counts);
  ShadowBatch& s = shadows;
  size_t undecided = 0;
  const auto leave_undecided = [&](size_t h) {
    rows->TakeOut(h);
    LightSample& sample = s.samples[undecided];
    sample = rows->Sample(light, number, h);
    MakeShadowRay(rays.bundle.rays[batch.rays[h]], batch.surfaces[h], sample.toward,
                  &s.rays[undecided]);
    s.limits[undecided] = sample.limit;
    s.hits[undecided] = static_cast<uint32_t>(h);
    s.crossed[undecided] = rows->crossed(h);
    ++undecided;
  };
  if (!tracer->owns_all()) {
    uint8_t foreign[kRaysPerStep];
    tracer->FindForeign(rows->shadow_rays(light), foreign, &counts);
    rows->ForEachUnblocked(foreign, leave_undecided);
    // Where an earlier light is waited for, later ones are kept.
    for (size_t h = 0; h < count; ++h) {
      if (batch.aside[h] != kNotAside && !rows->blocked(h)) leave_undecided(h);
    }
  }
  if (scene->any_transparent) rows->ForEachCrossed(leave_undecided);
  rows->AddUp(*own, light);
  return undecided;
}

// The light's samples of the other hits, behind the `traced` shadow rays that there are. Returns
// how many there are then.
size_t TraceProcess::Impl::SampleRest(const RayQueue& rays, size_t count, uint32_t light,
                                      size_t traced) {
  ShadowBatch& s = shadows;
  for (size_t h = 0; h < count; ++h) {
    if (rows->done(h)) continue;
    LightSample& sample = s.samples[traced];
    if (!SampleLight(*scene, light, rays.bundle.rays[batch.rays[h]], batch.surfaces[h], &sample,
                     &s.rays[traced], &counts)) {
      continue;
    }
    if (!sample.traced) {
      Fold(rays, h, sample);
      continue;
    }
    s.limits[traced] = sample.limit;
    s.hits[traced] = static_cast<uint32_t>(h);
    s.crossed[traced] = 0;
    ++traced;
  }
  return traced;
}

// Follows the shadow rays of the batch as far as this process can; the first `done` have passed the
// objects that are held for good.
void TraceProcess::Impl::TraceShadows(size_t done, size_t count) {
  ShadowBatch& s = shadows;
  std::fill_n(s.blocked.begin(), count, uint8_t{0});
  std::fill_n(s.halted.begin(), count, kNoCell);
  const size_t rest = count - done, crossings = scene->any_transparent ? count : 0;
  own->Block({s.rays.data() + done, rest}, {s.limits.data() + done, rest},
             {s.blocked.data() + done, rest}, {s.crossed.data() + done, crossings > 0 ? rest : 0},
             &counts);
  for (size_t k = 0; k < crossings; ++k) {
    s.crossings[k].clear();
    if (s.blocked[k] || !s.crossed[k]) continue;
    CollectCrossings(*scene, *own, s.rays[k], s.limits[k], &s.crossings[k], &counts);
  }
  if (tracer->owns_all()) return;

  // What is held for good is done: on through cells that others own.
  halting.clear();
  halting_numbers.clear();
  for (size_t k = 0; k < count; ++k) {
    if (s.blocked[k]) continue;
    CellTracer::Shadow& shadow = halting.emplace_back();
    shadow.ray = &s.rays[k];
    shadow.limit = s.limits[k];
    if (crossings > 0) shadow.crossings = &s.crossings[k];
    shadow.own_done = true;
    halting_numbers.push_back(static_cast<uint32_t>(k));
  }
  tracer->Shadows(halting, &counts);
  for (size_t n = 0; n < halting.size(); ++n) {
    s.blocked[halting_numbers[n]] = halting[n].blocked;
    s.halted[halting_numbers[n]] = halting[n].halt.cell;
  }
}

// A shadow ray has come to its end. False: nothing arrives; else *color becomes what does.
bool TraceProcess::Impl::Arrives(bool blocked, std::vector<ShadowCrossing>* crossings,
                                 Color* color) {
  const bool arrives = [&] {
    if (blocked) return false;
    if (crossings->empty()) return true;
    if (!scene->settings().shadow_transparency) return false;
    const std::optional<Color> rest = FoldCrossings(crossings, *color);
    if (rest) *color = *rest;
    return rest.has_value();
  }();
  counts.shadow_hits += !arrives;
  return arrives;
}

// A light arrives at a hit: it is folded, or kept where an earlier one is not decided.
void TraceProcess::Impl::Fold(const RayQueue& rays, size_t hit, const LightSample& sample) {
  if (batch.aside[hit] == kNotAside) {
    rows->Add(hit, sample, sample.color);
    return;
  }
  WaitingShade& shade = Aside(rays, hit);
  static_cast<LightSample&>(shade.shadows.emplace_back()) = sample;
  shade.arrived.push_back(true);
  shade.crossings.emplace_back();
}

// The hit's waiting shade; made if there is none.
WaitingShade& TraceProcess::Impl::Aside(const RayQueue& rays, size_t hit) {
  uint32_t& slot = batch.aside[hit];
  if (slot != kNotAside) return *waiting_shades[slot];
  if (free_waiting_shades.empty()) {
    slot = static_cast<uint32_t>(waiting_shades.size());
    waiting_shades.emplace_back();
  } else {
    slot = free_waiting_shades.back();
    free_waiting_shades.pop_back();
  }
  waiting_shades[slot] = std::make_unique<WaitingShade>();
  WaitingShade& shade = *waiting_shades[slot];
  const size_t i = batch.rays[hit];
  shade.ray = rays.bundle.rays[i];
  const auto media = rays.media(i);
  shade.media.assign(media.begin(), media.end());
  shade.distance = batch.distances[hit];
  shade.back = rays.travel[i].back;
  shade.hit = batch.surfaces[hit];
  shade.lights = rows->sum(hit);
  return shade;
}

// A shadow ray needs a cell that is not held: its hit waits for the cell, or for the result where
// shadow rays travel.
void TraceProcess::Impl::Wait(const RayQueue& rays, size_t shadow, Outbox* outbox) {
  ShadowBatch& s = shadows;
  WaitingShade& shade = Aside(rays, s.hits[shadow]);
  ShadowRay& ray = shade.shadows.emplace_back();
  static_cast<LightSample&>(ray) = s.samples[shadow];
  ray.ray = s.rays[shadow];
  const uint32_t slot = batch.aside[s.hits[shadow]];
  const uint32_t number = static_cast<uint32_t>(shade.shadows.size() - 1);
  ++shade.unknown;
  if (options.shadows == Shadows::kTravel) {
    shade.arrived.push_back(kUnknown);
    shade.crossings.emplace_back();
    CellTracer::Shadow travelling;
    travelling.ray = &ray.ray;
    travelling.limit = ray.limit;
    travelling.crossings = &s.crossings[shadow];
    travelling.halt.cell = s.halted[shadow];
    SendShadow({self, uint64_t{slot} << 32 | number}, travelling, ray.color, outbox);
    return;
  }
  shade.arrived.push_back(0);
  shade.crossings.push_back(std::exchange(s.crossings[shadow], {}));
  WaitFor(s.halted[shadow]).shadows.emplace_back(slot, number);
}

// Shadow rays go on in a cell that has just arrived.
void TraceProcess::Impl::ResumeShadows(const std::vector<std::pair<uint32_t, uint32_t>>& waiters,
                                       CellId cell, Outbox* outbox) {
  std::vector<CellTracer::Shadow> some(waiters.size());
  for (size_t k = 0; k < waiters.size(); ++k) {
    WaitingShade& shade = *waiting_shades[waiters[k].first];
    const uint32_t s = waiters[k].second;
    some[k].ray = &shade.shadows[s].ray;
    some[k].limit = shade.shadows[s].limit;
    if (scene->any_transparent) some[k].crossings = &shade.crossings[s];
    some[k].resume = cell;
    some[k].own_done = true;
  }
  if (!some.empty()) tracer->Shadows(some, &counts);
  for (size_t k = 0; k < waiters.size(); ++k) {
    const auto [slot, s] = waiters[k];
    WaitingShade& shade = *waiting_shades[slot];
    if (some[k].halt.cell != kNoCell) {
      WaitFor(some[k].halt.cell).shadows.emplace_back(slot, s);
      continue;
    }
    shade.arrived[s] = Arrives(some[k].blocked, &shade.crossings[s], &shade.shadows[s].color);
    if (--shade.unknown == 0) FinishWaiting(slot, outbox);
  }
}

// The last shadow ray of a waiting hit is decided.
void TraceProcess::Impl::FinishWaiting(uint32_t slot, Outbox* outbox) {
  const std::unique_ptr<WaitingShade> done = std::move(waiting_shades[slot]);
  free_waiting_shades.push_back(slot);
  for (size_t l = 0; l < done->shadows.size(); ++l) {
    if (!done->arrived[l]) continue;
    AddLight(done->hit, done->shadows[l], done->shadows[l].color, &done->lights);
  }
  Lit(done->ray, done->media, done->distance, done->hit, done->lights, done->back, outbox);
}

// All lights of a hit are folded: secondary rays are spawned, into the queue.
void TraceProcess::Impl::Lit(const Ray& ray, std::span<const Medium> media, double distance,
                             const SurfaceHit& hit, const Color& lights, const ReturnAddress& back,
                             Outbox* outbox) {
  ++counts.shades;
  RayQueue& next = queue.OfDepth(ray.depth + 1u);
  const size_t before = next.size();
  Secondary secondary;
  SpawnSecondary(*scene, ray, media, hit, &next.bundle, &next.bundle, &secondary);
  if (next.bundle.size() == before) {
    Deliver(back, ray.kind, Folded(*scene, ray, media.empty(), distance, lights), outbox);
    return;
  }
  const uint64_t slot = pending.Allocate();
  PendingIntersection& p = pending.at(slot);
  p.in_air = media.empty();
  p.back = back;
  p.kind = ray.kind;
  p.distance = distance;
  p.color = lights;
  p.way = secondary.transmitted.wanted ? secondary.transmitted : secondary.reflected;
  if (!scene->spec.atmosphere.effects.empty()) pending.rest(&p).ray = ray;
  p.reflected_waits = next.bundle.size() == before + 2;
  if (p.reflected_waits) {
    PendingRest& rest = pending.rest(&p);
    rest.reflected = secondary.reflected;
    Ray& reflected = next.bundle.rays.back();
    rest.waiting.clear();
    const auto first = next.bundle.media.begin() + reflected.media_begin;
    rest.waiting.media.assign(first, next.bundle.media.end());
    next.bundle.media.erase(first, next.bundle.media.end());
    reflected.media_begin = 0;
    rest.waiting.rays.push_back(reflected);
    next.bundle.rays.pop_back();
  }
  const RayKind kind = next.bundle.rays.back().kind;
  next.travel.emplace_back().back = {self, slot << 1 | (kind == RayKind::kReflected)};
  CountLaunched(kind);
}

// A secondary ray starts here, where it was spawned.
void TraceProcess::Impl::CountLaunched(RayKind kind) {
  ++(kind == RayKind::kReflected ? counts.reflected_rays : counts.refracted_rays);
  ++statistics.data_rays;
}

void TraceProcess::Impl::Deliver(const ReturnAddress& back, RayKind kind, const RayResult& result,
                                 Outbox* outbox) {
  if (kind == RayKind::kPrimary) {
    packer->AddPixel({back.token, result.color}, result.hit, outbox);
  } else if (back.process == self) {
    TakeResult(back.token, result, outbox);
  } else {
    packer->AddResult(back.process, {back.token, result.color, result.distance}, outbox);
  }
}

// A result for a slot of a pending intersection. Token: slot * 2 + (0: transmitted, 1: reflected).
void TraceProcess::Impl::TakeResult(uint64_t token, const RayResult& result, Outbox* outbox) {
  const uint64_t slot = token >> 1;
  PendingIntersection& p = pending.at(slot);
  p.color += Weighted(p.way, result);
  if (p.reflected_waits) {
    p.reflected_waits = false;
    p.way = p.rest->reflected;
    Travel travel;
    travel.back = {self, slot << 1 | 1};
    queue.Push(p.rest->waiting.rays[0], p.rest->waiting.media, travel);
    CountLaunched(RayKind::kReflected);
    return;
  }
  static const Ray any;  // without an atmosphere
  const RayResult shaded =
      Folded(*scene, p.rest ? p.rest->ray : any, p.in_air, p.distance, p.color);
  const ReturnAddress back = p.back;
  const RayKind kind = p.kind;
  pending.Free(slot);
  Deliver(back, kind, shaded, outbox);
}

}  // namespace rayshade::parallel
