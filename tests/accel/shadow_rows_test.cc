// Rows of shadow rays against every object in turn, each asked alone: what the kernels decide in
// single precision (certain hits, parts of polygons, boxes of other objects, packets) must be what
// the objects' own tests say, on all kernels, also where rays graze planes, pass through edges and
// corners, and where points are off their plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <variant>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "tests/support/kernels.h"
#include "tests/support/random.h"

namespace rayshade {
namespace {

using test::kAllKernels;
using test::Random;
using test::RandomPoint;
using test::Uniform;

struct Room {
  std::vector<GeomSpec> specs;
  std::vector<Vector> marks;  // corners, points of edges, middles: to aim at and to start from
  Vector center;
};

// A star with points off its plane by up to `off`: concave, with 2 * tips points.
void AddStar(Random* random, int tips, double off, Room* room) {
  const Vector at = room->center + RandomPoint(random, 4), a = RandomPoint(random, 1);
  const Vector x = Normalized(a), y = Normalized(Cross(x, RandomPoint(random, 1)));
  const Vector n = Cross(x, y);
  PolygonSpec star;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = 3.141592653589793 * i / tips, radius = i % 2 == 0 ? 1.5 : 0.4;
    star.points.push_back(at + radius * std::cos(angle) * x + radius * std::sin(angle) * y +
                          Uniform(random, -off, off) * n);
  }
  for (size_t i = 0; i < star.points.size(); ++i) {
    room->marks.push_back(star.points[i]);
    room->marks.push_back(0.5 * (star.points[i] + star.points[(i + 1) % star.points.size()]));
  }
  room->marks.push_back(at);
  room->specs.push_back(star);
}

void AddFlat(Random* random, double off, Room* room) {
  const Vector a = room->center + RandomPoint(random, 4), b = RandomPoint(random, 1.5),
               c = RandomPoint(random, 1.5);
  const Vector n = Normalized(Cross(b, c));
  if ((*random)() % 2 == 0) {
    room->specs.push_back(TriangleSpec{{a, a + b, a + c}});
  } else {
    room->specs.push_back(
        PolygonSpec{{a, a + b, a + b + c + Uniform(random, -off, off) * n, a + c}});
  }
  for (const Vector& p : {a, a + b, a + c, a + 0.5 * b, a + 0.5 * c, a + 0.3 * b + 0.3 * c}) {
    room->marks.push_back(p);
  }
}

Room MakeRoom(Random* random, const Vector& center, double off) {
  Room room;
  room.center = center;
  for (int i = 0; i < 60; ++i) AddFlat(random, off, &room);
  for (int tips : {2, 3, 5, 12, 19, 25, 40}) AddStar(random, tips, off, &room);
  for (int i = 0; i < 12; ++i) {
    const Vector base = center + RandomPoint(random, 4);
    room.specs.push_back(ConeSpec{0.5, base, 0.2, base + RandomPoint(random, 1)});
    room.specs.push_back(
        CylinderSpec{0.2, base + RandomPoint(random, 1), base + RandomPoint(random, 2)});
    room.specs.push_back(SphereSpec{Uniform(random, 0.05, 0.4), center + RandomPoint(random, 4)});
  }
  return room;
}

// Spheres alone, so that nothing but spheres decides how wide pyramids may be.
Room MakeBalls(Random* random, const Vector& center) {
  Room room;
  room.center = center;
  for (int i = 0; i < 120; ++i) {
    const SphereSpec ball{Uniform(random, 0.05, i % 10 == 0 ? 2 : 0.6),
                          center + RandomPoint(random, 4)};
    room.specs.push_back(ball);
    room.marks.push_back(ball.center + ball.radius * Normalized(RandomPoint(random, 1)));
  }
  return room;
}

// Points near the rims of balls as seen from the light: just within, just outside, and the rims.
void MarkRims(Random* random, const Vector& light, Room* room) {
  for (size_t i = 0; i < room->specs.size(); ++i) {
    const auto& ball = std::get<SphereSpec>(room->specs[i]);
    const Vector to = ball.center - light;
    const double size = ball.radius / Length(to);
    if (size > 0.9) continue;
    const Vector aside = Normalized(Cross(to, RandomPoint(random, 1)));
    const double off = std::pow(10, -Uniform(random, 1, 12)) * (static_cast<double>(i % 3) - 1);
    room->marks[i] = ball.center + ball.radius / std::sqrt(1 - size * size) * (1 + off) * aside;
  }
}

// Where the shadow rays start: around one place, on a plane that the light grazes, behind marks as
// seen from the light, or anywhere.
std::vector<Vector> Starts(Random* random, const Room& room, const Vector& light, int how) {
  std::vector<Vector> starts;
  const Vector place = room.center + RandomPoint(random, 5);
  for (int i = 0; i < 192; ++i) {
    const Vector& mark = room.marks[(*random)() % (room.marks.size())];
    const double x = 0.02 * (i % 16), y = 0.02 * (i / 16);
    switch (how) {
      case 0:
        starts.push_back(place + Vector{x, y, 0.01 * x});
        break;
      case 1:
        starts.push_back({room.center.x - 4 + 20 * x, room.center.y + 20 * y, light.z - 1e-3});
        break;
      case 2:
        starts.push_back(light + Uniform(random, 1, 2) * (mark - light));
        break;
      default:
        starts.push_back(i % 3 == 0 ? mark : room.center + RandomPoint(random, 6));
    }
  }
  return starts;
}

struct Rows {
  explicit Rows(const std::vector<Vector>& starts) : count(starts.size()) {
    for (size_t i = 0; i < count; ++i) {
      for (int k = 0; k < 3; ++k) point[k][i] = starts[i][k];
    }
  }
  OpCounts Trace(const ObjectSet& set, const Vector& light, double reach) {
    set.Aim({{point[0], point[1], point[2]},
             {normal[0], normal[1], normal[2]},
             static_cast<uint32_t>(count),
             {light.x, light.y, light.z},
             {toward[0], toward[1], toward[2]},
             distance,
             cosine});
    OpCounts counts;
    set.Block({{point[0], point[1], point[2]},
               {toward[0], toward[1], toward[2]},
               distance,
               time,
               {light.x, light.y, light.z},
               reach,
               blocked,
               crossed,
               static_cast<uint32_t>(count)},
              &counts);
    return counts;
  }
  size_t count;
  double point[3][192] = {}, normal[3][192] = {}, toward[3][192], distance[192], cosine[192];
  double time[192] = {};
  uint8_t blocked[192] = {}, crossed[192] = {};
};

// Every third object is transparent.
std::unique_ptr<Scene> MakeScene() {
  SceneSpec spec;
  spec.surfaces.resize(2);
  spec.surfaces[1].transp = 0.5;
  for (SurfaceId surface : {SurfaceId{0}, SurfaceId{1}}) {
    Placement placement;
    placement.levels.resize(1);
    placement.levels[0].attributes.surface = surface;
    placement.Finish();
    spec.placements.push_back(placement);
  }
  return std::make_unique<Scene>(std::move(spec), 0);
}

// Bit 1: something opaque is in the way; bit 2: something transparent.
int InTheWay(const ObjectSet& set, const Rows& rows, size_t i) {
  Ray ray;
  ray.origin = {rows.point[0][i], rows.point[1][i], rows.point[2][i]};
  ray.direction = {rows.toward[0][i], rows.toward[1][i], rows.toward[2][i]};
  ray.min_distance = kShadowEpsilon;
  int found = 0;
  for (uint32_t object = 0; object < set.size(); ++object) {
    Hit hit;
    hit.distance = rows.distance[i];
    set.NearestOf(ray, object, &hit);
    if (hit.found()) found |= set.placement_of(object) == 0 ? 1 : 2;
  }
  return found;
}

enum class Objects { kAllKinds, kBalls };

void Compare(uint64_t seed, const Vector& center, double off,
             Objects objects = Objects::kAllKinds) {
  Random random(seed);
  const bool balls = objects == Objects::kBalls;
  Room room = balls ? MakeBalls(&random, center) : MakeRoom(&random, center, off);
  const std::unique_ptr<Scene> scene = MakeScene();
  const double reach = 20 + SumOfSizes(center);
  for (int how = 0; how < 8; ++how) {
    const Vector light =
        how < 4 ? center + RandomPoint(&random, 5) : room.marks[how * 7] + Vector{0, 0, off};
    if (balls) MarkRims(&random, light, &room);
    Rows rows(Starts(&random, room, light, how % 4));
    std::vector<int> expected;
    for (const char* simd : kAllKernels) {
      setenv("RAYSHADE_SIMD", simd, 1);
      ObjectSet set(scene.get());
      for (size_t i = 0; i < room.specs.size(); ++i) {
        set.Add(room.specs[i], i % 3 == 2, static_cast<Rank>(i));
      }
      set.Build();
      unsetenv("RAYSHADE_SIMD");
      std::fill_n(rows.blocked, rows.count, uint8_t{0});
      std::fill_n(rows.crossed, rows.count, uint8_t{0});
      rows.Trace(set, light, reach);
      size_t blocked = 0;
      for (size_t i = 0; i < rows.count; ++i) {
        if (expected.size() <= i) expected.push_back(InTheWay(set, rows, i));
        ASSERT_EQ(rows.blocked[i], expected[i] & 1)
            << simd << " " << seed << " " << how << " " << i;
        // Crossed rays are asked about again, so that too many do no harm; one too few would.
        if (expected[i] == 2) {
          ASSERT_EQ(rows.crossed[i], 1) << simd << " " << seed << " " << i;
        }
        blocked += rows.blocked[i];
      }
      if (how == 2) {
        EXPECT_GT(blocked, 10u) << seed;
      }
    }
  }
}

TEST(ShadowRows, AnswerAsTheObjectsOneByOne) {
  for (uint64_t seed = 1; seed <= 12; ++seed) Compare(seed, {0, 0, 0}, 0);
}

TEST(ShadowRows, AnswerAsTheObjectsWherePointsAreOffTheirPlane) {
  for (uint64_t seed = 21; seed <= 26; ++seed) Compare(seed, {1, 2, 3}, 4e-6);
  for (uint64_t seed = 31; seed <= 36; ++seed) Compare(seed, {1, 2, 3}, 3e-5);
  for (uint64_t seed = 41; seed <= 44; ++seed) Compare(seed, {1, 2, 3}, 1e-2);
}

TEST(ShadowRows, AnswerAsTheObjectsFarFromTheOrigin) {
  for (uint64_t seed = 51; seed <= 54; ++seed) Compare(seed, {1e3, -2e3, 3e3}, 1e-6);
  for (uint64_t seed = 61; seed <= 64; ++seed) Compare(seed, {2e5, -1e5, 3e5}, 1e-6);
  for (uint64_t seed = 71; seed <= 72; ++seed) Compare(seed, {2e6, -1e6, 3e6}, 1e-6);
}

TEST(ShadowRows, AnswerAsBallsOneByOneAlsoAtTheirRims) {
  for (uint64_t seed = 81; seed <= 92; ++seed) Compare(seed, {0, 0, 0}, 0, Objects::kBalls);
  for (uint64_t seed = 93; seed <= 96; ++seed) Compare(seed, {1e3, -2e3, 3e3}, 0, Objects::kBalls);
  for (uint64_t seed = 97; seed <= 99; ++seed) Compare(seed, {2e5, -1e5, 3e5}, 0, Objects::kBalls);
}

// Bundles ask what blocked the one before them before they enter the hierarchy.
TEST(ShadowRows, OfManyBundlesBehindAWallTheFirstAloneVisitsNodes) {
  const std::unique_ptr<Scene> scene = MakeScene();
  for (const char* simd : kAllKernels) {
    setenv("RAYSHADE_SIMD", simd, 1);
    ObjectSet set(scene.get());
    set.Add(PolygonSpec{{{-5, -5, 1}, {5, -5, 1}, {5, 5, 1}, {-5, 5, 1}}}, 0, 0);
    Random random(7);
    for (Rank rank = 1; rank < 300; ++rank) {
      set.Add(SphereSpec{0.05, Vector{0, 0, 3} + RandomPoint(&random, 1)}, 0, rank);
    }
    set.Build();
    unsetenv("RAYSHADE_SIMD");
    std::vector<Vector> starts;
    for (int i = 0; i < 192; ++i) starts.push_back({0.001 * (i % 16), 0.001 * (i / 16), 0});
    Rows all(starts);
    const OpCounts of_all = all.Trace(set, {0, 0, 10}, 20);
    starts.resize(64);
    const OpCounts of_first = Rows(starts).Trace(set, {0, 0, 10}, 20);
    EXPECT_EQ(std::count(all.blocked, all.blocked + 192, 1), 192);
    EXPECT_GT(of_first.node_visits, 0u) << simd;
    EXPECT_EQ(of_all.node_visits, of_first.node_visits) << simd;
  }
}

TEST(LightRows, DoWhatTheyDoForOneHitAtATime) {
  Random random(5);
  constexpr uint32_t kCount = 45, kRoom = 48;
  double toward[3][kRoom], face[3][kRoom], cosine[kRoom], slack[kRoom], diffuse[3][kRoom];
  double before[3][kRoom];
  for (uint32_t i = 0; i < kRoom; ++i) {
    const Vector t = Normalized(RandomPoint(&random, 1)), f = Normalized(RandomPoint(&random, 1));
    cosine[i] = i % 7 == 0 ? 0 : Uniform(&random, -1, 1);
    slack[i] = i % 5 == 0   ? std::numeric_limits<double>::infinity()
               : i % 5 == 1 ? kShadowEpsilon * std::abs(Dot(t, f))
                            : Uniform(&random, 0, 2 * kShadowEpsilon);
    for (int k = 0; k < 3; ++k) {
      toward[k][i] = t[k];
      face[k][i] = f[k];
      diffuse[k][i] = Uniform(&random, 0, 1);
      before[k][i] = Uniform(&random, 0, 1);
    }
  }
  const Color arrived{0.9, 0.7, 1.0 / 3};
  const std::unique_ptr<Scene> scene = MakeScene();
  for (const char* simd : kAllKernels) {
    setenv("RAYSHADE_SIMD", simd, 1);
    ObjectSet set(scene.get());
    set.Build();
    unsetenv("RAYSHADE_SIMD");
    uint8_t by_row[kRoom], dark[kRoom];
    set.Sort({{toward[0], toward[1], toward[2]},
              cosine,
              {face[0], face[1], face[2]},
              slack,
              kCount,
              by_row,
              dark});
    double sum[3][kRoom];
    std::copy(&before[0][0], &before[0][0] + 3 * kRoom, &sum[0][0]);
    set.AddDiffuse({dark,
                    cosine,
                    {diffuse[0], diffuse[1], diffuse[2]},
                    {arrived.r, arrived.g, arrived.b},
                    {sum[0], sum[1], sum[2]},
                    kCount});
    for (uint32_t i = 0; i < kCount; ++i) {
      const Vector t{toward[0][i], toward[1][i], toward[2][i]};
      const Vector f{face[0][i], face[1][i], face[2][i]};
      EXPECT_EQ(by_row[i], slack[i] <= kShadowEpsilon * std::abs(Dot(t, f))) << simd << " " << i;
      EXPECT_EQ(dark[i], !(by_row[i] && cosine[i] > 0)) << simd << " " << i;
      for (int k = 0; k < 3; ++k) {
        const double more = before[k][i] + cosine[i] * diffuse[k][i] * arrived[k];
        EXPECT_EQ(sum[k][i], dark[i] ? before[k][i] : more) << simd << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace rayshade
