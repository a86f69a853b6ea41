// Rays that are traced together: through a narrow pyramid, or towards a light; also where they part
// before they end, and go on alone.
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "tests/accel/compare.h"
#include "tests/accel/world.h"
#include "tests/support/random.h"

namespace rayshade {
namespace {

using test::AddFlat;
using test::AddSpheres;
using test::CameraRays;
using test::Compare;
using test::MakeRay;
using test::Random;
using test::RandomPoint;
using test::Uniform;
using test::World;

// From what the rays hit to the light.
std::vector<Ray> TowardsLight(const World& world, const std::vector<Ray>& primary,
                              const Vector& light) {
  std::vector<Ray> shadow;
  std::vector<Hit> hits(primary.size());
  OpCounts counts;
  world.set().Nearest(primary, hits, &counts);
  for (size_t i = 0; i < primary.size(); ++i) {
    if (!hits[i].found()) continue;
    const Vector p = primary[i].origin + hits[i].distance * primary[i].direction;
    shadow.push_back(MakeRay(p, Normalized(light - p)));
    shadow.back().min_distance = kShadowEpsilon;
  }
  return shadow;
}

TEST(Bundles, CameraRaysFindWhatSingleRaysFind) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 500, 10);
  AddFlat(&world, &random, 100, 10);
  Compare(&world, CameraRays({22, 13, 17}, {0, 0, 0}, 40));
  Compare(&world, CameraRays({0.5, 0.25, 0.125}, {1, 1, 0}, 40));  // from within
}

TEST(Bundles, RaysTowardsALight) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 400, 10);
  AddFlat(&world, &random, 100, 10);
  world.Build("plain");
  const std::vector<Ray> shadow =
      TowardsLight(world, CameraRays({22, 13, 17}, {0, 0, 0}, 40), {9, -30, 14});
  ASSERT_GT(shadow.size(), 200u);
  Compare(&world, shadow);
}

// Objects so small that each ray meets its own, among few others: bundles give up, and each ray has
// to find what is left of them. Some objects are transparent, and an unbounded one is behind.
TEST(Bundles, RaysThatPart) {
  for (const bool spheres_only : {true, false}) {
    Random random(7);
    World world;
    for (int i = 0; i < 1500; ++i) {
      world.Add(SphereSpec{Uniform(&random, 0.02, 0.12), RandomPoint(&random, 3)}, i % 5 == 0);
    }
    if (!spheres_only) {
      AddFlat(&world, &random, 150, 3);
      world.Add(PlaneSpec{{0, 0, -5}, {0.1, 0, 1}}, 0);
    }
    world.Build("plain");
    const std::vector<Ray> rays = CameraRays({22, 13, 17}, {0, 0, 0}, 32, 0.25);
    size_t found = 0;
    Compare(&world, rays, &found);
    EXPECT_GT(found, 300u);
    const std::vector<Ray> shadow = TowardsLight(world, rays, {300, -200, 400});
    Compare(&world, shadow, &found);
    EXPECT_GT(found, 100u);
  }
}

}  // namespace
}  // namespace rayshade
