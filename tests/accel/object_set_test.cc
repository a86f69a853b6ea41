// The hierarchy against a list of all objects, each asked through its Geom: same hits to the bit,
// on ordinary and on unkind scenes, with every kernel that this machine can run, in bundles of any
// size.
#include "rayshade/accel/object_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "rayshade/geom/make_geom.h"

namespace rayshade {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Objects in a set and in a list.
class World {
 public:
  World() {
    SceneSpec spec;
    spec.surfaces.resize(2);
    spec.surfaces[1].transp = 0.5;
    const auto place = [&](SurfaceId surface, std::optional<Transform> transform) {
      Placement placement;
      placement.levels.resize(1);
      placement.levels[0].attributes.surface = surface;
      if (transform) placement.levels[0].attributes.transforms.Append(*transform);
      placement.Finish();
      spec.placements.push_back(placement);
    };
    place(0, std::nullopt);
    place(1, std::nullopt);
    place(0, Compose(*Scale({2, 0.5, 1}), Translate({0.25, 0, 0})));
    scene_ = std::make_unique<Scene>(std::move(spec), 0);
  }

  void Add(const GeomSpec& spec, PlacementId placement = 0) {
    if (CheckGeom(spec) && CheckGeom(spec)->dropped) return;
    list_.push_back({spec, MakeGeom(spec), placement});
  }

  // Adds them to the set in another order.
  void Build(const char* simd) {
    setenv("RAYSHADE_SIMD", simd, 1);
    set_ = std::make_unique<ObjectSet>(scene_.get());
    for (size_t i = list_.size(); i-- > 0;) {
      set_->Add(list_[i].spec, list_[i].placement, static_cast<Rank>(i));
    }
    set_->Build();
    unsetenv("RAYSHADE_SIMD");
  }

  Hit NearestInList(const Ray& ray, Hit best) const {
    for (size_t i = 0; i < list_.size(); ++i) {
      double distance;
      if (!Meet(i, ray, kFar, &distance)) continue;
      const Hit hit{distance, static_cast<Rank>(i), 0, nullptr};
      if (hit.nearer_than(best)) best = hit;
    }
    return best;
  }

  bool BlockedInList(const Ray& ray, double limit) const {
    for (size_t i = 0; i < list_.size(); ++i) {
      double distance;
      if (list_[i].placement != 1 && Meet(i, ray, limit, &distance)) return true;
    }
    return false;
  }

  const ObjectSet& set() const { return *set_; }
  const Scene& scene() const { return *scene_; }
  size_t size() const { return list_.size(); }
  Bounds BoxOf(size_t i) const {
    return WorldBounds(scene_->placement(list_[i].placement), list_[i].geom->bounds(), {});
  }
  bool bounded(size_t i) const { return list_[i].geom->bounded(); }

 private:
  struct Listed {
    GeomSpec spec;
    std::unique_ptr<const Geom> geom;
    PlacementId placement;
  };

  bool Meet(size_t i, const Ray& ray, double limit, double* distance) const {
    ObjectRay local{ray.origin, ray.direction, {}};
    double scale = 1;
    const Placement& placement = scene_->placement(list_[i].placement);
    if (!ToObject(placement, {ray.origin, ray.direction, {}}, ray.min_distance, kFar, &local,
                  &scale)) {
      return false;
    }
    if (!list_[i].geom->Intersect(local, ray.min_distance * scale, limit * scale, distance)) {
      return false;
    }
    *distance /= scale;
    // The rule about the object's box (trace_view.h), for all that is not sure to lie in it.
    const GeomSpec& spec = list_[i].spec;
    const bool flat = placement.in_place && (std::holds_alternative<SphereSpec>(spec) ||
                                             std::holds_alternative<TriangleSpec>(spec));
    const bool unit = std::abs(Dot(ray.direction, ray.direction) - 1) < 1e-9;
    if (!list_[i].geom->bounded() || (flat && unit && *distance <= 1e6)) return true;
    return MeetsBox(BoxOf(i), ray, *distance);
  }

  static bool MeetsBox(const Bounds& box, const Ray& ray, double distance) {
    double near = ray.min_distance, far = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
      const double o = ray.origin[axis], d = ray.direction[axis];
      if (d == 0) {
        if (o < box.low[axis] || o > box.high[axis]) return false;
        continue;
      }
      const double a = (box.low[axis] - o) / d, b = (box.high[axis] - o) / d;
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    return near <= far && distance >= near * (1 - 1e-7);
  }

  std::unique_ptr<Scene> scene_;
  std::vector<Listed> list_;
  std::unique_ptr<ObjectSet> set_;
};

const char* const kAllKernels[] = {"plain", "avx2", "avx512"};

class Random {
 public:
  double Between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1.0p-53);
  }
  Vector Point(double size) {
    const double x = Between(-size, size), y = Between(-size, size);
    return {x, y, Between(-size, size)};
  }
  Vector Direction() {
    Vector v = Point(1);
    while (Dot(v, v) > 1 || Dot(v, v) < 1e-3) v = Point(1);
    return Normalized(v);
  }
  size_t Below(size_t end) { return bits_() % end; }

 private:
  std::mt19937_64 bits_{7};
};

