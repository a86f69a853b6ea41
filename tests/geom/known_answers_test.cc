// The tables of checked values in the description of Rayshade's geometry [rayshade4/2 s.6].
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

}  // namespace
}  // namespace rayshade
