// Shadow rays that travel (--shadows travel): each goes from owner to owner of the cells on its
// way, as every other ray of the data-parallel schedule does [RJ s.2], until it is blocked or at
// its light; the result goes back to the hit that waits for it. See trace_impl.h.
//
// A hit has at most one message on its way for each of its shadow rays, so the host's limit on
// primary rays bounds them as well.
#include <algorithm>
#include <cmath>

#include "parallel/trace_impl.h"

namespace rayshade::parallel {

// To the owner of the cell in which it halts. The crossings move out of it.
void TraceProcess::Impl::SendShadow(const ReturnAddress& back, const CellTracer::Shadow& shadow,
                                    const Color& color, Outbox* outbox) {
  ShadowTravel travel;
  travel.back = back;
  travel.resume = shadow.halt.cell;
  travel.ray = *shadow.ray;
  travel.limit = shadow.limit;
  travel.color = color;
  if (shadow.crossings != nullptr) travel.crossings = std::move(*shadow.crossings);
  ++statistics.forwarded_rays;
  packer->AddShadow(tree.cell(travel.resume).owner, std::move(travel), outbox);
}

void TraceProcess::Impl::On(ProcessId, ShadowTask& message, Outbox*) {
  for (const ShadowTravel& travel : message.rays) {
    if (travel.resume >= tree.size()) throw WireError("a shadow ray that goes on in no cell");
    if (travel.back.process == kHost || travel.back.process > options.processes)
      throw WireError("a shadow ray of no process");
    if (travel.ray.kind != RayKind::kShadow || travel.ray.media_count != 0)
      throw WireError("a shadow ray that is none");
    for (const ShadowCrossing& c : travel.crossings)
      if (!std::isfinite(c.distance)) throw WireError("a shadow ray that crosses nowhere");
  }
  statistics.data_rays += message.rays.size();
  std::move(message.rays.begin(), message.rays.end(), std::back_inserter(shadow_tasks));
}

void TraceProcess::Impl::TraceShadowTasks(Outbox* outbox) {
  const size_t count = std::min(kRaysPerStep, shadow_tasks.size());
  std::vector<CellTracer::Shadow> some(count);
  for (size_t k = 0; k < count; ++k) {
    ShadowTravel& travel = shadow_tasks[k];
    some[k].ray = &travel.ray;
    some[k].limit = travel.limit;
    if (scene->any_transparent) some[k].crossings = &travel.crossings;
    some[k].resume = travel.resume;
  }
  tracer->Shadows(some, &counts);
  for (size_t k = 0; k < count; ++k) {
    ShadowTravel& travel = shadow_tasks[k];
    if (some[k].halt.cell != kNoCell) {
      SendShadow(travel.back, some[k], travel.color, outbox);
      continue;
    }
    const bool arrives = Arrives(some[k].blocked, &travel.crossings, &travel.color);
    packer->AddShadowResult(travel.back.process, {travel.back.token, arrives, travel.color},
                            outbox);
  }
  shadow_tasks.erase(shadow_tasks.begin(),
                     shadow_tasks.begin() + static_cast<std::ptrdiff_t>(count));
}

// Token: number of the waiting hit, then which of its shadow rays, 32 bits each.
void TraceProcess::Impl::On(ProcessId, ShadowResults& message, Outbox* outbox) {
  for (const ShadowItem& item : message.results) {
    const uint64_t slot = item.token >> 32, s = item.token & 0xffffffff;
    if (slot >= waiting_shades.size() || waiting_shades[slot] == nullptr ||
        s >= waiting_shades[slot]->arrived.size() || waiting_shades[slot]->arrived[s] != kUnknown)
      throw WireError("a result for no shadow ray");
    WaitingShade& shade = *waiting_shades[slot];
    shade.arrived[s] = item.arrives;
    shade.shadows[s].color = item.color;
    if (--shade.unknown == 0) FinishWaiting(static_cast<uint32_t>(slot), outbox);
  }
}

}  // namespace rayshade::parallel
