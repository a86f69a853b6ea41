// Spawning, gathering and shading in a trace process [RJ s.2, s.4]; see trace_impl.h.
#include <algorithm>

#include "parallel/trace_impl.h"
#include "rayshade/common/check.h"

namespace rayshade::parallel {

// A shadow ray has come to its end: what arrives of the light. False: nothing.
bool TraceProcess::Impl::Arrives(CellTracer::Shadow* shadow) {
  const bool arrives = [&] {
    if (shadow->blocked) return false;
    if (shadow->crossings == nullptr || shadow->crossings->empty()) return true;
    if (!scene->settings().shadow_transparency) return false;
    const std::optional<Color> rest = FoldCrossings(shadow->crossings, shadow->shadow->color);
    if (rest) shadow->shadow->color = *rest;
    return rest.has_value();
  }();
  counts.shadow_hits += !arrives;
  return arrives;
}

// Shades the batch of resolved hits: shadow rays are traced here, where they are spawned [RJ s.4].
void TraceProcess::Impl::ShadeHits(Outbox* outbox) {
  if (batch.empty()) return;
  counts.hits += batch.size();
  std::vector<uint32_t>& first = first_shadow;
  first.clear();
  TraceShadows(&first);
  for (size_t i = 0; i < batch.size(); ++i) {
    const size_t begin = first[i], count = first[i + 1] - begin;
    if (std::any_of(halted.begin() + begin, halted.begin() + begin + count,
                    [](CellId c) { return c != kNoCell; })) {
      PutAside(i, first, outbox);
      continue;
    }
    Lit(batch.bundle.rays[i], batch.media(i), distances[i], resolved[i],
        std::span(shadows).subspan(begin, count), std::span(arrived).subspan(begin, count),
        batch.travel[i].back, outbox);
  }
  batch.clear();
  resolved.clear();
  distances.clear();
}

// The shadow rays of the batch, light by light: towards one light they form a pyramid. (*first)[i]
// … (*first)[i + 1] are those of hit i.
void TraceProcess::Impl::TraceShadows(std::vector<uint32_t>* first) {
  shadows.clear();
  for (size_t i = 0; i < batch.size(); ++i) {
    first->push_back(static_cast<uint32_t>(shadows.size()));
    SpawnShadows(*scene, batch.bundle.rays[i], resolved[i], &shadows, &counts);
  }
  first->push_back(static_cast<uint32_t>(shadows.size()));
  arrived.assign(shadows.size(), 1);
  halted.assign(shadows.size(), kNoCell);
  crossings.assign(scene->any_transparent ? shadows.size() : 0, {});

  std::vector<uint32_t>& next = next_shadow;
  next.assign(first->begin(), first->end() - 1);
  std::vector<CellTracer::Shadow>& some = light_shadows;
  std::vector<uint32_t>& which = of_light;
  for (uint32_t light = 0; light < scene->lights.size(); ++light) {
    some.clear();
    which.clear();
    for (size_t i = 0; i < batch.size(); ++i) {
      const uint32_t s = next[i];
      if (s == (*first)[i + 1] || shadows[s].light != light) continue;
      ++next[i];
      if (!shadows[s].traced) continue;
      CellTracer::Shadow& shadow = some.emplace_back();
      shadow.shadow = &shadows[s];
      if (scene->any_transparent) shadow.crossings = &crossings[s];
      which.push_back(s);
    }
    if (some.empty()) continue;
    tracer->Shadows(some, &counts);
    for (size_t k = 0; k < some.size(); ++k) {
      const uint32_t s = which[k];
      halted[s] = some[k].halt.cell;
      if (halted[s] == kNoCell) arrived[s] = Arrives(&some[k]);
    }
  }
}

// Hit i of the batch waits for cells that its shadow rays need, or for the results of those that
// travel.
void TraceProcess::Impl::PutAside(size_t i, std::span<const uint32_t> first, Outbox* outbox) {
  uint32_t slot;
  if (free_waiting_shades.empty()) {
    slot = static_cast<uint32_t>(waiting_shades.size());
    waiting_shades.emplace_back();
  } else {
    slot = free_waiting_shades.back();
    free_waiting_shades.pop_back();
  }
  auto shade = std::make_unique<WaitingShade>();
  shade->ray = batch.bundle.rays[i];
  const auto media = batch.media(i);
  shade->media.assign(media.begin(), media.end());
  shade->distance = distances[i];
  shade->back = batch.travel[i].back;
  shade->hit = resolved[i];
  for (uint32_t s = first[i]; s < first[i + 1]; ++s) {
    shade->shadows.push_back(shadows[s]);
    shade->arrived.push_back(arrived[s]);
    if (halted[s] != kNoCell) ++shade->unknown;
    if (halted[s] != kNoCell && options.shadows == Shadows::kTravel) {
      shade->arrived.back() = kUnknown;
      CellTracer::Shadow shadow;
      shadow.shadow = &shadows[s];
      if (scene->any_transparent) shadow.crossings = &crossings[s];
      shadow.halt.cell = halted[s];
      SendShadow({self, uint64_t{slot} << 32 | (s - first[i])}, shadow, outbox);
      continue;
    }
    if (scene->any_transparent) shade->crossings.push_back(std::move(crossings[s]));
    if (halted[s] == kNoCell) continue;
    WaitFor(halted[s]).shadows.emplace_back(slot, s - first[i]);
  }
  waiting_shades[slot] = std::move(shade);
}

// Shadow rays go on in a cell that has just arrived.
void TraceProcess::Impl::ResumeShadows(const std::vector<std::pair<uint32_t, uint32_t>>& waiters,
                                       CellId cell, Outbox* outbox) {
  std::vector<CellTracer::Shadow> some(waiters.size());
  for (size_t k = 0; k < waiters.size(); ++k) {
    WaitingShade& shade = *waiting_shades[waiters[k].first];
    some[k].shadow = &shade.shadows[waiters[k].second];
    if (scene->any_transparent) some[k].crossings = &shade.crossings[waiters[k].second];
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
    shade.arrived[s] = Arrives(&some[k]);
    if (--shade.unknown == 0) FinishWaiting(slot, outbox);
  }
}

// The last shadow ray of a waiting hit is decided.
void TraceProcess::Impl::FinishWaiting(uint32_t slot, Outbox* outbox) {
  const std::unique_ptr<WaitingShade> done = std::move(waiting_shades[slot]);
  free_waiting_shades.push_back(slot);
  Lit(done->ray, done->media, done->distance, done->hit, done->shadows, done->arrived, done->back,
      outbox);
}

// All shadow rays of a hit are decided: lights are folded, secondary rays spawned.
void TraceProcess::Impl::Lit(const Ray& ray, std::span<const Medium> media, double distance,
                             const SurfaceHit& hit, std::span<const ShadowRay> of_hit,
                             std::span<const uint8_t> of_hit_arrived, const ReturnAddress& back,
                             Outbox* outbox) {
  const Color lights = ShadeLights(*scene, ray, hit, of_hit, of_hit_arrived);
  ++counts.shades;
  transmitted.clear();
  reflected.clear();
  Secondary secondary;
  SpawnSecondary(*scene, ray, media, hit, &transmitted, &reflected, &secondary);
  if (transmitted.empty() && reflected.empty()) {
    Deliver(back, ray.kind, Shade(*scene, ray, media.empty(), distance, lights, secondary, {}, {}),
            outbox);
    return;
  }
  const uint64_t slot = pending.Allocate();
  PendingIntersection& p = pending.at(slot);
  p.in_air = media.empty();
  p.back = back;
  p.kind = ray.kind;
  p.distance = distance;
  p.lights = lights;
  p.secondary = secondary;
  if (!scene->spec.atmosphere.effects.empty()) p.ray = ray;
  p.reflected_waits = !transmitted.empty() && !reflected.empty();
  if (transmitted.empty()) {
    Launch(reflected, {self, slot << 1 | 1});
    return;
  }
  if (p.reflected_waits) p.waiting = reflected;
  Launch(transmitted, {self, slot << 1});
}

// A secondary ray starts here, where it was spawned.
void TraceProcess::Impl::Launch(const RayBundle& one, const ReturnAddress& back) {
  const Ray& ray = one.rays[0];
  if (ray.kind == RayKind::kReflected) {
    ++counts.reflected_rays;
  } else {
    ++counts.refracted_rays;
  }
  ++statistics.data_rays;
  Travel travel;
  travel.back = back;
  queue.Push(ray, std::span(one.media).subspan(ray.media_begin, ray.media_count), travel);
}

void TraceProcess::Impl::Deliver(const ReturnAddress& back, RayKind kind, const RayResult& result,
                                 Outbox* outbox) {
  if (kind == RayKind::kPrimary) {
    packer->AddPixel({back.token, result.color, result.hit}, outbox);
  } else if (back.process == self) {
    TakeResult(back.token, result, outbox);
  } else {
    packer->AddResult(back.process, {back.token, result.color, result.distance, result.hit},
                      outbox);
  }
}

// A result for a slot of a pending intersection. Token: slot * 2 + (0: transmitted, 1: reflected).
void TraceProcess::Impl::TakeResult(uint64_t token, const RayResult& result, Outbox* outbox) {
  const uint64_t slot = token >> 1;
  PendingIntersection& p = pending.at(slot);
  if (p.reflected_waits) {
    p.transmitted = result;
    p.reflected_waits = false;
    Launch(p.waiting, {self, slot << 1 | 1});
    return;
  }
  const bool both = p.secondary.transmitted.wanted && p.secondary.reflected.wanted;
  const RayResult shaded = Shade(*scene, p.ray, p.in_air, p.distance, p.lights, p.secondary,
                                 both ? p.transmitted : result, result);
  const ReturnAddress back = p.back;
  const RayKind kind = p.kind;
  pending.Free(slot);
  Deliver(back, kind, shaded, outbox);
}

}  // namespace rayshade::parallel