Ray MakeRay(const Vector& origin, const Vector& direction) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  return ray;
}

// Everything that a set answers about these rays, on all kernels, against the list.
void Compare(World* world, const std::vector<Ray>& rays, size_t* found = nullptr) {
  std::vector<Hit> expected(rays.size());
  std::vector<double> limits(rays.size());
  std::vector<uint8_t> blocked(rays.size());
  size_t hits = 0;
  for (size_t i = 0; i < rays.size(); ++i) {
    expected[i] = world->NearestInList(rays[i], Hit{});
    hits += expected[i].found();
    limits[i] = i % 3 == 0 ? kFar : expected[i].distance * (i % 3 == 1 ? 1 : 1.25);
    blocked[i] = world->BlockedInList(rays[i], limits[i]);
  }
  if (found) *found = hits;
  for (const char* simd : kAllKernels) {
    world->Build(simd);
    for (const size_t bundle :
         {size_t{1}, size_t{3}, size_t{16}, size_t{64}, size_t{100}, size_t{1024}}) {
      std::vector<Hit> got(rays.size());
      std::vector<uint8_t> shadow(rays.size());
      OpCounts counts;
      for (size_t i = 0; i < rays.size(); i += bundle) {
        const size_t n = std::min(bundle, rays.size() - i);
        world->set().Nearest({rays.data() + i, n}, {got.data() + i, n}, &counts);
        world->set().Block({rays.data() + i, n}, {limits.data() + i, n}, {shadow.data() + i, n},
                           &counts);
      }
      for (size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(got[i].distance, expected[i].distance)
            << simd << " ray " << i << " of " << bundle;
        ASSERT_EQ(got[i].rank, expected[i].rank) << simd << " ray " << i << " of " << bundle;
        ASSERT_EQ(shadow[i], blocked[i]) << simd << " shadow ray " << i << " of " << bundle;
        if (got[i].found()) {
          ASSERT_EQ(got[i].set, &world->set());
          ASSERT_EQ(world->set().entry(got[i].object).rank, got[i].rank);
        }
      }
    }
  }
}

void AddSpheres(World* world, Random* random, int count, double size, const Vector& at = {}) {
  for (int i = 0; i < count; ++i) {
    world->Add(SphereSpec{random->Between(0.001, 0.1) * size, at + random->Point(size)},
               static_cast<PlacementId>(random->Below(2)));
  }
}

void AddFlat(World* world, Random* random, int count, double size, const Vector& at = {}) {
  for (int i = 0; i < count; ++i) {
    const Vector a = at + random->Point(size);
    const Vector b = a + random->Point(size / 4), c = a + random->Point(size / 4);
    const PlacementId placement = static_cast<PlacementId>(random->Below(3));
    if (i % 2 == 0) {
      world->Add(TriangleSpec{{a, b, c}}, placement);
    } else {
      world->Add(PolygonSpec{{a, b, b + 0.5 * (c - a), c}}, placement);
    }
  }
}

std::vector<Ray> RandomRays(Random* random, int count, double size, const Vector& at = {}) {
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    rays.push_back(MakeRay(at + random->Point(size * 1.5), random->Direction()));
  }
  return rays;
}

// A camera's rays, in square blocks.
std::vector<Ray> CameraRays(const Vector& eye, const Vector& at, int side) {
  std::vector<Ray> rays;
  const Vector forward = Normalized(at - eye), right = Normalized(Cross(forward, {0, 0, 1}));
  const Vector up = Cross(right, forward);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double u = (x + 0.5) / side - 0.5, v = 0.5 - (y + 0.5) / side;
      rays.push_back(MakeRay(eye, Normalized(forward + u * right + v * up)));
    }
  }
  return rays;
}

TEST(ObjectSet, FindsWhatAListOfAllSpheresFinds) {
  Random random;
  World world;
  AddSpheres(&world, &random, 700, 10);
  size_t found = 0;
  Compare(&world, RandomRays(&random, 1500, 10), &found);
  EXPECT_GT(found, 300u);
}

TEST(ObjectSet, FindsWhatAListOfAllKindsFinds) {
  Random random;
  World world;
  AddSpheres(&world, &random, 100, 10);
  AddFlat(&world, &random, 300, 10);
  for (int i = 0; i < 50; ++i) {
    const Vector p = random.Point(10);
    const PlacementId placement = static_cast<PlacementId>(random.Below(3));
    world.Add(BoxSpec{p, p + random.Point(1)}, placement);
    world.Add(DiscSpec{0.5, p, random.Direction()}, placement);
    world.Add(CylinderSpec{0.25, p, p + random.Point(2)}, placement);
    world.Add(SphereSpec{0.5, p + random.Point(1)}, 2);
  }
  world.Add(PlaneSpec{{0, 0, -9}, {0.1, 0, 1}}, 0);
  size_t found = 0;
  Compare(&world, RandomRays(&random, 1200, 10), &found);
  EXPECT_GT(found, 600u);
}

