// Distance and size cost no digits; rays that leave a surface do not meet it where they begin.
#include <cmath>
#include <functional>
#include <random>

#include "rayshade/geom/quartic.h"
#include "tests/geom/probe.h"

namespace rayshade {
namespace {

using Random = std::mt19937_64;

Vector RandomDirection(Random* random) {
  std::normal_distribution<double> normal;
  return Normalized({normal(*random), normal(*random), normal(*random)});
}

struct Kind {
  const char* name;
  GeomSpec spec;                                  // of size about 1 around the origin
  std::function<long double(const Vector&)> off;  // distance from the surface, about
};

long double Hypot(long double x, long double y) { return std::sqrt(x * x + y * y); }

std::vector<Kind> Kinds(double size) {
  const auto to = [size](const Vector& p) { return Vector{p.x / size, p.y / size, p.z / size}; };
  return {
      {"sphere", SphereSpec{size, {}}, [=](const Vector& p) { return Length(to(p)) - 1.0L; }},
      {"cylinder", CylinderSpec{size, {0, 0, -size}, {0, 0, size}},
       [=](const Vector& p) { return Hypot(to(p).x, to(p).y) - 1; }},
      {"cone", ConeSpec{size, {0, 0, -size}, size / 5, {0, 0, size}},
       [=](const Vector& p) { return Hypot(to(p).x, to(p).y) - (0.6L - 0.4L * to(p).z); }},
      {"torus", TorusSpec{.75 * size, .25 * size, {}, {0, 0, 1}},
       [=](const Vector& p) { return Hypot(Hypot(to(p).x, to(p).y) - .75L, to(p).z) - .25L; }},
      {"blob", BlobSpec{.25, {{1, size, {}}}},
       [=](const Vector& p) { return Length(to(p)) - std::sqrt(0.5L); }},
      {"box", BoxSpec{{-size, -size, -size}, {size, size, size}},
       [=](const Vector& p) {
         return std::max({std::abs(to(p).x), std::abs(to(p).y), std::abs(to(p).z)}) - 1.0L;
       }},
  };
}

// Rays from `far` object sizes away towards points within the object; the hit is off the surface by
// no more than rounding of its coordinates explains.
TEST(Stability, HitsLieOnTheSurfaceFromAnyDistance) {
  for (const double far : {1e1, 1e3, 1e6, 1e8}) {
    for (const Kind& kind : Kinds(1)) {
      const auto geom = MakeGeom(kind.spec);
      Random random(1);
      std::uniform_real_distribution<double> coordinate(-.6, .6);
      int hits = 0;
      for (int i = 0; i < 400; ++i) {
        const Vector target{coordinate(random), coordinate(random), coordinate(random)};
        const Vector direction = RandomDirection(&random);
        const Vector origin = target - far * direction;
        double s;
        if (!geom->Intersect({origin, direction, {}}, kEpsilon, kFar, &s)) continue;
        ++hits;
        const Vector p = origin + s * direction;
        ASSERT_LT(std::abs(static_cast<double>(kind.off(p))), 1e-11 + 4e-15 * far)
            << kind.name << " at " << far;
      }
      EXPECT_GT(hits, 100) << kind.name << " at " << far;
    }
  }
}

TEST(Stability, HitsLieOnTheSurfaceAtAnySize) {
  for (const double size : {1e-3, 1e-2, 1.0, 1e3, 1e6, 1e9}) {
    for (const Kind& kind : Kinds(size)) {
      const auto geom = MakeGeom(kind.spec);
      Random random(2);
      std::uniform_real_distribution<double> coordinate(-.6 * size, .6 * size);
      int hits = 0;
      for (int i = 0; i < 400; ++i) {
        const Vector target{coordinate(random), coordinate(random), coordinate(random)};
        const Vector direction = RandomDirection(&random);
        const Vector origin = target - 10 * size * direction;
        const Probe probe = ShootAt(*geom, origin, direction);
        if (!probe.hit) continue;
        ++hits;
        ASSERT_LT(std::abs(static_cast<double>(kind.off(probe.path.point))), 1e-11)
            << kind.name << " of size " << size;
        ASSERT_NEAR(1, Length(probe.path.normal), 1e-9) << kind.name << " of size " << size;
      }
      EXPECT_GT(hits, 100) << kind.name << " of size " << size;
    }
  }
}

// As many hits as a search by sampling finds: no root is lost, none invented.
TEST(Stability, EveryCrossingIsFoundOnceInOrder) {
  for (const Kind& kind : Kinds(1)) {
    if (std::string(kind.name) == "cylinder" || std::string(kind.name) == "cone") continue;
    const auto geom = MakeGeom(kind.spec);
    Random random(3);
    std::uniform_real_distribution<double> coordinate(-.9, .9);
    for (int i = 0; i < 200; ++i) {
      const Vector target{coordinate(random), coordinate(random), coordinate(random)};
      const Vector direction = RandomDirection(&random);
      const Vector origin = target - 5 * direction;
      int sampled = 0;
      bool grazing = false;
      constexpr double kStep = 2e-3;
      long double last = kind.off(origin);
      for (double t = kStep; t < 10; t += kStep) {
        const long double now = kind.off(origin + t * direction);
        sampled += (now < 0) != (last < 0);
        grazing = grazing || std::abs(now) < 2e-6;
        last = now;
      }
      if (grazing) continue;
      int found = 0;
      double min = kEpsilon, s;
      while (geom->Intersect({origin, direction, {}}, min, kFar, &s)) {
        ++found;
        ASSERT_GT(s, min);
        min = s + 1e-9;
      }
      // Pairs of crossings nearer to each other than the step may be missed by sampling.
      EXPECT_EQ(0, (found - sampled) % 2) << kind.name << " ray " << i;
      EXPECT_GE(found, sampled) << kind.name << " ray " << i;
      EXPECT_LE(found, sampled + (sampled == found ? 0 : 2)) << kind.name << " ray " << i;
    }
  }
}

TEST(Stability, RaysThatLeaveASurfaceDoNotMeetItWhereTheyBegin) {
  for (const double size : {1e-2, 1.0, 1e2, 1e4}) {
    for (const Kind& kind : Kinds(size)) {
      const auto geom = MakeGeom(kind.spec);
      Random random(4);
      std::uniform_real_distribution<double> coordinate(-.6 * size, .6 * size);
      for (int i = 0; i < 300; ++i) {
        const Vector target{coordinate(random), coordinate(random), coordinate(random)};
        const Vector direction = RandomDirection(&random);
        const Probe probe = ShootAt(*geom, target - 10 * size * direction, direction);
        if (!probe.hit) continue;
        const Vector n = probe.path.geometric_normal;
        for (int k = 0; k < 10; ++k) {
          Vector away = RandomDirection(&random);
          if (std::abs(Dot(away, n)) < .05) continue;
          double s;
          if (!geom->Intersect({probe.path.point, away, {}}, kEpsilon, kFar, &s)) continue;
          ASSERT_GT(s, 1e-3 * size) << kind.name << " of size " << size;
        }
      }
    }
  }
}

TEST(Stability, NoRayHoweverFarOrObliqueGetsADistanceThatIsNoNumber) {
  const double magnitudes[] = {0, 5e-324, 1e-300, 1e-12, 1, 1e12, 1e150, 1e300};
  std::vector<Kind> kinds = Kinds(1);
  kinds.push_back({"triangle", TriangleSpec{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {}});
  kinds.push_back({"polygon", PolygonSpec{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}, {}});
  kinds.push_back({"plane", PlaneSpec{{}, {0, 0, 1}}, {}});
  kinds.push_back({"disc", DiscSpec{1, {}, {0, 0, 1}}, {}});
  kinds.push_back(
      {"heightfield", HeightfieldSpec{"", 3, std::make_shared<std::vector<float>>(9, .5f)}, {}});
  for (const Kind& kind : kinds) {
    const auto geom = MakeGeom(kind.spec);
    Random random(8);
    for (int i = 0; i < 3000; ++i) {
      const auto some = [&] {
        const double size = magnitudes[random() % std::size(magnitudes)];
        return random() % 2 ? size : -size;
      };
      const Vector origin{some(), some(), some()};
      Vector direction = i % 2 ? Vector{some(), some(), some()} : -origin;
      const double largest =
          std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
      if (largest == 0) continue;
      direction = Normalized({direction.x / largest, direction.y / largest, direction.z / largest});
      const Probe probe = ShootAt(*geom, origin, direction);
      if (!probe.hit) continue;
      EXPECT_TRUE(std::isfinite(probe.distance)) << kind.name;
      EXPECT_TRUE(IsFinite(probe.path.normal)) << kind.name;
      EXPECT_TRUE(std::isfinite(probe.uv.u) && std::isfinite(probe.uv.v)) << kind.name;
    }
  }
}

TEST(Torus, IsRightFromThinWiresToSpindles) {
  for (const double tube : {1e-4, 1e-2, .5, 1.0, 1.5}) {
    const auto geom = MakeGeom(TorusSpec{1, tube, {}, {0, 0, 1}});
    Random random(7);
    std::uniform_real_distribution<double> turn(0, 2 * kPi);
    for (int i = 0; i < 300; ++i) {
      // Towards a point of the ring, along which the ray must be within the tube.
      const double angle = turn(random);
      const Vector target{std::cos(angle), std::sin(angle), 0};
      const Vector direction = RandomDirection(&random);
      const Probe probe = ShootAt(*geom, target - 5 * direction, direction);
      ASSERT_TRUE(probe.hit) << tube;
      ASSERT_LT(probe.distance, 5);
      const Vector p = probe.path.point;
      const double rho = std::hypot(p.x, p.y);
      const double off = std::min(std::abs(std::hypot(rho - 1, p.z) - tube),
                                  std::abs(std::hypot(rho + 1, p.z) - tube));
      ASSERT_LT(off, 1e-13) << tube;
      ASSERT_NEAR(1, Length(probe.path.normal), 1e-12) << tube;
    }
  }
}

TEST(Quartic, FindsAllSignChangesInOrder) {
  // (x - 1)(x - 2)(x - 3)(x - 4)
  const Quartic q{{24, -50, 35, -10, 1}};
  double roots[4];
  ASSERT_EQ(4, SignChanges(q, 0, 5, roots));
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(i + 1, roots[i], 1e-13);
  ASSERT_EQ(2, SignChanges(q, 1.5, 3.5, roots));
  EXPECT_NEAR(2, roots[0], 1e-13);
  EXPECT_EQ(0, SignChanges(Quartic{{1, 0, 2, 0, 1}}, -9, 9, roots));
}

TEST(Quartic, CarriesTheSignFromPieceToPiece) {
  const Quartic line{{-1, 1, 0, 0, 0}};
  double roots[5];
  int sign = 0;
  EXPECT_EQ(0, SignChanges(line, 2, 3, &sign, roots));
  EXPECT_EQ(1, sign);
  sign = -1;
  ASSERT_EQ(1, SignChanges(line, 2, 3, &sign, roots));
  EXPECT_EQ(2, roots[0]);
  ASSERT_EQ(1, SignChanges(line, 0, 3, &(sign = 0), roots));
}

TEST(Blob, IsLeftByEveryRayThatEntersIt) {
  const auto geom = MakeGeom(BlobSpec{.3, {{1, 1, {}}, {1, 1, {.9, 0, 0}}, {1, .8, {.3, .7, .2}}}});
  Random random(5);
  std::uniform_real_distribution<double> coordinate(-.5, 1);
  int entered = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector target{coordinate(random), coordinate(random), coordinate(random)};
    const Vector direction = RandomDirection(&random);
    const Probe in = ShootAt(*geom, target - 10 * direction, direction);
    if (!in.hit || std::abs(Dot(in.path.normal, direction)) < .02) continue;
    ++entered;
    const Probe out = ShootAt(*geom, in.path.point, direction);
    ASSERT_TRUE(out.hit);
    EXPECT_FALSE(geom->Enters(out.path.ray, kEpsilon, out.distance));
  }
  EXPECT_GT(entered, 500);
}

TEST(Sphere, IsSeenWhereItIsFromAHundredMillionRadiiAway) {
  const auto geom = MakeGeom(SphereSpec{1, {}});
  int wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = -2 + 4 * (i + .5) / 1000;
    const bool hit = ShootAt(*geom, {x, 1e8, 0}, {0, -1, 0}).hit;
    wrong += hit != (std::abs(x) < 1);
  }
  EXPECT_EQ(0, wrong);
}

TEST(Heightfield, KeepsFlatCellsAtAnyNumberOfSamples) {
  const int n = 400;
  const auto geom = MakeGeom(HeightfieldSpec{
      "", n, std::make_shared<std::vector<float>>(static_cast<size_t>(n) * n, .25f)});
  const Probe probe = ShootAt(*geom, {.31, .77, 2}, {.1, -.2, -1});
  ASSERT_TRUE(probe.hit);
  EXPECT_NEAR(.25, probe.path.point.z, 1e-12);
  ExpectNear({0, 0, 1}, probe.path.normal);
}

TEST(Heightfield, HonoursTheLeastDistance) {
  const auto geom =
      MakeGeom(HeightfieldSpec{"", 4, std::make_shared<std::vector<float>>(16, .25f)});
  EXPECT_FALSE(ShootAt(*geom, {.5, .5, .35}, {0, 0, -1}, .2).hit);
  EXPECT_TRUE(ShootAt(*geom, {.5, .5, .35}, {0, 0, -1}, .05).hit);
}

TEST(Heightfield, AgreesWithItsTrianglesOneByOne) {
  const int n = 40;
  auto altitudes = std::make_shared<std::vector<float>>();
  Random random(6);
  std::uniform_real_distribution<float> relief(0, .3f);
  for (int i = 0; i < n * n; ++i) altitudes->push_back(i % 97 == 0 ? -1000 : relief(random));
  const auto field = MakeGeom(HeightfieldSpec{"", n, altitudes});
  std::vector<std::unique_ptr<const Geom>> triangles;
  const auto corner = [&](int x, int y) {
    return Vector{1e3 * x / (n - 1), 1e3 * y / (n - 1), 1e3 * (*altitudes)[y * n + x]};
  };
  const auto add = [&](const Vector& a, const Vector& b, const Vector& c) {
    if (std::min({a.z, b.z, c.z}) < -1e5) return;
    triangles.push_back(MakeGeom(TriangleSpec{{a, b, c}}));
  };
  for (int y = 0; y + 1 < n; ++y) {
    for (int x = 0; x + 1 < n; ++x) {
      add(corner(x, y), corner(x + 1, y), corner(x, y + 1));
      add(corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1));
    }
  }
  std::uniform_real_distribution<double> coordinate(-.5, 1.5);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vector origin{coordinate(random), coordinate(random), coordinate(random)};
    const Vector target{coordinate(random), coordinate(random), .2 * coordinate(random)};
    const Vector direction = Normalized(target - origin);
    double nearest = kFar;
    for (const auto& triangle : triangles) {
      double s;
      if (triangle->Intersect({1e3 * origin, direction, {}}, .01, nearest, &s)) nearest = s;
    }
    double s = 0;
    const bool hit = field->Intersect({origin, direction, {}}, kEpsilon, kFar, &s);
    ASSERT_EQ(nearest < kFar, hit) << i;
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(nearest / 1e3, s, 1e-11);
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace rayshade
