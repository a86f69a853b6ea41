// The tables of checked values in the description of Rayshade's geometry [rayshade4/2 s.6].
#include <cmath>

#include "tests/geom/probe.h"

namespace rayshade {
namespace {

struct Row {
  Vector origin, direction;
  double distance, u, v;
};

void ExpectRows(const GeomSpec& spec, const std::vector<Row>& rows) {
  const auto geom = MakeGeom(spec);
  for (const Row& row : rows) {
    const Probe probe = ShootAt(*geom, row.origin, row.direction);
    ASSERT_TRUE(probe.hit);
    EXPECT_DOUBLE_EQ(row.distance, probe.distance);
    EXPECT_NEAR(row.u, probe.uv.u, 1e-12);
    EXPECT_NEAR(row.v, probe.uv.v, 1e-12);
  }
}

TEST(Sphere, HasTheDistancesAndCoordinatesOfTheTable) {
  ExpectRows(SphereSpec{2, {}}, {
                                    {{10, 0, 0}, {-1, 0, 0}, 8, 1, 0.5},
                                    {{0, 10, 0}, {0, -1, 0}, 8, 0.25, 0.5},
                                    {{0, -10, 0}, {0, 1, 0}, 8, 0.75, 0.5},
                                    {{-10, 0, 0}, {1, 0, 0}, 8, 0.5, 0.5},
                                });
  const Probe probe = ShootAt(SphereSpec{2, {}}, {10, 1, 1}, {-1, 0, 0});
  EXPECT_DOUBLE_EQ(8.5857864376269042, probe.distance);
  EXPECT_NEAR(0.0979566380077, probe.uv.u, 1e-12);
  EXPECT_NEAR(0.666666666667, probe.uv.v, 1e-12);
  ExpectNear({-.577350269, .816496581, 0}, probe.uv.du);
  ExpectNear({-.40824829, -.288675135, .866025404}, probe.uv.dv);
}

TEST(Sphere, IsHitByATangentRay) {
  const Probe probe = ShootAt(SphereSpec{1, {}}, {1, -5, 0}, {0, 1, 0});
  ASSERT_TRUE(probe.hit);
  EXPECT_DOUBLE_EQ(5, probe.distance);
}

TEST(Disc, HasTheCoordinatesOfTheTable) {
  ExpectRows(DiscSpec{2, {}, {0, 0, 1}}, {
                                             {{1, 0, 5}, {0, 0, -1}, 5, 0, .5},
                                             {{0, 1, 5}, {0, 0, -1}, 5, .25, .5},
                                             {{0, -1, 5}, {0, 0, -1}, 5, .75, .5},
                                             {{-1, 0, 5}, {0, 0, -1}, 5, .5, .5},
                                         });
  Probe probe = ShootAt(DiscSpec{2, {}, {0, 0, 1}}, {1, 0, 5}, {0, 0, -1});
  ExpectNear({0, -1, 0}, probe.uv.du);
  ExpectNear({1, 0, 0}, probe.uv.dv);
  probe = ShootAt(DiscSpec{2, {1, 2, 3}, {0, 0, 1}}, {2, 3, 9}, {0, 0, -1});
  EXPECT_DOUBLE_EQ(.5, probe.uv.u);
  EXPECT_NEAR(.70710678, probe.uv.v, 1e-8);
  ExpectNear({1, -1, 0}, probe.uv.du);
  ExpectNear({1, 1, 0}, probe.uv.dv);
  probe = ShootAt(DiscSpec{2, {1, 2, 3}, {0, 0, 1}}, {1.001, 2, 9}, {0, 0, -1});
  EXPECT_EQ(0, probe.uv.u);
  EXPECT_EQ(0, probe.uv.v);
}

TEST(Triangle, HasTheCoordinatesOfTheTable) {
  Probe probe = ShootAt(TriangleSpec{{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}}}, {1, .5, 3}, {0, 0, -1});
  EXPECT_DOUBLE_EQ(1.0 / 3, probe.uv.u);
  EXPECT_DOUBLE_EQ(.25, probe.uv.v);
  ExpectNear({1, 0, 0}, probe.uv.du);
  ExpectNear({-.894427191, -.447213595, 0}, probe.uv.dv);
  probe = ShootAt(TriangleSpec{{{0, 0, 0}, {0, 2, 0}, {4, 0, 0}}}, {1, .5, 3}, {0, 0, -1});
  EXPECT_DOUBLE_EQ(1.0 / 3, probe.uv.u);
  EXPECT_DOUBLE_EQ(.25, probe.uv.v);
  ExpectNear({0, -1, 0}, probe.uv.du);
  ExpectNear({-.894427191, -.447213595, 0}, probe.uv.dv);
}

TEST(Cylinder, HasTheDistancesAndCoordinatesOfTheTable) {
  ExpectRows(CylinderSpec{2, {}, {0, 0, 4}}, {
                                                 {{10, 0, 1}, {-1, 0, 0}, 8, 0, .25},
                                                 {{0, 10, 1}, {0, -1, 0}, 8, .25, .25},
                                                 {{0, -10, 1}, {0, 1, 0}, 8, .75, .25},
                                                 {{-10, 0, 1}, {1, 0, 0}, 8, .5, .25},
                                                 {{10, 0, 4}, {-1, 0, 0}, 8, 0, 1},
                                                 {{10, 0, 0}, {-1, 0, 0}, 8, 0, 0},
                                             });
  ExpectRows(CylinderSpec{2, {}, {4, 0, 0}}, {
                                                 {{1, 0, 10}, {0, 0, -1}, 8, .5, .25},
                                                 {{1, 10, 0}, {0, -1, 0}, 8, .25, .25},
                                                 {{1, -10, 0}, {0, 1, 0}, 8, .75, .25},
                                             });
  ExpectRows(CylinderSpec{1, {}, {0, 0, -10}}, {
                                                   {{5, 0, -3}, {-1, 0, 0}, 4, 0, .3},
                                                   {{0, 5, -3}, {0, -1, 0}, 4, .75, .3},
                                               });
}

TEST(Cylinder, TurnsAxesWithinAQuarterDegreeOfZTowardsYAsRayshadeDoes) {
  const CylinderSpec tilted{.01, {}, {.04, 0, 10}};
  EXPECT_TRUE(ShootAt(tilted, {0, 5, 9.99}, {0, -1, 0}).hit);
  EXPECT_NEAR(4.95, ShootAt(tilted, {0, 5, 9.99}, {0, -1, 0}).distance, 1e-3);
  EXPECT_FALSE(ShootAt(tilted, {.04, 5, 9.99}, {0, -1, 0}).hit);
}

TEST(Cone, HasTheDistancesAndCoordinatesOfTheTable) {
  const ConeSpec cone{2, {}, 1, {0, 0, 4}};
  ExpectRows(cone, {
                       {{10, 0, 1}, {-1, 0, 0}, 8.25, 0, .75},
                       {{0, 10, 1}, {0, -1, 0}, 8.25, .75, .75},
                       {{0, -10, 1}, {0, 1, 0}, 8.25, .25, .75},
                   });
  ExpectNear({.970142500145, 0, .242535625036}, ShootAt(cone, {10, 0, 1}, {-1, 0, 0}).path.normal,
             1e-12);
}

TEST(Box, IsLeftAtTheFarFaceWhereTheNearFaceIsWithinTheLeastDistance) {
  const BoxSpec box{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_DOUBLE_EQ(2 + 9e-6, ShootAt(box, {0, 0, 1 + 9e-6}, {0, 0, -1}).distance);
  EXPECT_NEAR(1.1e-5, ShootAt(box, {0, 0, 1 + 1.1e-5}, {0, 0, -1}).distance, 1e-15);
}

TEST(Box, HasTheNormalOfTheEarlierAxisInAStripAlongItsEdges) {
  const BoxSpec box{{-1, -1, -1}, {1, 1, 1}};
  ExpectNear({1, 0, 0}, ShootAt(box, {.999995, 0, 5}, {0, 0, -1}).path.normal);
  ExpectNear({0, 0, 1}, ShootAt(box, {.99998, 0, 5}, {0, 0, -1}).path.normal);
}

TEST(Polygon, OwnsItsUpperEdgesAndCorner) {
  const PolygonSpec polygon{{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}}};
  const auto geom = MakeGeom(polygon);
  const auto hit = [&](double x, double y) { return ShootAt(*geom, {x, y, 3}, {0, 0, -1}).hit; };
  EXPECT_TRUE(hit(4, 1) && hit(1, 2) && hit(4, 2));
  EXPECT_FALSE(hit(0, 1) || hit(1, 0) || hit(0, 0) || hit(4, 0) || hit(0, 2));
}

TEST(Polygon, CoversTheCentreOfAPentagram) {
  PolygonSpec star;
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * kPi * (2 * i) / 5;
    star.points.push_back({std::cos(angle), std::sin(angle), 0});
  }
  EXPECT_TRUE(ShootAt(star, {0, 0, 3}, {0, 0, -1}).hit);
  EXPECT_FALSE(ShootAt(star, {-.6, 0, 3}, {0, 0, -1}).hit);
}

