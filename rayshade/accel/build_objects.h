// The objects that a hierarchy is built over, as its builder sees them; part of build.cc and
// pieces.cc.
#pragma once

#include <utility>

#include "rayshade/accel/box.h"
#include "rayshade/accel/build.h"

namespace rayshade {

class BuildObjects {
 public:
  explicit BuildObjects(const BuildInput& input)
      : in_(input), center_{in_.center[0], in_.center[1], in_.center[2], 0} {}

  uint32_t sphere_count() const { return static_cast<uint32_t>(in_.spheres.size()); }
  uint32_t ref_count() const { return static_cast<uint32_t>(in_.refs.size()); }
  BuildInput& input() { return in_; }

  // For the heuristic: not rounded outwards, and always finite.
  Box BoxOfSphere(const SphereRecord& s) const {
    const F4 c = __builtin_convertvector(D4{s.x, s.y, s.z, 0} - center_, F4);
    const F4 radius = AllOf(static_cast<float>(s.radius));
    return Finite({c - radius, c + radius});
  }
  static Box BoxOfRef(const BuildRef& r) {
    return Finite({F4{r.low[0], r.low[1], r.low[2], 0}, F4{r.high[0], r.high[1], r.high[2], 0}});
  }
  Box BoxOfSphere(uint32_t i) const { return BoxOfSphere(in_.spheres[i]); }
  Box BoxOfRef(uint32_t i) const { return BoxOfRef(in_.refs[i]); }

  void SwapSpheres(uint32_t i, uint32_t j) {
    std::swap(in_.spheres[i], in_.spheres[j]);
    std::swap(in_.keys[i], in_.keys[j]);
  }
  // Soon sphere i, if there is one, will be swapped.
  void PrefetchSphere(uint32_t i) const {
    if (i >= in_.spheres.size()) return;
    __builtin_prefetch(in_.spheres.data() + i, 1);
    __builtin_prefetch(in_.keys.data() + i, 1);
  }
  void SwapRefs(uint32_t i, uint32_t j) { std::swap(in_.refs[i], in_.refs[j]); }

 private:
  using D4 = double __attribute__((vector_size(32), aligned(8)));

  // No sum of areas overflows. What is farther away is in nobody's way.
  static Box Finite(const Box& b) {
    const F4 most = AllOf(1e13f);
    return {Min(Max(b.low, -most), most), Min(Max(b.high, -most), most)};
  }

  BuildInput in_;
  D4 center_;
};

}  // namespace rayshade
