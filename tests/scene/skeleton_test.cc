#include "rayshade/scene/skeleton.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "rayshade/geom/make_geom.h"

namespace rayshade {
namespace {

// Keeps what it is given.
class ListStore : public ObjectStore {
 public:
  struct Object {
    LocalPlacement local;
    bool in_definition;
    GeomSpec spec;
  };
  void Add(uint64_t sequence, LocalPlacement local, bool in_definition, GeomSpec&& spec) override {
    EXPECT_EQ(sequence, objects.size());
    objects.push_back({local, in_definition, std::move(spec)});
  }
  void ReadBack(uint64_t first, uint64_t end, const Visit& visit) override {
    for (uint64_t i = first; i < end; ++i) {
      EXPECT_TRUE(objects[i].in_definition);
      visit(objects[i].local, objects[i].spec);
    }
  }
  std::vector<Object> objects;
};

class SkeletonTest : public testing::Test {
 protected:
  // A sphere at x, known by its x.
  void Sphere(double x, SurfaceId surface = kNoSurface) {
    skeleton.AddPrimitive(SphereSpec{1, {x, 0, 0}}, With(surface));
  }
  void Plane() { skeleton.AddPrimitive(PlaneSpec{{0, 0, 0}, {0, 0, 1}}, {}); }
  void Disc() { skeleton.AddPrimitive(DiscSpec{1, {0, 0, 0}, {0, 0, 1}}, {}); }
  void Begin(AggregateKind kind = AggregateKind::kList) {
    const int counts[3] = {2, 2, 2};
    skeleton.BeginAggregate(kind, counts);
  }
  bool End(Attributes attributes = {}) { return skeleton.EndAggregate(std::move(attributes)); }

  static Attributes With(SurfaceId surface) {
    Attributes attributes;
    attributes.surface = surface;
    return attributes;
  }
  static Attributes Shift(double x) {
    Attributes attributes;
    attributes.transforms.Append(Translate({x, 0, 0}));
    return attributes;
  }

  // Every placed object: rank, sequence, placement.
  struct Placed {
    uint64_t sequence;
    PlacementId placement;
  };
  std::map<Rank, Placed> AllPlaced(const Expansion& expansion) {
    std::map<Rank, Placed> placed;
    RunCursor cursor(&expansion.runs);
    for (uint64_t i = 0; i < store.objects.size(); ++i) {
      const ObjectRun *run, *end;
      cursor.Find(i, &run, &end);
      for (; run != end; ++run) {
        const Rank rank = expansion.rank(*run, i, IsInclusive(store.objects[i].spec));
        EXPECT_TRUE(placed.emplace(rank, Placed{i, run->placement(store.objects[i].local)}).second)
            << "rank " << rank << " twice";
      }
    }
    EXPECT_EQ(placed.size(), expansion.objects);
    return placed;
  }
  // Sequences in the order in which they win ties.
  std::vector<uint64_t> Order() {
    std::vector<uint64_t> order;
    for (const auto& [rank, placed] : AllPlaced(skeleton.Expand(0))) {
      order.push_back(placed.sequence);
    }
    return order;
  }

