// Rays with their media and their travel, last in, first out.
#pragma once

#include <span>
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
    const size_t begin = size() > count ? size() - count : 0;
    for (size_t i = begin; i < size(); ++i) to->Push(bundle.rays[i], media(i), travel[i]);
    if (begin < size()) bundle.media.resize(bundle.rays[begin].media_begin);
    bundle.rays.resize(begin);
    travel.resize(begin);
  }
  size_t bytes() const {
    return bundle.rays.size() * sizeof(Ray) + bundle.media.size() * sizeof(Medium) +
           travel.size() * sizeof(Travel);
  }
};

}  // namespace rayshade::parallel
