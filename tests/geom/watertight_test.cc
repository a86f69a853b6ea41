// No ray aimed at an edge or a vertex that polygons or triangles share passes between them.
#include <algorithm>
#include <cmath>
#include <random>

#include "rayshade/geom/edge_sign.h"
#include "tests/geom/probe.h"

namespace rayshade {
namespace {

using Random = std::mt19937_64;

Vector RandomPoint(Random* random, double size) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  return {coordinate(*random), coordinate(*random), coordinate(*random)};
}

// A rotation about a random axis, and a shift.
Transform RandomPose(Random* random) {
  bool degenerate;
  const Vector axis = RandomPoint(random, 1);
  const double degrees = 360 * RandomPoint(random, 1).x;
  return Compose(*Rotate(axis, degrees, &degenerate), Translate(RandomPoint(random, 10)));
}

// How many of `count` rays from around the mesh towards random points of its edges miss all faces.
int Misses(const std::vector<std::unique_ptr<const Geom>>& faces,
           const std::vector<std::pair<Vector, Vector>>& edges, Random* random, int count,
           double distance) {
  std::uniform_real_distribution<double> part(0, 1);
  int misses = 0;
  for (int i = 0; i < count; ++i) {
    const auto& [a, b] = edges[(*random)() % edges.size()];
    const double at = i % 4 == 0 ? 0 : part(*random);  // a quarter: at a vertex
    const Vector target = a + at * (b - a);
    const Vector origin = target + distance * Normalized(RandomPoint(random, 1));
    const Vector direction = Normalized(target - origin);
    bool hit = false;
    for (const auto& face : faces) {
      double s;
      hit = hit || face->Intersect({origin, direction, {}}, kEpsilon, kFar, &s);
    }
    misses += !hit;
  }
  return misses;
}

TEST(Triangle, LeavesNoGapOnTheDiagonalOfAQuad) {
  Random random(1);
  int misses = 0;
  for (int i = 0; i < 200; ++i) {
    const Transform pose = RandomPose(&random);
    Vector q[4] = {{-1, -1, 0}, {2, -1, 0}, {2, 1.5, 0}, {-1, 1, 0}};
    for (Vector& p : q) p = pose.Point(p);
    std::vector<std::unique_ptr<const Geom>> faces;
    faces.push_back(MakeGeom(TriangleSpec{{q[0], q[1], q[2]}}));
    faces.push_back(MakeGeom(TriangleSpec{{q[0], q[2], q[3]}}));
    const Vector inner = q[0] + .01 * (q[2] - q[0]), end = q[0] + .99 * (q[2] - q[0]);
    misses += Misses(faces, {{inner, end}}, &random, 50, 7);
  }
  EXPECT_EQ(0, misses);
}

TEST(Polygon, LeavesNoGapOnTheCommonEdgeOfTwoQuads) {
  Random random(2);
  int misses = 0;
  for (int i = 0; i < 200; ++i) {
    const Transform pose = RandomPose(&random);
    Vector q[6] = {{-1, -1, 0}, {.3, -1, 0}, {2, -1, 0}, {2, 1.5, 0}, {.2, 1, 0}, {-1, 1, 0}};
    for (Vector& p : q) p = pose.Point(p);
    std::vector<std::unique_ptr<const Geom>> faces;
    faces.push_back(MakeGeom(PolygonSpec{{q[0], q[1], q[4], q[5]}}));
    faces.push_back(MakeGeom(PolygonSpec{{q[1], q[2], q[3], q[4]}}));
    const Vector inner = q[1] + .01 * (q[4] - q[1]), end = q[1] + .99 * (q[4] - q[1]);
    misses += Misses(faces, {{inner, end}}, &random, 50, 7);
  }
  EXPECT_EQ(0, misses);
}

// Rays towards the edges of a closed body from outside either hit it or pass it by on the
// silhouette; from inside all must hit.
int MissesFromInside(bool polygons, double distance, double size, const Vector& shift) {
  Random random(4);
  int misses = 0;
  for (int i = 0; i < 100; ++i) {
    Transform pose = RandomPose(&random);
    if (i % 4 == 0) pose = Transform{};
    Vector corner[8];
    for (int k = 0; k < 8; ++k) {
      const Vector p{k & 1 ? 1. : -1., k & 2 ? 1.2 : -1., k & 4 ? 1. : -.7};
      corner[k] = pose.Point(size * p) + shift;
    }
    const int face[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                            {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    std::vector<std::unique_ptr<const Geom>> faces;
    std::vector<std::pair<Vector, Vector>> edges;
    for (const auto& f : face) {
      const Vector p[4] = {corner[f[0]], corner[f[1]], corner[f[2]], corner[f[3]]};
      if (polygons) {
        faces.push_back(MakeGeom(PolygonSpec{{p, p + 4}}));
      } else {
        faces.push_back(MakeGeom(TriangleSpec{{p[0], p[1], p[2]}}));
        faces.push_back(MakeGeom(TriangleSpec{{p[0], p[2], p[3]}}));
        edges.push_back({p[0], p[2]});
      }
      for (int k = 0; k < 4; ++k) edges.push_back({p[k], p[(k + 1) % 4]});
    }
    std::uniform_real_distribution<double> part(0, 1);
    for (int k = 0; k < 100; ++k) {
      const auto& [a, b] = edges[random() % edges.size()];
      const Vector target = a + (k % 4 == 0 ? 0 : part(random)) * (b - a);
      const Vector origin = pose.Point(distance * size * RandomPoint(&random, .5)) + shift;
      const Vector direction = Normalized(target - origin);
      bool hit = false;
      for (const auto& f : faces) {
        double s;
        hit = hit || f->Intersect({origin, direction, {}}, 0, kFar, &s);
      }
      misses += !hit;
    }
  }
  return misses;
}

TEST(Triangle, ClosesABodyForRaysFromInside) {
  EXPECT_EQ(0, MissesFromInside(false, 1, 1, {}));
  EXPECT_EQ(0, MissesFromInside(false, 1, 1e3, {1e5, -2e5, 3e5}));
}

TEST(Polygon, ClosesABodyForRaysFromInside) {
  EXPECT_EQ(0, MissesFromInside(true, 1, 1, {}));
  EXPECT_EQ(0, MissesFromInside(true, 1, 1e3, {1e5, -2e5, 3e5}));
}

TEST(EdgeSign, IsOppositeFromTheOtherSide) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Vector o = RandomPoint(&random, 1e3), a = RandomPoint(&random, 1),
                 b = RandomPoint(&random, 1), d = Normalized(a - o);
    EXPECT_EQ(EdgeSign(o, d, a, b), -EdgeSign(o, d, b, a));
  }
  EXPECT_EQ(0, EdgeSign({0, 0, 1}, {0, 0, -1}, {-1, 0, 0}, {3, 0, 0}));
  EXPECT_EQ(1, EdgeSign({0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 1e-300, 0}));
}

// The sign in 113 bits, whatever double would say.
int EdgeSignInFull(const Vector& o, const Vector& d, const Vector& a, const Vector& b) {
  using Real = __float128;
  Real sum = 0, size = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Real left = (Real(a[j]) - Real(o[j])) * (Real(b[k]) - Real(o[k]));
    const Real right = (Real(a[k]) - Real(o[k])) * (Real(b[j]) - Real(o[j]));
    sum += Real(d[i]) * (left - right);
    const Real left_size = left < 0 ? -left : left, right_size = right < 0 ? -right : right;
    size += Real(std::abs(d[i])) * (left_size + right_size);
  }
  const Real noise = size * Real(0x1.0p-104);
  return sum > noise ? 1 : sum < -noise ? -1 : 0;
}

