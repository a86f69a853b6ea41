// Packs rays and results per receiver: a message of 4 kB costs what a message of one ray costs. A
// pack is sent when it is full, and all are sent when the process has nothing else to do or has
// worked for a while.
#pragma once

#include <vector>

#include "parallel/message.h"
#include "parallel/process.h"
#include "parallel/ray_queue.h"

namespace rayshade::parallel {

class RayPacker {
 public:
  // processes: trace processes, the host not counted.
  explicit RayPacker(ProcessId processes) : packs_(processes + 1) {}

  void AddRay(ProcessId to, const Ray& ray, std::span<const Medium> media, const Travel& travel,
              Outbox* outbox);
  void AddIntersection(ProcessId to, const Ray& ray, std::span<const Medium> media,
                       const Travel& travel, Outbox* outbox);
  // To the host: pixels; to a trace process: results of secondary rays.
  void AddResult(ProcessId to, const ResultItem& result, Outbox* outbox);
  void Flush(Outbox* outbox);
  size_t bytes() const;

 private:
  struct Pack {
    RayQueue rays, intersections;
    std::vector<ResultItem> results;
  };
  template <class Message>
  static void SendRays(ProcessId to, RayQueue* rays, Outbox* outbox);
  static void SendResults(ProcessId to, Pack* pack, Outbox* outbox);

  std::vector<Pack> packs_;  // by receiver
};

}  // namespace rayshade::parallel
