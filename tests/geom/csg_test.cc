// Constructive solid geometry: the table of checked rays, and sampled rays against membership of
// points [rayshade4/2 s.9].
#include <cmath>
#include <random>

#include "tests/geom/probe.h"

namespace rayshade {
namespace {

PlacedSpec Place(GeomSpec geom, SurfaceId surface = kNoSurface) {
  PlacedSpec placed{std::move(geom), {}};
  placed.attributes.surface = surface;
  return placed;
}

CompositeSpec Combine(AggregateKind kind, std::vector<PlacedSpec> members) {
  CompositeSpec spec;
  spec.kind = kind;
  spec.members = std::make_shared<std::vector<PlacedSpec>>(std::move(members));
  return spec;
}

constexpr SurfaceId kA = 7, kB = 8;

struct Row {
  double x, direction;
  double distance;  // 0: miss
  SurfaceId surface = kNoSurface;
  Stamp stamp = Stamp::kNone;
};

void ExpectRows(AggregateKind kind, const std::vector<Row>& rows) {
  const auto geom =
      MakeGeom(Combine(kind, {Place(SphereSpec{1, {}}, kA), Place(SphereSpec{1, {1, 0, 0}}, kB)}));
  for (const Row& row : rows) {
    const Probe probe = ShootAt(*geom, {row.x, 0, 0}, {row.direction, 0, 0});
    ASSERT_EQ(row.distance != 0, probe.hit);
    if (!probe.hit) continue;
    EXPECT_DOUBLE_EQ(row.distance, probe.distance);
    ASSERT_EQ(1u, probe.path.inner.size());
    EXPECT_EQ(row.surface, probe.path.inner[0]->surface);
    EXPECT_EQ(row.stamp, probe.path.stamp);
  }
}

TEST(Csg, UnionHasTheHitsOfTheTable) {
  ExpectRows(AggregateKind::kUnion, {{-5, 1, 4, kA, Stamp::kEntering},
                                     {-.5, 1, 2.5, kB, Stamp::kLeaving},
                                     {.5, 1, 1.5, kB, Stamp::kLeaving},
                                     {5, -1, 3, kB, Stamp::kEntering}});
}

TEST(Csg, IntersectionHasTheHitsOfTheTable) {
  ExpectRows(AggregateKind::kIntersect, {{-5, 1, 5, kB, Stamp::kEntering},
                                         {-.5, 1, .5, kB, Stamp::kEntering},
                                         {.5, 1, .5, kA, Stamp::kLeaving},
                                         {5, -1, 4, kA, Stamp::kEntering}});
}

TEST(Csg, DifferenceHasTheHitsOfTheTable) {
  ExpectRows(AggregateKind::kDifference, {{-5, 1, 4, kA, Stamp::kEntering},
                                          {-.5, 1, .5, kB, Stamp::kLeaving},
                                          {.5, 1, 0},
                                          {5, -1, 5, kB, Stamp::kEntering}});
}

TEST(Csg, ShowsTheFirstOperandOfAUnionAndTheSecondOfAnIntersectionOfIdenticalObjects) {
  const std::vector<PlacedSpec> same{Place(SphereSpec{1, {}}, kA), Place(SphereSpec{1, {}}, kB)};
  const auto geom = MakeGeom(Combine(AggregateKind::kUnion, same));  // the path points into it
  const Probe both = ShootAt(*geom, {-5, 0, 0}, {1, 0, 0});
  ASSERT_TRUE(both.hit);
  EXPECT_EQ(kA, both.path.inner[0]->surface);
  EXPECT_FALSE(ShootAt(Combine(AggregateKind::kDifference, same), {-5, .1, 0}, {1, 0, 0}).hit);
}

TEST(Csg, ReportsTheAttributesOfTheMembersPassedInnermostFirst) {
  PlacedSpec ball = Place(SphereSpec{1, {}}, kA);
  ball.attributes.transforms.Append(*Scale({2, 2, 2}));
  PlacedSpec list = Place(Combine(AggregateKind::kList, {ball}), kB);
  list.attributes.transforms.Append(Translate({10, 0, 0}));
  const auto geom =
      MakeGeom(Combine(AggregateKind::kUnion, {list, Place(BoxSpec{{-1, -1, -1}, {1, 1, 1}})}));
  const Probe probe = ShootAt(*geom, {10, 0, 9}, {0, 0, -1});
  ASSERT_TRUE(probe.hit);
  EXPECT_DOUBLE_EQ(7, probe.distance);
  ASSERT_EQ(2u, probe.path.inner.size());
  EXPECT_EQ(kA, probe.path.inner[0]->surface);
  EXPECT_EQ(kB, probe.path.inner[1]->surface);
  ExpectNear({0, 0, 1}, probe.path.point);
  EXPECT_DOUBLE_EQ(3.5, probe.path.distance);
  EXPECT_NEAR(-1, geom->bounds().low.x, 1e-4);
  EXPECT_NEAR(12, geom->bounds().high.x, 1e-4);
}

TEST(Csg, OfAPlaneAndABallIsUnboundedOnlyWhereHitsCanBeAnywhere) {
  const std::vector<PlacedSpec> members{Place(PlaneSpec{{}, {0, 0, 1}}), Place(SphereSpec{1, {}})};
  EXPECT_FALSE(IsBounded(Combine(AggregateKind::kUnion, members)));
  EXPECT_FALSE(IsBounded(Combine(AggregateKind::kDifference, members)));
  EXPECT_TRUE(IsBounded(Combine(AggregateKind::kIntersect, members)));
  const auto with_hole = MakeGeom(Combine(AggregateKind::kDifference, members));
  EXPECT_TRUE(ShootAt(*with_hole, {2, 0, 5}, {0, 0, -1}).hit);
  EXPECT_FALSE(ShootAt(*with_hole, {.2, 0, 5}, {0, 0, -1}).hit);
}

TEST(Csg, DoesNotHangWhereTheStepIsLostInRounding) {
  const std::vector<PlacedSpec> members{Place(DiscSpec{1e12, {0, 0, 3e11}, {0, 0, 1}}),
                                        Place(DiscSpec{1e12, {0, 0, 3e11}, {0, 0, -1}})};
  for (const auto kind :
       {AggregateKind::kUnion, AggregateKind::kIntersect, AggregateKind::kDifference}) {
    const auto geom = MakeGeom(Combine(kind, members));
    ShootAt(*geom, {}, {0, 0, 1});
    ShootAt(*geom, {0, 0, 6e11}, {0, 0, -1});
  }
}

// A nested solid and its points.
TEST(Csg, AgreesWithMembershipOfPointsOnSampledRays) {
  const auto in_ball = [](Vector p, Vector c, double r) { return Dot(p - c, p - c) < r * r; };
  const auto inside = [&](const Vector& p) {
    const bool box = std::abs(p.x) < 1 && std::abs(p.y) < 1 && std::abs(p.z) < 1;
    const bool balls = in_ball(p, {1, 1, 0}, .9) || in_ball(p, {0, 0, 1}, .7);
    return box && !balls && in_ball(p, {}, 1.3);
  };
  const auto solid = MakeGeom(Combine(
      AggregateKind::kIntersect,
      {Place(Combine(AggregateKind::kDifference,
                     {Place(BoxSpec{{-1, -1, -1}, {1, 1, 1}}),
                      Place(Combine(AggregateKind::kUnion, {Place(SphereSpec{.9, {1, 1, 0}}),
                                                            Place(SphereSpec{.7, {0, 0, 1}})}))})),
       Place(SphereSpec{1.3, {}})}));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector origin{coordinate(random), coordinate(random), coordinate(random)};
    const Vector direction =
        Normalized({coordinate(random), coordinate(random), coordinate(random)});
    const Probe probe = ShootAt(*solid, origin, direction);
    const double end = probe.hit ? probe.distance : 8;
    constexpr double kStep = .02;
    const bool start = inside(origin + 1e-4 * direction);
    for (double t = kStep; t < end - 1e-6; t += kStep) {
      // Membership may differ for features thinner than the step only; it must not differ here.
      ASSERT_EQ(start, inside(origin + t * direction)) << "ray " << i << " at " << t;
    }
    if (!probe.hit) continue;
    ++hits;
    EXPECT_EQ(start, inside(origin + (end - 1e-7) * direction)) << "ray " << i;
    EXPECT_NE(start, inside(origin + (end + 1e-7) * direction)) << "ray " << i;
    EXPECT_EQ(start ? Stamp::kLeaving : Stamp::kEntering, probe.path.stamp);
  }
  EXPECT_GT(hits, 500);
}

TEST(Csg, CutsHeightfields) {
  const auto flat = std::make_shared<std::vector<float>>(100, .5f);
  const auto geom =
      MakeGeom(Combine(AggregateKind::kDifference, {Place(HeightfieldSpec{"", 10, flat}),
                                                    Place(SphereSpec{.2, {.5, .5, .5}})}));
  EXPECT_TRUE(ShootAt(*geom, {.1, .1, 3}, {0, 0, -1}).hit);
  EXPECT_FALSE(ShootAt(*geom, {.5, .52, 3}, {0, 0, -1}).hit);
}

// As shadow rays through glass do: each search begins just behind the last hit.
TEST(Csg, IsCrossedInOrderByARayThatGoesOnFromEachHit) {
  PlacedSpec ball = Place(SphereSpec{.3, {}});
  ball.attributes.transforms.Append(*Scale({3, 3, 3}));
  PlacedSpec box = Place(BoxSpec{{-.1, -.2, -.3}, {.1, .2, .3}});
  bool degenerate;
  box.attributes.transforms.Append(*Rotate({1, 2, 3}, 40, &degenerate));
  box.attributes.transforms.Append(*Scale({7, 7, 7}));
  const auto solid = MakeGeom(Combine(AggregateKind::kUnion, {ball, box}));
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Vector target{coordinate(random), coordinate(random), coordinate(random)};
    const Vector direction =
        Normalized({coordinate(random), coordinate(random), coordinate(random)});
    const ObjectRay ray{target - 9 * direction, direction, {}};
    double min = kEpsilon, s;
    int crossings = 0;
    while (solid->Intersect(ray, min, kFar, &s)) {
      ASSERT_GE(s, min);
      HitPath path;
      solid->Describe(ray, min, s, &path);
      EXPECT_EQ(crossings % 2 == 0 ? Stamp::kEntering : Stamp::kLeaving, path.stamp) << i;
      min = std::nextafter(s, kFar);
      ASSERT_LT(++crossings, 9);
    }
    EXPECT_EQ(0, crossings % 2) << i;
  }
}

TEST(Csg, PassesThroughToAnimatedMembersAtTheRaysMoment) {
  PlacedSpec ball = Place(SphereSpec{1, {}});
  AnimatedTransform move;
  move.kind = TransformKind::kTranslate;
  move.arguments = {Expression({{ExpressionOp::kTime}}), Expression(0.0), Expression(0.0)};
  ball.attributes.transforms.Append(move);
  const CompositeSpec spec =
      Combine(AggregateKind::kUnion, {ball, Place(SphereSpec{.1, {0, 0, -5}})});
  const auto geom = MakeGeom(spec, {0, 0, 4});
  EXPECT_NEAR(5, geom->bounds().high.x, 1e-4);
  EXPECT_NEAR(-1, geom->bounds().low.x, 1e-4);
  double s;
  EXPECT_FALSE(geom->Intersect({{3, 0, 9}, {0, 0, -1}, {0, 0}}, kEpsilon, kFar, &s));
  EXPECT_TRUE(geom->Intersect({{3, 0, 9}, {0, 0, -1}, {0, 3}}, kEpsilon, kFar, &s));
  EXPECT_DOUBLE_EQ(8, s);
}

}  // namespace
}  // namespace rayshade
