// What a set holds and gives back: entries, boxes, duplicates, descriptions, bytes.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "tests/accel/world.h"
#include "tests/support/random.h"

namespace rayshade {
namespace {

using test::AddFlat;
using test::AddSpheres;
using test::MakeRay;
using test::Random;
using test::RandomPoint;
using test::Uniform;
using test::World;

TEST(ObjectSet, ForEachInVisitsWhatOverlapsABox) {
  Random random(7);
  World world;
  AddSpheres(&world, &random, 500, 10);
  AddFlat(&world, &random, 200, 10);
  world.Add(PlaneSpec{{0, 0, 0}, {0, 0, 1}});
  world.Build("plain");
  for (int i = 0; i < 200; ++i) {
    const Vector p = RandomPoint(&random, 10);
    Bounds box{p, p};
    box.Include(p + RandomPoint(&random, i % 4 == 0 ? 0 : 2));
    if (i % 5 == 0) box.Include(world.BoxOf(random() % 500).high);
    std::vector<bool> visited(world.size());
    world.set().ForEachIn(box, [&](uint32_t object) {
      const Rank rank = world.set().entry(object).rank;
      EXPECT_FALSE(visited[rank]);
      visited[rank] = true;
    });
    for (size_t k = 0; k < world.size(); ++k) {
      EXPECT_EQ(visited[k], world.bounded(k) && world.BoxOf(k).Overlaps(box)) << k;
    }
  }
}

TEST(ObjectSet, GivesBackWhatWasAdded) {
  World world;
  Random random(7);
  AddSpheres(&world, &random, 100, 10);
  AddFlat(&world, &random, 20, 10);
  world.Add(BoxSpec{{0, 0, 0}, {1, 2, 3}}, 2);
  world.Build("plain");
  std::vector<bool> seen(world.size());
  for (uint32_t i = 0; i < world.set().size(); ++i) {
    const ObjectSet::Entry entry = world.set().entry(i);
    ASSERT_LT(entry.rank, world.size());
    EXPECT_FALSE(seen[entry.rank]);
    seen[entry.rank] = true;
    EXPECT_EQ(entry.placement, world.set().placement_of(i));
    const Bounds box = BoundsOf(entry.spec),
                 own = WorldBounds(world.scene().placement(entry.placement), box, {});
    EXPECT_EQ(own, world.BoxOf(entry.rank)) << i;
  }
  EXPECT_EQ(world.set().size(), world.size());
}

TEST(ObjectSet, DuplicatesAreHeldOnceAndResolvedObjectsStandWhereTheyWerePut) {
  World world;
  world.Build("plain");
  ObjectSet set(&world.scene());
  for (int copy = 0; copy < 3; ++copy) {
    for (Rank i = 0; i < 50; ++i) set.Add(SphereSpec{0.25, {i * 1.0, 0, 0}}, 0, i);
    set.Add(BoxSpec{{0, 5, 0}, {1, 6, 1}}, 0, 50);
  }
  // Ranks from the other end; the last sphere moves by its new placement to x = 2 * 49 + 0.25.
  set.ResolveAll([](PlacementId placement, Rank rank) {
    return std::pair<PlacementId, Rank>(rank == 49 ? 2 : placement, 100 - rank);
  });
  set.Build();
  EXPECT_EQ(set.size(), 51u);
  const std::vector<Ray> rays = {MakeRay({3, 0, 9}, {0, 0, -1}), MakeRay({98.25, 0, 9}, {0, 0, -1}),
                                 MakeRay({49, 0, 9}, {0, 0, -1})};
  std::vector<Hit> hits(3);
  OpCounts counts;
  set.Nearest(rays, hits, &counts);
  EXPECT_EQ(hits[0].rank, 97u);
  EXPECT_EQ(hits[1].rank, 51u);
  EXPECT_FALSE(hits[2].found());
  EXPECT_EQ(set.placement_of(hits[1].object), 2u);
}

TEST(ObjectSet, DescribesHitsInTheSpaceOfTheirPrimitive) {
  World world;
  world.Add(SphereSpec{2, {0, 0, 0}}, 0);
  world.Add(SphereSpec{1, {10, 0, 0}}, 2);  // an ellipsoid at x = 20.25 of half axes 2, .5, 1
  world.Add(TriangleSpec{{{-5, -1, 0}, {-3, -1, 0}, {-4, 1, 0}}}, 0);
  world.Build("plain");
  const std::vector<Ray> rays = {MakeRay({0, 0, 9}, {0, 0, -1}), MakeRay({20.25, 9, 0}, {0, -1, 0}),
                                 MakeRay({-4, 0, 9}, {0, 0, -1})};
  std::vector<Hit> hits(3);
  OpCounts counts;
  world.set().Nearest(rays, hits, &counts);
  HitPath path;
  ASSERT_TRUE(hits[0].found());
  world.set().Describe(rays[0], hits[0], &path);
  EXPECT_EQ(path.point, (Vector{0, 0, 2}));
  EXPECT_EQ(path.normal, (Vector{0, 0, 1}));
  ASSERT_TRUE(hits[1].found());
  world.set().Describe(rays[1], hits[1], &path);
  EXPECT_DOUBLE_EQ(path.point.y, 1);
  EXPECT_DOUBLE_EQ(path.normal.y, 1);
  ASSERT_TRUE(hits[2].found());
  world.set().Describe(rays[2], hits[2], &path);
  EXPECT_EQ(path.normal, (Vector{0, 0, 1}));
}

TEST(ObjectSet, AnEmptySetIsMissedByAllRays) {
  World world;
  world.Build("plain");
  const std::vector<Ray> rays(3, MakeRay({0, 0, 0}, {1, 0, 0}));
  std::vector<Hit> hits(3);
  OpCounts counts;
  world.set().Nearest(rays, hits, &counts);
  for (const Hit& hit : hits) EXPECT_FALSE(hit.found());
  EXPECT_EQ(world.set().size(), 0u);
  EXPECT_TRUE(world.set().bounds().empty());
}

TEST(ObjectSet, ASphereTakesFewBytes) {
  World world;
  Random random(7);
  world.Build("plain");
  ObjectSet set(&world.scene());
  constexpr int kSpheres = 50000;
  for (int i = 0; i < kSpheres; ++i) {
    set.Add(SphereSpec{Uniform(&random, 0.001, 0.01), RandomPoint(&random, 1)}, 0,
            static_cast<Rank>(i));
  }
  set.Build();
  EXPECT_LE(set.bytes(), kSpheres * size_t{64});
  EXPECT_GE(set.bytes(), kSpheres * size_t{40});
}

}  // namespace
}  // namespace rayshade
