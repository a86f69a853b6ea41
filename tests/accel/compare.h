// The answers of an ObjectSet, with every kernel that this machine can run and in bundles of any
// size, against the list of all objects.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "tests/accel/world.h"
#include "tests/support/kernels.h"

namespace rayshade::test {

// Everything that a set answers about these rays. *found: how many of them hit something.
inline void Compare(World* world, const std::vector<Ray>& rays, size_t* found = nullptr) {
  std::vector<Hit> expected(rays.size());
  std::vector<double> limits(rays.size());
  std::vector<uint8_t> blocked(rays.size());
  size_t hits = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    expected[i] = world->NearestInList(rays[i], Hit{});
    hits += expected[i].found();
    limits[i] = i % 3 == 0 ? kFar : expected[i].distance * (i % 3 == 1 ? 1 : 1.25);
    blocked[i] = world->BlockedInList(rays[i], limits[i]);
  }
  if (found) *found = hits;
  for (const char* simd : kAllKernels) {
    world->Build(simd);
    for (const size_t bundle :
         {size_t{1}, size_t{3}, size_t{16}, size_t{64}, size_t{100}, size_t{1024}}) {
      std::vector<Hit> got(rays.size());
      std::vector<uint8_t> shadow(rays.size());
      OpCounts counts;
      for (size_t i = 0; i < rays.size(); i += bundle) {
        const size_t n = std::min(bundle, rays.size() - i);
        world->set().Nearest({rays.data() + i, n}, {got.data() + i, n}, &counts);
        world->set().Block({rays.data() + i, n}, {limits.data() + i, n}, {shadow.data() + i, n},
                           &counts);
      }
      for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(got[i].distance, expected[i].distance)
            << simd << " ray " << i << " of " << bundle;
        ASSERT_EQ(got[i].rank, expected[i].rank) << simd << " ray " << i << " of " << bundle;
        ASSERT_EQ(shadow[i], blocked[i]) << simd << " shadow ray " << i << " of " << bundle;
        if (got[i].found()) {
          ASSERT_EQ(got[i].set, &world->set());
          ASSERT_EQ(world->set().entry(got[i].object).rank, got[i].rank);
        }
      }
    }
  }
}

// A camera's rays in rows; field: of view, as a slope.
inline std::vector<Ray> CameraRays(const Vector& eye, const Vector& at, int side,
                                   double field = 1) {
  std::vector<Ray> rays;
  const Vector forward = Normalized(at - eye), right = Normalized(Cross(forward, {0, 0, 1}));
  const Vector up = Cross(right, forward);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double u = (x + 0.5) / side - 0.5, v = 0.5 - (y + 0.5) / side;
      rays.push_back(MakeRay(eye, Normalized(forward + field * (u * right + v * up))));
    }
  }
  return rays;
}

}  // namespace rayshade::test
