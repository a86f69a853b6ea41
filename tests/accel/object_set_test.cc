// The hierarchy against a list of all objects, each asked through its Geom: same hits to the bit,
// on ordinary and on unkind scenes, with every kernel that this machine can run, in bundles of any
// size.
#include "rayshade/accel/object_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "tests/accel/compare.h"
#include "tests/accel/world.h"
#include "tests/support/kernels.h"
#include "tests/support/random.h"

namespace rayshade {
namespace {

using test::AddFlat;
using test::AddSpheres;
using test::CameraRays;
using test::Compare;
using test::kAllKernels;
using test::MakeRay;
using test::Random;
using test::RandomDirection;
using test::RandomPoint;
using test::Uniform;
using test::World;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Ray> RandomRays(Random* random, int count, double size, const Vector& at = {}) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    rays.push_back(MakeRay(at + RandomPoint(random, size * 1.5), RandomDirection(random)));
  }
  return rays;
}

TEST(ObjectSet, FindsWhatAListOfAllSpheresFinds) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 700, 10);
  size_t found = 0;
  Compare(&world, RandomRays(&random, 1500, 10), &found);
  EXPECT_GT(found, 300u);
}

TEST(ObjectSet, FindsWhatAListOfAllKindsFinds) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 100, 10);
  AddFlat(&world, &random, 300, 10);
  for (int i = 0; i < 50; ++i) {
    const Vector p = RandomPoint(&random, 10);
    const PlacementId placement = static_cast<PlacementId>(random() % 3);
    world.Add(BoxSpec{p, p + RandomPoint(&random, 1)}, placement);
    world.Add(DiscSpec{0.5, p, RandomDirection(&random)}, placement);
    world.Add(CylinderSpec{0.25, p, p + RandomPoint(&random, 2)}, placement);
    world.Add(SphereSpec{0.5, p + RandomPoint(&random, 1)}, 2);
  }
  world.Add(PlaneSpec{{0, 0, -9}, {0.1, 0, 1}}, 0);
  size_t found = 0;
  Compare(&world, RandomRays(&random, 1200, 10), &found);
  EXPECT_GT(found, 600u);
}

// Points, normals and what Aim makes of them, padded to groups of eight.
struct Rows {
  std::vector<double> point[3], normal[3], toward[3], distance, cosine, time;
  explicit Rows(size_t count) {
    const size_t room = (count + 7) / 8 * 8;
    for (int k = 0; k < 3; ++k) {
      point[k].assign(room, 0.5);
      normal[k].assign(room, 0.5);
      toward[k].resize(room);
    }
    distance.resize(room);
    cosine.resize(room);
    time.resize(room);
  }
};

// Hits anywhere, also at the light itself, lit from one position: directions as Normalize gives
// them, and the answer of a list of all objects for each.
TEST(ObjectSet, RowsOfShadowRaysTowardsOnePosition) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 200, 10);
  AddFlat(&world, &random, 300, 10);
  const Vector light{1, -2, 3};
  for (const bool coherent : {true, false}) {
    const size_t count = 501;
    Rows rows(count);
    std::vector<Vector> points;
    double reach = 100;
    for (size_t i = 0; i < count; ++i) {
      const double x = static_cast<double>(i % 24) / 6, y = static_cast<double>(i / 24) / 6;
      Vector p = coherent ? Vector{-9 + x, 5 + y, -8} : RandomPoint(&random, 12);
      if (i % 100 == 99) p = light + 1e-6 * RandomDirection(&random);
      const Vector n = RandomDirection(&random);
      points.push_back(p);
      for (int k = 0; k < 3; ++k) {
        rows.point[k][i] = p[k];
        rows.normal[k][i] = n[k];
      }
    }
    for (const char* simd : kAllKernels) {
      world.Build(simd);
      world.set().Aim({{rows.point[0].data(), rows.point[1].data(), rows.point[2].data()},
                       {rows.normal[0].data(), rows.normal[1].data(), rows.normal[2].data()},
                       static_cast<uint32_t>(count),
                       {light.x, light.y, light.z},
                       {rows.toward[0].data(), rows.toward[1].data(), rows.toward[2].data()},
                       rows.distance.data(),
                       rows.cosine.data()});
      std::vector<uint8_t> blocked(count), crossed(count);
      for (size_t i = 0; i < count; i += 7) blocked[i] = 1;  // not to be asked about
      OpCounts counts;
      world.set().Block({{rows.point[0].data(), rows.point[1].data(), rows.point[2].data()},
                         {rows.toward[0].data(), rows.toward[1].data(), rows.toward[2].data()},
                         rows.distance.data(),
                         rows.time.data(),
                         {light.x, light.y, light.z},
                         reach,
                         blocked.data(),
                         crossed.data(),
                         static_cast<uint32_t>(count)},
                        &counts);
      size_t shadows = 0;
      for (size_t i = 0; i < count; ++i) {
        Vector toward = light - points[i];
        const double distance = Normalize(&toward);
        const Vector n{rows.normal[0][i], rows.normal[1][i], rows.normal[2][i]};
        const Vector got{rows.toward[0][i], rows.toward[1][i], rows.toward[2][i]};
        ASSERT_EQ(got, toward) << simd << " " << i;
        ASSERT_EQ(rows.distance[i], distance) << simd << " " << i;
        ASSERT_EQ(rows.cosine[i], Dot(toward, n)) << simd << " " << i;
        if (i % 7 == 0) continue;
        Ray ray = MakeRay(points[i], toward);
        ray.min_distance = kShadowEpsilon;
        ASSERT_EQ(blocked[i], world.BlockedInList(ray, distance)) << simd << " " << i;
        shadows += blocked[i];
      }
      EXPECT_GT(shadows, 20u);
    }
  }
}