TEST(ObjectSet, CameraRaysInBundlesFindWhatSingleRaysFind) {
  Random random;
  World world;
  AddSpheres(&world, &random, 500, 10);
  AddFlat(&world, &random, 100, 10);
  Compare(&world, CameraRays({22, 13, 17}, {0, 0, 0}, 40));
  Compare(&world, CameraRays({0.5, 0.25, 0.125}, {1, 1, 0}, 40));  // from within
}

TEST(ObjectSet, RaysTowardsALightInBundles) {
  Random random;
  World world;
  AddSpheres(&world, &random, 400, 10);
  AddFlat(&world, &random, 100, 10);
  world.Build("plain");
  std::vector<Ray> primary = CameraRays({22, 13, 17}, {0, 0, 0}, 40), shadow;
  std::vector<Hit> hits(primary.size());
  OpCounts counts;
  world.set().Nearest(primary, hits, &counts);
  const Vector light{9, -30, 14};
  for (size_t i = 0; i < primary.size(); ++i) {
    if (!hits[i].found()) continue;
    const Vector p = primary[i].origin + hits[i].distance * primary[i].direction;
    shadow.push_back(MakeRay(p, Normalized(light - p)));
    shadow.back().min_distance = kShadowEpsilon;
  }
  ASSERT_GT(shadow.size(), 200u);
  Compare(&world, shadow);
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
  Random random;
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
      Vector p = coherent ? Vector{-9 + x, 5 + y, -8} : random.Point(12);
      if (i % 100 == 99) p = light + 1e-6 * random.Direction();
      const Vector n = random.Direction();
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
  Random random;
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
    Random random;
    World world;
    const Vector at{offset, -offset, offset};
    AddSpheres(&world, &random, 200, offset * 1e-5, at);
    AddFlat(&world, &random, 60, offset * 1e-5, at);
    Compare(&world, RandomRays(&random, 400, offset * 1e-5, at));
    Compare(&world, CameraRays(at + Vector{offset * 3e-5, offset * 1e-5, 0}, at, 20));
  }
}

TEST(ObjectSet, FarOriginsAndHugeObjects) {
  Random random;
  World world;
  AddSpheres(&world, &random, 300, 10);
  AddFlat(&world, &random, 60, 10);
  world.Add(SphereSpec{1e12, {0, 0, -1e12}});
  std::vector<Ray> rays;
  for (const double far : {1e3, 1e5, 1e7, 1e9, 1e11}) {
    for (int i = 0; i < 150; ++i) {
      const Vector origin = far * random.Direction();
      rays.push_back(MakeRay(origin, Normalized(random.Point(10) - origin)));
    }
  }
  const std::vector<Ray> near = RandomRays(&random, 300, 10);
  rays.insert(rays.end(), near.begin(), near.end());
  size_t found = 0;
  Compare(&world, rays, &found);
  EXPECT_GT(found, 300u);
}

TEST(ObjectSet, RaysOfAnyLengthAndMinimum) {
  Random random;
  World world;
  AddSpheres(&world, &random, 300, 10);
  AddFlat(&world, &random, 60, 10);
  std::vector<Ray> rays = RandomRays(&random, 600, 10);
  for (size_t i = 0; i < rays.size(); ++i) {
    rays[i].min_distance = std::abs(random.Between(-5, 5));
    if (i % 4 == 0) rays[i].direction = random.Between(0.3, 3) * rays[i].direction;
  }
  Compare(&world, rays);
}

TEST(ObjectSet, EarlierHitsAndLimitsArePutToTheTest) {
  Random random;
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

TEST(ObjectSet, ForEachInVisitsWhatOverlapsABox) {
  Random random;
  World world;
  AddSpheres(&world, &random, 500, 10);
  AddFlat(&world, &random, 200, 10);
  world.Add(PlaneSpec{{0, 0, 0}, {0, 0, 1}});
  world.Build("plain");
  for (int i = 0; i < 200; ++i) {
    const Vector p = random.Point(10);
    Bounds box{p, p};
    box.Include(p + random.Point(i % 4 == 0 ? 0 : 2));
    if (i % 5 == 0) box.Include(world.BoxOf(random.Below(500)).high);
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
  Random random;
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
  Random random;
  world.Build("plain");
  ObjectSet set(&world.scene());
  constexpr int kSpheres = 50000;
  for (int i = 0; i < kSpheres; ++i) {
    set.Add(SphereSpec{random.Between(0.001, 0.01), random.Point(1)}, 0, static_cast<Rank>(i));
  }
  set.Build();
  EXPECT_LE(set.bytes(), kSpheres * size_t{64});
  EXPECT_GE(set.bytes(), kSpheres * size_t{40});
}

}  // namespace
}  // namespace rayshade
