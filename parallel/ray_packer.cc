// Packing; see ray_packer.h.
#include "parallel/ray_packer.h"

#include <utility>

namespace rayshade::parallel {

namespace {

// A pack is full at about so many bytes; pixels, which no trace process waits for, at more: a
// message costs the host a turn on a processor that traces.
constexpr size_t kPackBytes = 16000, kPixelBytes = 40000;
// Voids take hardly any bytes, but the host waits for them: they are rays in flight.
constexpr size_t kVoids = 5000;
// What things take in a message, about.
constexpr size_t kRayBytes = 131, kShadowBytes = 160, kCrossingBytes = 50, kShadowResultBytes = 33;

}  // namespace

void RayPacker::Add(const Ray& ray, std::span<const Medium> media, const Travel& travel,
                    Rays* rays) {
  TravellingRays& content = rays->content;
  if (ray.kind == RayKind::kPrimary) {
    content.primary.push_back(
        {travel.back.token, travel.best_distance, travel.best_rank, travel.resume});
    rays->bytes += sizeof(PrimaryTravel);
    return;
  }
  Ray copy = ray;
  copy.media_begin = static_cast<uint32_t>(content.bundle.media.size());
  content.bundle.media.insert(content.bundle.media.end(), media.begin(), media.end());
  content.bundle.rays.push_back(copy);
  content.travel.push_back(travel);
  rays->bytes += kRayBytes + media.size() * sizeof(Medium);
}

template <class Message>
void RayPacker::SendRays(ProcessId to, Rays* rays, Outbox* outbox) {
  if (rays->bytes == 0) return;
  Message message;
  static_cast<TravellingRays&>(message) = std::exchange(rays->content, {});
  rays->bytes = 0;
  outbox->Send(to, Encode(message));
}

void RayPacker::SendPixels(Outbox* outbox) {
  if (pixels_.voids.empty() && pixels_.misses.empty() && pixels_.hits.empty()) return;
  outbox->Send(kHost, Encode(pixels_));
  pixels_.voids.clear();
  pixels_.misses.clear();
  pixels_.hits.clear();
}

void RayPacker::AddRay(ProcessId to, const Ray& ray, std::span<const Medium> media,
                       const Travel& travel, Outbox* outbox) {
  Rays& rays = packs_[to].rays;
  Add(ray, media, travel, &rays);
  if (rays.bytes >= kPackBytes) SendRays<RayTask>(to, &rays, outbox);
}

void RayPacker::AddIntersection(ProcessId to, const Ray& ray, std::span<const Medium> media,
                                const Travel& travel, Outbox* outbox) {
  Rays& rays = packs_[to].intersections;
  Add(ray, media, travel, &rays);
  if (rays.bytes >= kPackBytes) SendRays<IntersectionTask>(to, &rays, outbox);
}

void RayPacker::AddResult(ProcessId to, const ResultItem& result, Outbox* outbox) {
  std::vector<ResultItem>& results = packs_[to].results;
  results.push_back(result);
  if (results.size() * sizeof(ResultItem) < kPackBytes) return;
  outbox->Send(to, Encode(RayResults{std::exchange(results, {})}));
}

void RayPacker::AddShadow(ProcessId to, ShadowTravel shadow, Outbox* outbox) {
  Pack& pack = packs_[to];
  pack.shadow_bytes += kShadowBytes + shadow.crossings.size() * kCrossingBytes;
  pack.shadows.rays.push_back(std::move(shadow));
  if (pack.shadow_bytes >= kPackBytes) SendShadows(to, &pack, outbox);
}

void RayPacker::SendShadows(ProcessId to, Pack* pack, Outbox* outbox) {
  if (pack->shadow_bytes == 0) return;
  outbox->Send(to, Encode(pack->shadows));
  pack->shadows.rays.clear();
  pack->shadow_bytes = 0;
}

void RayPacker::AddShadowResult(ProcessId to, const ShadowItem& result, Outbox* outbox) {
  Pack& pack = packs_[to];
  pack.shadow_results.results.push_back(result);
  if (pack.shadow_results.results.size() * kShadowResultBytes >= kPackBytes)
    SendShadowResults(to, &pack, outbox);
}

void RayPacker::SendShadowResults(ProcessId to, Pack* pack, Outbox* outbox) {
  if (pack->shadow_results.results.empty()) return;
  outbox->Send(to, Encode(pack->shadow_results));
  pack->shadow_results.results.clear();
}

void RayPacker::AddPixel(const PixelItem& pixel, bool hit, Outbox* outbox) {
  std::vector<PixelItem>& pixels = hit ? pixels_.hits : pixels_.misses;
  pixels.push_back(pixel);
  if (pixels.size() * sizeof(PixelItem) >= kPixelBytes) SendPixels(outbox);
}

void RayPacker::AddVoid(uint64_t token, Outbox* outbox) {
  pixels_.voids.Add(token);
  if (pixels_.voids.size() >= kVoids) SendPixels(outbox);
}

void RayPacker::FlushRays(Outbox* outbox) {
  for (size_t i = 0; i < packs_.size(); ++i) {
    const ProcessId to = static_cast<ProcessId>(i);
    Pack& pack = packs_[i];
    SendRays<RayTask>(to, &pack.rays, outbox);
    SendRays<IntersectionTask>(to, &pack.intersections, outbox);
    if (!pack.results.empty()) {
      outbox->Send(to, Encode(RayResults{std::exchange(pack.results, {})}));
    }
    SendShadows(to, &pack, outbox);
    SendShadowResults(to, &pack, outbox);
  }
}

void RayPacker::Flush(Outbox* outbox) {
  FlushRays(outbox);
  SendPixels(outbox);
}

size_t RayPacker::bytes() const {
  size_t bytes = packs_.size() * sizeof(Pack) + pixels_.voids.capacity_bytes() +
                 (pixels_.misses.capacity() + pixels_.hits.capacity()) * sizeof(PixelItem);
  for (const Pack& p : packs_) {
    bytes += 2 * (p.rays.bytes + p.intersections.bytes) +
             p.results.capacity() * sizeof(ResultItem) + 2 * p.shadow_bytes +
             p.shadow_results.results.capacity() * sizeof(ShadowItem);
  }
  return bytes;
}

size_t RayPacker::size() const {
  size_t size = pixels_.voids.size() + pixels_.misses.size() + pixels_.hits.size();
  for (const Pack& p : packs_) {
    for (const Rays* r : {&p.rays, &p.intersections})
      size += r->content.primary.size() + r->content.travel.size();
    size += p.results.size();
  }
  return size;
}

}  // namespace rayshade::parallel