TEST(ObjectSet, NoHitIsLostAlongFacesEdgesAndCorners) {
  World world;
  // A lattice of touching spheres, and squares on its planes.
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int z = 0; z < 5; ++z) {
        world.Add(SphereSpec{0.5, {x + 0.0, y + 0.0, z + 0.0}});
        if (z == 2) {
          const double a = x - 0.5, b = y - 0.5;
          world.Add(
              PolygonSpec{{{a, b, 1.5}, {a + 1, b, 1.5}, {a + 1, b + 1, 1.5}, {a, b + 1, 1.5}}});
          world.Add(TriangleSpec{{{a, 1.5, b}, {a + 1, 1.5, b}, {a + 1, 1.5, b + 1}}});
        }
      }
    }
  }
  std::vector<Ray> rays;
  const double tiny[] = {0,     0x1.0p-1074, -0x1.0p-1074, 1e-310, -1e-310,
                         1e-40, -1e-40,      1e-20,        -1e-6};
  for (const double a : tiny) {
    for (const double b : tiny) {
      for (int i = -2; i <= 11; ++i) {
        for (int j = -2; j <= 11; j += 4) {
          rays.push_back(MakeRay({-3, i / 2.0, j / 2.0}, {1, a, b}));
          rays.push_back(MakeRay({i / 2.0, 9, j / 2.0}, {a, -1, b}));
        }
      }
    }
  }
  // Through corners, along diagonals.
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      rays.push_back(MakeRay({i - 0.5, j - 0.5, -5.5}, Normalized({1, 1, 1})));
      rays.push_back(MakeRay({i + 0.0, j + 0.0, 9}, Normalized({0, 1, -1})));
    }
  }
  size_t found = 0;
  Compare(&world, rays, &found);
  EXPECT_GT(found, 2000u);
}

TEST(ObjectSet, CoincidentObjectsAreDecidedByRank) {
  Random random(7);
  World world;
  for (int copy = 0; copy < 12; ++copy) {
    for (int i = 0; i < 20; ++i) {
      const Vector p{i * 1.0, i % 3 * 1.0, 0};
      world.Add(SphereSpec{0.4, p});
      world.Add(TriangleSpec{{p, p + Vector{1, 0, 0}, p + Vector{0, 1, 0}}});
      world.Add(BoxSpec{p, p + Vector{1, 1, 1}});
    }
  }
  size_t found = 0;
  Compare(&world, RandomRays(&random, 2000, 6, {9, 1, 0}), &found);
  EXPECT_GT(found, 50u);
}

TEST(ObjectSet, AMillionUnitsAwayAndBeyond) {
  for (const double offset : {1e6, 1e9, 1e12}) {
    Random random(7);
    World world;
    const Vector at{offset, -offset, offset};
    AddSpheres(&world, &random, 200, offset * 1e-5, at);
    AddFlat(&world, &random, 60, offset * 1e-5, at);
    Compare(&world, RandomRays(&random, 400, offset * 1e-5, at));
    Compare(&world, CameraRays(at + Vector{offset * 3e-5, offset * 1e-5, 0}, at, 20));
  }
}