TEST(Torus, HasTheDistancesAndCoordinatesOfTheTable) {
  const TorusSpec torus{3, 1, {}, {0, 0, 1}};
  ExpectRows(torus, {
                        {{10, 0, 0}, {-1, 0, 0}, 6, 0, .5},
                        {{3, 0, 10}, {0, 0, -1}, 9, 0, .75},
                        {{3, 0, -10}, {0, 0, 1}, 9, 0, .25},
                    });
  EXPECT_NEAR(2, ShootAt(torus, {}, {1, 0, 0}).distance, 1e-14);
  Probe probe = ShootAt(torus, {10, 0, 0}, {-1, 0, 0});
  ExpectNear({0, 1, 0}, probe.uv.du);
  ExpectNear({0, 0, 1}, probe.uv.dv);
  ExpectNear({0, 0, -1}, ShootAt(torus, {}, {1, 0, 0}).uv.dv);
  ExpectNear({-1, 0, 0}, ShootAt(torus, {3, 0, 10}, {0, 0, -1}).uv.dv);
  probe = ShootAt(torus, {0, 10, .5}, {0, -1, 0});
  EXPECT_NEAR(6.1339745962155616, probe.distance, 1e-13);
  EXPECT_NEAR(.25, probe.uv.u, 1e-12);
  EXPECT_NEAR(.583333333333, probe.uv.v, 1e-12);
  ExpectNear({-1, 0, 0}, probe.uv.du);
  ExpectNear({0, -.5, .866025404}, probe.uv.dv);
}

