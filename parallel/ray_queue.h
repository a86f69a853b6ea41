// Rays with their media and their travel, last in, first out. Media lie in the order of their rays.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "parallel/message.h"
#include "rayshade/common/ray.h"

namespace rayshade::parallel {

struct RayQueue {
  RayBundle bundle;
  std::vector<Travel> travel;

  size_t size() const { return travel.size(); }
  bool empty() const { return travel.empty(); }
  void clear() {
    bundle.clear();
    travel.clear();
  }
  void Push(Ray ray, std::span<const Medium> media, const Travel& t) {
    ray.media_begin = static_cast<uint32_t>(bundle.media.size());
    ray.media_count = static_cast<uint16_t>(media.size());
    bundle.media.insert(bundle.media.end(), media.begin(), media.end());
    bundle.rays.push_back(ray);
    travel.push_back(t);
  }
  std::span<const Medium> media(size_t i) const {
    const Ray& ray = bundle.rays[i];
    return std::span(bundle.media).subspan(ray.media_begin, ray.media_count);
  }
  // Moves the last `count` rays (or all) to the end of *to, in their order.
  void Pop(size_t count, RayQueue* to) {
    if (size() <= count && to->empty()) {
      std::swap(*this, *to);
      return;
    }
    const size_t begin = size() > count ? size() - count : 0;
    to->Append(*this, begin);
    if (begin < size()) bundle.media.resize(bundle.rays[begin].media_begin);
    bundle.rays.resize(begin);
    travel.resize(begin);
  }
  // Appends those of another queue, from its ray number `begin` on.
  void Append(const RayQueue& from, size_t begin = 0) {
    if (begin == from.size()) return;
    const size_t first = size();
    const uint32_t media_begin = from.bundle.rays[begin].media_begin;
    const uint32_t shift = static_cast<uint32_t>(bundle.media.size()) - media_begin;
    const auto append = [](const auto& source, size_t at, auto* to) {
      to->insert(to->end(), source.begin() + static_cast<std::ptrdiff_t>(at), source.end());
    };
    append(from.bundle.rays, begin, &bundle.rays);
    append(from.bundle.media, media_begin, &bundle.media);
    append(from.travel, begin, &travel);
    for (size_t i = first; shift != 0 && i < size(); ++i) bundle.rays[i].media_begin += shift;
  }
  size_t bytes() const {
    return bundle.rays.size() * sizeof(Ray) + bundle.media.size() * sizeof(Medium) +
           travel.size() * sizeof(Travel);
  }
};

}  // namespace rayshade::parallel