  ListStore store;
  Skeleton skeleton{&store};
};

using Sequences = std::vector<uint64_t>;

TEST_F(SkeletonTest, InAListTheLastWrittenWinsTies) {
  for (int i = 0; i < 3; ++i) Sphere(i);
  EXPECT_EQ(Order(), (Sequences{2, 1, 0}));
}

TEST_F(SkeletonTest, InAGridTheFirstWrittenWinsTies) {
  Begin(AggregateKind::kGrid);
  for (int i = 0; i < 3; ++i) Sphere(i);
  End();
  EXPECT_EQ(Order(), (Sequences{0, 1, 2}));
}

TEST_F(SkeletonTest, UnboundedMembersAreTestedFirstAsWritten) {
  Sphere(0);
  Plane();
  Sphere(2);
  Plane();
  EXPECT_EQ(Order(), (Sequences{1, 3, 2, 0}));
}

TEST_F(SkeletonTest, InclusiveKindsWinOverStrictOnesAndTheFirstWrittenAmongThem) {
  Disc();
  Plane();
  Disc();
  Sphere(3);
  EXPECT_EQ(Order(), (Sequences{0, 2, 1, 3}));
}

TEST_F(SkeletonTest, NestedAggregatesAreTestedAsBlocks) {
  Sphere(0);
  Begin(AggregateKind::kGrid);
  Sphere(1);
  Sphere(2);
  End();
  Sphere(3);
  EXPECT_EQ(Order(), (Sequences{3, 1, 2, 0}));
}

TEST_F(SkeletonTest, AnAggregateWithoutBoundedMembersIsUnbounded) {
  Sphere(0);
  Begin();
  Plane();
  End();
  Begin();
  Plane();
  Sphere(3);
  End();
  EXPECT_EQ(Order(), (Sequences{1, 2, 3, 0}));
}

TEST_F(SkeletonTest, EachInstanceHasABlockOfItsOwn) {
  skeleton.BeginDefinition();
  Begin();
  Sphere(0);
  Sphere(1);
  End();
  const DefinitionId pair = skeleton.EndDefinition();
  Sphere(2);
  skeleton.AddInstance(pair, Shift(10));
  skeleton.AddInstance(pair, Shift(20));
  const Expansion expansion = skeleton.Expand(0);
  EXPECT_EQ(expansion.objects, 5u);
  Sequences order;
  std::vector<double> shifts;
  for (const auto& [rank, placed] : AllPlaced(expansion)) {
    order.push_back(placed.sequence);
    const Bounds box =
        WorldBounds(expansion.placements[placed.placement], {{0, 0, 0}, {0, 0, 0}}, {});
    shifts.push_back(std::round(box.low.x));
  }
  EXPECT_EQ(order, (Sequences{1, 0, 1, 0, 2}));
  EXPECT_EQ(shifts, (std::vector<double>{20, 20, 10, 10, 0}));
}

TEST_F(SkeletonTest, ADefinitionThatIsNeverPlacedHasNoRuns) {
  skeleton.BeginDefinition();
  Sphere(0);
  skeleton.EndDefinition();
  Sphere(1);
  EXPECT_EQ(Order(), (Sequences{1}));
}

TEST_F(SkeletonTest, ADefinitionInsideAnAggregateIsAHoleInItsRun) {
  Begin();
  Sphere(0);
  skeleton.BeginDefinition();
  Sphere(1);
  const DefinitionId named = skeleton.EndDefinition();
  Sphere(2);
  skeleton.AddInstance(named, {});
  End(Shift(5));
  EXPECT_EQ(Order(), (Sequences{1, 2, 0}));
}

TEST_F(SkeletonTest, EmptyAggregatesAndDefinitionsAreDropped) {
  Begin();
  Begin();
  EXPECT_FALSE(End());
  EXPECT_FALSE(End());
  skeleton.BeginDefinition();
  EXPECT_EQ(skeleton.EndDefinition(), kNoDefinition);
  EXPECT_EQ(skeleton.Expand(0).objects, 0u);
}

TEST_F(SkeletonTest, PathsRunFromTheObjectOutwards) {
  skeleton.BeginDefinition();
  Begin();
  skeleton.AddPrimitive(SphereSpec{}, Shift(1));
  End(Shift(2));
  const DefinitionId named = skeleton.EndDefinition();
  Begin();
  skeleton.AddInstance(named, Shift(3));
  End(Shift(4));
  const Expansion expansion = skeleton.Expand(0);
  ASSERT_EQ(expansion.placements.size(), 1u);
  const Placement& placement = expansion.placements[0];
  ASSERT_EQ(placement.levels.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(placement.levels[i].attributes.transforms, Shift(i + 1).transforms) << i;
  }
}

TEST_F(SkeletonTest, ThousandsOfLikeObjectsHaveOneRunAndTwoPlacements) {
  const SurfaceId red = skeleton.AddSurface({}), blue = skeleton.AddSurface({});
  Begin(AggregateKind::kGrid);
  for (int i = 0; i < 3000; ++i) Sphere(i, i % 2 ? red : blue);
  End(With(red));
  const Expansion expansion = skeleton.Expand(0);
  EXPECT_EQ(expansion.runs.size(), 1u);
  ASSERT_EQ(expansion.placements.size(), 2u);
  EXPECT_EQ(expansion.placements[0].surface, blue);
  EXPECT_EQ(expansion.placements[1].surface, red);
}

TEST_F(SkeletonTest, LevelsThatSayNothingLeaveNoTrace) {
  Begin();
  Begin(AggregateKind::kGrid);
  Sphere(0);
  End();
  End();
  const Expansion expansion = skeleton.Expand(0);
  ASSERT_EQ(expansion.placements.size(), 1u);
  EXPECT_EQ(expansion.placements[0].levels.size(), 1u);
  EXPECT_TRUE(expansion.placements[0].plain);
}

TEST_F(SkeletonTest, ABoundedAggregateClipsItsPlanesByTheBoxOfItsParentsMembers) {
  Begin();
  Plane();
  Sphere(0);
  End();
  Sphere(10);
  const Expansion expansion = skeleton.Expand(0);
  for (const auto& [rank, placed] : AllPlaced(expansion)) {
    const Placement& placement = expansion.placements[placed.placement];
    if (placed.sequence != 0) {
      EXPECT_TRUE(placement.plain);
      continue;
    }
    const PathLevel& outer = placement.levels.back();
    ASSERT_TRUE(outer.clip.has_value());
    EXPECT_NEAR(outer.clip->low.x, -1, 1e-4);
    EXPECT_NEAR(outer.clip->high.x, 11, 1e-4);
  }
}

TEST_F(SkeletonTest, APlaneInTheWorldOrInAnUnboundedListIsNotClipped) {
  Plane();
  Begin();
  Plane();
  End();
  Sphere(0);
  for (const Placement& placement : skeleton.Expand(0).placements) EXPECT_TRUE(placement.plain);
}

TEST_F(SkeletonTest, AnInstanceClipsThePlanesOfItsDefinition) {
  skeleton.BeginDefinition();
  Begin();
  Plane();
  Sphere(0);
  End();
  const DefinitionId named = skeleton.EndDefinition();
  skeleton.AddInstance(named, Shift(7));
  int clipped = 0;
  for (const Placement& placement : skeleton.Expand(0).placements) {
    for (const PathLevel& level : placement.levels) {
      if (!level.clip) continue;
      ++clipped;
      EXPECT_NEAR(level.clip->low.x, 6, 1e-4);
    }
  }
  EXPECT_EQ(clipped, 1);
}

TEST_F(SkeletonTest, CsgWithEverythingInItIsOneObject) {
  Begin(AggregateKind::kDifference);
  Begin(AggregateKind::kUnion);
  Sphere(0);
  Sphere(1);
  EXPECT_TRUE(End(Shift(3)));
  Begin();
  Sphere(2);
  EXPECT_TRUE(End());
  EXPECT_TRUE(End(Shift(4)));
  ASSERT_EQ(store.objects.size(), 1u);
  const auto& difference = std::get<CompositeSpec>(store.objects[0].spec);
  EXPECT_EQ(difference.kind, AggregateKind::kDifference);
  ASSERT_EQ(difference.members->size(), 2u);
  const PlacedSpec& first = difference.members->front();
  EXPECT_EQ(std::get<CompositeSpec>(first.geom).members->size(), 2u);
  EXPECT_EQ(first.attributes.transforms, Shift(3).transforms);
  EXPECT_EQ(skeleton.Expand(0).placements[0].levels[0].attributes.transforms, Shift(4).transforms);
}

TEST_F(SkeletonTest, InstancesInsideCsgBringTheirContent) {
  const SurfaceId red = skeleton.AddSurface({});
  skeleton.BeginDefinition();
  Begin();
  Sphere(0, red);
  Sphere(1);
  End(Shift(1));
  const DefinitionId pair = skeleton.EndDefinition();
  skeleton.BeginDefinition();
  skeleton.AddInstance(pair, Shift(2));
  const DefinitionId again = skeleton.EndDefinition();

  Begin(AggregateKind::kIntersect);
  skeleton.AddInstance(again, With(red));
  Sphere(5);
  EXPECT_TRUE(End());
  const auto& intersect = std::get<CompositeSpec>(store.objects.back().spec);
  const PlacedSpec& outer = intersect.members->front();
  // The shift by 2 and the shift by 1 are two levels; the surface joins the outer one.
  EXPECT_EQ(outer.attributes.transforms, Shift(2).transforms);
  EXPECT_EQ(outer.attributes.surface, red);
  const PlacedSpec& inner = std::get<CompositeSpec>(outer.geom).members->front();
  EXPECT_EQ(inner.attributes.transforms, Shift(1).transforms);
  const auto& list = std::get<CompositeSpec>(inner.geom);
  ASSERT_EQ(list.members->size(), 2u);
  EXPECT_EQ(list.members->front().attributes.surface, red);
  EXPECT_EQ(std::get<SphereSpec>(list.members->back().geom).center.x, 1);
  EXPECT_EQ(skeleton.Expand(0).objects, 1u);
}

TEST_F(SkeletonTest, CsgWithAnyNumberOfOperandsButTwoIsDropped) {
  for (int operands : {0, 1, 3}) {
    Begin(AggregateKind::kUnion);
    for (int i = 0; i < operands; ++i) Sphere(i);
    EXPECT_FALSE(End()) << operands;
  }
  EXPECT_EQ(store.objects.size(), 0u);
}

TEST_F(SkeletonTest, GlassInsideCsgIsNoticed) {
  Surface glass;
  glass.transp = 1;
  const SurfaceId id = skeleton.AddSurface(glass);
  Sphere(0);
  EXPECT_FALSE(skeleton.Spec({}).transparent_inside) << "a surface that nothing uses";
  Begin(AggregateKind::kUnion);
  Sphere(1, id);
  Sphere(2);
  End();
  EXPECT_TRUE(skeleton.Spec({}).transparent_inside);
}

TEST_F(SkeletonTest, InstancesOfInstancesBeyondAllRanksAreRefused) {
  skeleton.BeginDefinition();
  Sphere(0);
  DefinitionId named = skeleton.EndDefinition();
  for (int level = 0; level < 12; ++level) {
    skeleton.BeginDefinition();
    Begin();
    for (int i = 0; i < 10; ++i) skeleton.AddInstance(named, {});
    End();
    named = skeleton.EndDefinition();
  }
  skeleton.AddInstance(named, {});
  EXPECT_THROW(skeleton.Expand(0), std::runtime_error);
}

}  // namespace
}  // namespace rayshade