TEST(TriangleUv, HasTheCoordinatesAndTangentsOfTheTable) {
  struct UvRow {
    double uv[3][2], u, v;
    Vector du, dv;
  };
  const UvRow rows[] = {
      {{{0, 0}, {1, 0}, {0, 1}}, .25, .25, {1, 0, 0}, {0, 1, 0}},
      {{{0, 0}, {.5, .5}, {0, 1}}, .125, .375, {.9701425, -.242535625, 0}, {0, 1, 0}},
      {{{1, 0}, {0, 0}, {1, 1}}, .75, .25, {-1, 0, 0}, {0, 1, 0}},
      {{{1, 0}, {0, 0}, {1, 0}}, .75, 0, {0, 0, 0}, {0, 1, 0}},
  };
  for (const UvRow& row : rows) {
    TriangleUvSpec spec{{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
    for (int i = 0; i < 3; ++i) std::copy(row.uv[i], row.uv[i] + 2, spec.uv[i]);
    const Probe probe = ShootAt(spec, {1, .5, 3}, {0, 0, -1});
    EXPECT_DOUBLE_EQ(row.u, probe.uv.u);
    EXPECT_DOUBLE_EQ(row.v, probe.uv.v);
    ExpectNear(row.du, probe.uv.du, 1e-7);
    ExpectNear(row.dv, probe.uv.dv, 1e-7);
  }
}

TEST(PhongTriangle, BlendsNormalsAndTurnsItsPlaneTowardsThem) {
  PhongTriangleSpec spec{{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}}, {{0, 0, -1}, {0, 0, -2}, {0, -1, -1}}};
  const auto geom = MakeGeom(spec);
  HitPath path;
  geom->Describe({{1, .5, 3}, {0, 0, -1}, {}}, kEpsilon, 3, &path);
  EXPECT_TRUE(path.smooth);
  ExpectNear({0, 0, -1}, path.geometric_normal);
  const double part = .25 / std::sqrt(2);
  ExpectNear(Normalized({0, -part, -.75 - part}), path.normal);
}

TEST(Plane, HasTheAxesAcrossItsNormalAsCoordinates) {
  const PlaneSpec plane{{1, 0, 0}, {0, 0, 1}};
  const Probe above = ShootAt(plane, {3, 2, 5}, {0, 0, -1});
  EXPECT_DOUBLE_EQ(2, above.uv.u);
  EXPECT_DOUBLE_EQ(2, above.uv.v);
  const Probe below = ShootAt(plane, {3, 2, -5}, {0, 0, 1});
  EXPECT_DOUBLE_EQ(-2, below.uv.u);
  EXPECT_DOUBLE_EQ(2, below.uv.v);
}

TEST(Plane, VanishesWithinTheGrazingAngle) {
  const PlaneSpec plane{{}, {0, 0, 1}};
  EXPECT_FALSE(ShootAt(plane, {0, 0, 1}, {0, 1, -.99e-5}).hit);
  EXPECT_TRUE(ShootAt(plane, {0, 0, 1}, {0, 1, -1.01e-5}).hit);
}

TEST(Heightfield, HasAltitudesInRowsAndAlwaysIncludesZero) {
  HeightfieldSpec field{"", 2,
                        std::make_shared<std::vector<float>>(std::vector<float>{1, 2, 3, 5})};
  EXPECT_EQ((Bounds{{0, 0, 0}, {1, 1, 5}}), BoundsOf(field));
  const auto geom = MakeGeom(field);
  EXPECT_NEAR(10 - 1.5, ShootAt(*geom, {.5, 1e-9, 10}, {0, 0, -1}).distance, 1e-6);
  EXPECT_NEAR(10 - 2.5, ShootAt(*geom, {.5, .5, 10}, {0, 0, -1}).distance, 1e-9);
  EXPECT_NEAR(10 - 3.25, ShootAt(*geom, {.75, .625, 10}, {0, 0, -1}).distance, .2);
  ExpectNear(Normalized({-1, -2, 1}), ShootAt(*geom, {.2, .2, 10}, {0, 0, -1}).path.normal);
}

TEST(Heightfield, HasHolesBelowMinusThousand) {
  HeightfieldSpec field{"", 2,
                        std::make_shared<std::vector<float>>(std::vector<float>{-1000, 0, 0, 0})};
  const auto geom = MakeGeom(field);
  EXPECT_FALSE(ShootAt(*geom, {.2, .2, 10}, {0, 0, -1}).hit);
  EXPECT_TRUE(ShootAt(*geom, {.8, .8, 10}, {0, 0, -1}).hit);
}

}  // namespace
}  // namespace rayshade
