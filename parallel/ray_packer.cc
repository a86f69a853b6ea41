// Packing; see ray_packer.h.
#include "parallel/ray_packer.h"

namespace rayshade::parallel {

namespace {

// What fits into one fragment of PVM (4080 bytes): a ray takes about 130 bytes, a result 41.
constexpr size_t kRaysPerPack = 30;
constexpr size_t kResultsPerPack = 98;

}  // namespace

template <class Message>
void RayPacker::SendRays(ProcessId to, RayQueue* rays, Outbox* outbox) {
  Message message;
  message.bundle = std::move(rays->bundle);
  message.travel = std::move(rays->travel);
  outbox->Send(to, Encode(message));
  rays->clear();
}

void RayPacker::SendResults(ProcessId to, Pack* pack, Outbox* outbox) {
  if (to == kHost) {
    outbox->Send(to, Encode(PixelResults{std::move(pack->results)}));
  } else {
    outbox->Send(to, Encode(RayResults{std::move(pack->results)}));
  }
  pack->results.clear();
}

void RayPacker::AddRay(ProcessId to, const Ray& ray, std::span<const Medium> media,
                       const Travel& travel, Outbox* outbox) {
  RayQueue& rays = packs_[to].rays;
  rays.Push(ray, media, travel);
  if (rays.size() >= kRaysPerPack) SendRays<RayTask>(to, &rays, outbox);
}

void RayPacker::AddIntersection(ProcessId to, const Ray& ray, std::span<const Medium> media,
                                const Travel& travel, Outbox* outbox) {
  RayQueue& rays = packs_[to].intersections;
  rays.Push(ray, media, travel);
  if (rays.size() >= kRaysPerPack) SendRays<IntersectionTask>(to, &rays, outbox);
}

void RayPacker::AddResult(ProcessId to, const ResultItem& result, Outbox* outbox) {
  Pack& pack = packs_[to];
  pack.results.push_back(result);
  if (pack.results.size() >= kResultsPerPack) SendResults(to, &pack, outbox);
}

void RayPacker::Flush(Outbox* outbox) {
  for (size_t i = 0; i < packs_.size(); ++i) {
    const ProcessId to = static_cast<ProcessId>(i);
    Pack& pack = packs_[i];
    if (!pack.rays.empty()) SendRays<RayTask>(to, &pack.rays, outbox);
    if (!pack.intersections.empty()) SendRays<IntersectionTask>(to, &pack.intersections, outbox);
    if (!pack.results.empty()) SendResults(to, &pack, outbox);
  }
}

size_t RayPacker::bytes() const {
  size_t bytes = packs_.size() * sizeof(Pack);
  for (const Pack& p : packs_) {
    bytes += p.rays.bytes() + p.intersections.bytes() + p.results.size() * sizeof(ResultItem);
  }
  return bytes;
}

}  // namespace rayshade::parallel