TEST(ObjectSet, FarOriginsAndHugeObjects) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 300, 10);
  AddFlat(&world, &random, 60, 10);
  world.Add(SphereSpec{1e12, {0, 0, -1e12}});
  std::vector<Ray> rays;
  for (const double far : {1e3, 1e5, 1e7, 1e9, 1e11}) {
    for (int i = 0; i < 150; ++i) {
      const Vector origin = far * RandomDirection(&random);
      rays.push_back(MakeRay(origin, Normalized(RandomPoint(&random, 10) - origin)));
    }
  }
  const std::vector<Ray> near = RandomRays(&random, 300, 10);
  rays.insert(rays.end(), near.begin(), near.end());
  size_t found = 0;
  Compare(&world, rays, &found);
  EXPECT_GT(found, 300u);
}

// Past spheres by as much or as little as rounding can move them, from near and far, and from their
// own surfaces, where hits begin to count just before or after where a root is.
TEST(ObjectSet, RaysThatTouchSpheresOrBeginOnThem) {
  Random random(7);
  World world;
  std::vector<SphereSpec> spheres;
  for (int i = 0; i < 40; ++i) {
    const double radius = std::pow(10, Uniform(&random, -3, 1));
    spheres.push_back({radius, RandomPoint(&random, 30)});
    world.Add(spheres.back());
  }
  std::vector<Ray> rays;
  for (const SphereSpec& sphere : spheres) {
    const Vector center = sphere.center;
    for (int i = 0; i < 40; ++i) {
      const Vector direction = RandomDirection(&random);
      const Vector across = Normalized(Cross(direction, RandomDirection(&random)));
      const double off = std::pow(10, Uniform(&random, -17, -4)) * (i % 2 == 0 ? 1 : -1);
      const Vector touch = center + sphere.radius * (1 + off) * across;
      const double far = sphere.radius * std::pow(10, Uniform(&random, -2, 5));
      rays.push_back(MakeRay(touch - far * direction, direction));
      Ray leaving = MakeRay(center + sphere.radius * across, RandomDirection(&random));
      const double chord = -2 * sphere.radius * Dot(leaving.direction, across);
      if (i % 3 != 0) leaving.min_distance = std::max(kEpsilon, chord * (1 + off));
      rays.push_back(leaving);
    }
  }
  size_t found = 0;
  Compare(&world, rays, &found);
  EXPECT_GT(found, 1000u);
  EXPECT_LT(found, rays.size() - 500);
}

TEST(ObjectSet, RaysOfAnyLengthAndMinimum) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 300, 10);
  AddFlat(&world, &random, 60, 10);
  std::vector<Ray> rays = RandomRays(&random, 600, 10);
  for (size_t i = 0; i < rays.size(); ++i) {
    rays[i].min_distance = std::abs(Uniform(&random, -5, 5));
    if (i % 4 == 0) rays[i].direction = Uniform(&random, 0.3, 3) * rays[i].direction;
  }
  Compare(&world, rays);
}

TEST(ObjectSet, EarlierHitsAndLimitsArePutToTheTest) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 300, 10);
  AddFlat(&world, &random, 100, 10);
  const std::vector<Ray> rays = RandomRays(&random, 1000, 10);
  std::vector<Hit> preset(rays.size()), hits;
  for (size_t i = 0; i < rays.size(); ++i) {
    const Hit first = world.NearestInList(rays[i], Hit{});
    if (!first.found()) continue;
    preset[i] = first;
    // The same hit again; one of a later rank at its place; a limit just before or behind.
    if (i % 4 == 1) preset[i].rank = first.rank + 1;
    if (i % 4 == 2) preset[i] = {first.distance * 0.999, kNoRank, 0, nullptr};
    if (i % 4 == 3) preset[i] = {first.distance * 1.001, kNoRank, 0, nullptr};
  }
  for (const char* simd : kAllKernels) {
    world.Build(simd);
    hits = preset;
    OpCounts counts;
    world.set().Nearest(rays, hits, &counts);
    for (size_t i = 0; i < rays.size(); ++i) {
      const Hit expected = world.NearestInList(rays[i], preset[i]);
      ASSERT_EQ(hits[i].distance, expected.distance) << simd << " ray " << i;
      ASSERT_EQ(hits[i].rank, expected.rank) << simd << " ray " << i;
      const bool improved = expected.rank != preset[i].rank;
      ASSERT_EQ(hits[i].set, improved ? &world.set() : nullptr) << simd << " ray " << i;
    }
  }
}

}  // namespace
}  // namespace rayshade
