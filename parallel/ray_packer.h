// Packs rays and results per receiver: a message of a few kilobytes costs what a message of one ray
// costs. A pack is sent when it is full, what other trace processes wait for as well when the
// process has worked for a while, and all when it has nothing else to do.
#pragma once

#include <span>
#include <vector>

#include "parallel/message.h"
#include "parallel/process.h"

namespace rayshade::parallel {

class RayPacker {
 public:
  // processes: trace processes, the host not counted.
  explicit RayPacker(ProcessId processes) : packs_(processes + 1) {}

  void AddRay(ProcessId to, const Ray& ray, std::span<const Medium> media, const Travel& travel,
              Outbox* outbox);
  void AddIntersection(ProcessId to, const Ray& ray, std::span<const Medium> media,
                       const Travel& travel, Outbox* outbox);
  // Results of secondary rays, to their spawners.
  void AddResult(ProcessId to, const ResultItem& result, Outbox* outbox);
  void AddShadow(ProcessId to, ShadowTravel shadow, Outbox* outbox);
  void AddShadowResult(ProcessId to, const ShadowItem& result, Outbox* outbox);
  // Results of primary rays, to the host.
  void AddPixel(const PixelItem& pixel, bool hit, Outbox* outbox);
  void AddVoid(uint64_t token, Outbox* outbox);
  void FlushRays(Outbox* outbox);  // all but pixels
  void Flush(Outbox* outbox);
  size_t bytes() const;
  size_t size() const;  // rays, hits and results that are not sent; shadow rays do not count

 private:
  struct Rays {
    TravellingRays content;
    size_t bytes = 0;  // when encoded, about
  };
  struct Pack {
    Rays rays, intersections;
    std::vector<ResultItem> results;
    ShadowTask shadows;
    size_t shadow_bytes = 0;  // when encoded, about
    ShadowResults shadow_results;
  };
  static void Add(const Ray& ray, std::span<const Medium> media, const Travel& travel, Rays* rays);
  template <class Message>
  static void SendRays(ProcessId to, Rays* rays, Outbox* outbox);
  static void SendShadows(ProcessId to, Pack* pack, Outbox* outbox);
  static void SendShadowResults(ProcessId to, Pack* pack, Outbox* outbox);
  void SendPixels(Outbox* outbox);

  std::vector<Pack> packs_;  // by receiver
  PixelResults pixels_;
};

}  // namespace rayshade::parallel