TEST(EdgeSign, IsThatOfTheFullSumHoweverNearTheRayPasses) {
  Random random(6);
  size_t signs[3] = {0, 0, 0};
  for (int i = 0; i < 20000; ++i) {
    const double scale = std::pow(10.0, i % 9 - 4);
    const Vector a = RandomPoint(&random, scale), b = RandomPoint(&random, scale),
                 aside = RandomPoint(&random, scale), o = RandomPoint(&random, 10 * scale);
    const double near = i % 4 == 0 ? 0 : std::pow(2.0, -(i % 70));
    const Vector d = Normalized(a + 0.3 * (b - a) + near * aside - o);
    const int sign = EdgeSign(o, d, a, b);
    ASSERT_EQ(sign, EdgeSignInFull(o, d, a, b)) << i;
    ++signs[sign + 1];
  }
  EXPECT_GT(signs[0], 1000u);
  EXPECT_GT(signs[2], 1000u);
}

// Three edges that meet in a point of the ray: the ray beside passes them as one ray does, between
// two of the sectors or in one.
TEST(EdgeSign, BesideARayThroughAVertexIsThatOfOneRay) {
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const Vector o{std::floor(RandomPoint(&random, 9).x), 2, 5}, down{0, 0, -1}, v{o.x, 2, 0};
    const Vector around[3] = {{o.x + 3, 1, 0}, {o.x - 1, 5, 0}, {o.x - 2, -3, 0}};
    int sectors = 0;
    for (int k = 0; k < 3; ++k) {
      const Vector &a = around[k], &b = around[(k + 1) % 3];
      EXPECT_EQ(0, EdgeSign(o, down, v, a));
      EXPECT_EQ(EdgeSignBeside(o, down, v, a), -EdgeSignBeside(o, down, a, v));
      sectors += EdgeSignBeside(o, down, v, a) == -EdgeSignBeside(o, down, v, b) &&
                 EdgeSignBeside(o, down, v, a) == EdgeSignBeside(o, down, a, b);
    }
    EXPECT_EQ(1, sectors);
  }
}

}  // namespace
}  // namespace rayshade
