// No ray aimed at an edge or a vertex passes through a closed mesh or a height field: with every
// kernel that this machine can run, ray by ray, in bundles, as shadow rays and in rows of them,
// from near and from far away.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "tests/support/kernels.h"
#include "tests/support/random.h"

namespace rayshade {
namespace {

constexpr double kFarthest = 1e8;  // of the origins, in sizes of the mesh
constexpr int kRaysPerDistance = 200;

using test::kAllKernels;
using test::Random;
using test::RandomDirection;
using test::Uniform;

// A surface of flat faces, and where they meet.
struct Mesh {
  std::vector<GeomSpec> faces;  // what is put into the set: a face each, or one height field
  std::vector<Vector> points;
  std::vector<std::vector<int>> corners;  // of each face

  Vector NormalOf(int face) const {
    const std::vector<int>& c = corners[face];
    return Normalized(Cross(points[c[1]] - points[c[0]], points[c[2]] - points[c[1]]));
  }
  void Close() {
    for (const std::vector<int>& c : corners) {
      std::vector<Vector> p;
      for (const int i : c) p.push_back(points[i]);
      if (p.size() == 3) {
        faces.push_back(TriangleSpec{{p[0], p[1], p[2]}});
      } else {
        faces.push_back(PolygonSpec{p});
      }
    }
  }
};

// Eight triangles, each cut into four `depth` times, around the origin; their corners at random
// distances from it.
Mesh Rock(int depth, double roughness, Random* random) {
  Mesh mesh;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.corners = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < depth; ++i) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [at, isNew] = middles.try_emplace(std::minmax(a, b), int(mesh.points.size()));
      if (isNew) mesh.points.push_back(Normalized(mesh.points[a] + mesh.points[b]));
      return at->second;
    };
    std::vector<std::vector<int>> finer;
    for (const std::vector<int>& c : mesh.corners) {
      const int a = middle(c[0], c[1]), b = middle(c[1], c[2]), d = middle(c[2], c[0]);
      finer.insert(finer.end(), {{c[0], a, d}, {a, c[1], b}, {d, b, c[2]}, {a, b, d}});
    }
    mesh.corners = finer;
  }
  for (Vector& p : mesh.points) p = Uniform(random, 1 - roughness, 1) * p;
  mesh.Close();
  return mesh;
}

// A drum of quadrilaterals with polygons at its ends, askew.
Mesh Drum(int sides, Random* random) {
  Mesh mesh;
  const Vector axis = RandomDirection(random);
  const Vector u = Normalized(Cross(axis, RandomDirection(random))), v = Cross(axis, u);
  std::vector<int> top, bottom;
  for (int i = 0; i < sides; ++i) {
    const double turn = 2 * kPi * i / sides;
    const Vector rim = std::cos(turn) * u + std::sin(turn) * v;
    mesh.points.push_back(rim - .7 * axis);
    mesh.points.push_back(.8 * rim + .6 * axis);
    const int next = (i + 1) % sides;
    mesh.corners.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    top.push_back(2 * i + 1);
    bottom.insert(bottom.begin(), 2 * i);
  }
  mesh.corners.push_back(top);
  mesh.corners.push_back(bottom);
  mesh.Close();
  return mesh;
}

// The triangles of a height field with cliffs.
Mesh Relief(int size, double height, Random* random) {
  Mesh mesh;
  auto altitudes = std::make_shared<std::vector<float>>();
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      altitudes->push_back(static_cast<float>(Uniform(random, 0, height)));
      mesh.points.push_back({x / (size - 1.0), y / (size - 1.0), altitudes->back()});
    }
  }
  for (int y = 0; y + 1 < size; ++y) {
    for (int x = 0; x + 1 < size; ++x) {
      const int i = y * size + x;
      mesh.corners.push_back({i, i + 1, i + size});
      mesh.corners.push_back({i + 1, i + size + 1, i + size});
    }
  }
  mesh.faces.push_back(HeightfieldSpec{"relief", size, std::move(altitudes)});
  return mesh;
}

// The mesh in place, or placed by transformations.
class Placed {
 public:
  Placed(const Mesh& mesh, std::optional<Transform> transform) : mesh_(mesh) {
    SceneSpec spec;
    spec.surfaces.resize(1);
    Placement placement;
    placement.levels.resize(1);
    placement.levels[0].attributes.surface = 0;
    if (transform) {
      placement.levels[0].attributes.transforms.Append(*transform);
      transform_ = *transform;
    }
    placement.Finish();
    spec.placements.push_back(placement);
    scene_ = std::make_unique<Scene>(std::move(spec), 0);
    FindNeighbours();
  }

  void Build(const char* simd) {
    setenv("RAYSHADE_SIMD", simd, 1);
    set_ = std::make_unique<ObjectSet>(scene_.get());
    for (size_t i = 0; i < mesh_.faces.size(); ++i) {
      set_->Add(mesh_.faces[i], 0, static_cast<Rank>(i));
    }
    set_->Build();
    unsetenv("RAYSHADE_SIMD");
  }
  const ObjectSet& set() const { return *set_; }

  // A point of an edge or a vertex, in the world, and the direction of a ray that goes through the
  // surface there: all faces around turn the same side to it, none at a grazing angle.
  std::pair<Vector, Vector> Target(Random* random) const {
    for (;;) {
      const auto& [edge, sides] = edges_[(*random)() % edges_.size()];
      const bool vertex = (*random)() % 3 == 0;
      const Vector &a = mesh_.points[edge.first], &b = mesh_.points[edge.second];
      const Vector target = vertex ? a : a + Uniform(random, 0, 1) * (b - a);
      const Vector direction = RandomDirection(random);
      const std::vector<int>& faces = vertex ? around_[edge.first] : sides;
      int toward = 0, away = 0;
      for (const int face : faces) {
        const double cosine = Dot(mesh_.NormalOf(face), direction);
        toward += cosine < -1e-3;
        away += cosine > 1e-3;
      }
      const int all = static_cast<int>(faces.size());
      if (toward != all && away != all) continue;
      return {transform_.Point(target), Normalized(transform_.Direction(direction))};
    }
  }

 private:
  // Edges with faces on both sides, and all faces around each of their ends.
  void FindNeighbours() {
    std::map<std::pair<int, int>, std::vector<int>> sides;
    around_.resize(mesh_.points.size());
    for (size_t face = 0; face < mesh_.corners.size(); ++face) {
      const std::vector<int>& c = mesh_.corners[face];
      for (size_t i = 0; i < c.size(); ++i) {
        sides[std::minmax(c[i], c[(i + 1) % c.size()])].push_back(static_cast<int>(face));
        around_[c[i]].push_back(static_cast<int>(face));
      }
    }
    std::vector<bool> rim(mesh_.points.size());
    for (const auto& [edge, faces] : sides) {
      if (faces.size() < 2) rim[edge.first] = rim[edge.second] = true;
    }
    for (const auto& [edge, faces] : sides) {
      if (faces.size() == 2 && !rim[edge.first]) edges_.push_back({edge, faces});
    }
  }

  const Mesh& mesh_;
  Transform transform_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<ObjectSet> set_;
  std::vector<std::pair<std::pair<int, int>, std::vector<int>>> edges_;
  std::vector<std::vector<int>> around_;
};

// Rays, and the distance by which each must have met the surface.
struct Aimed {
  std::vector<Ray> rays;
  std::vector<double> limits;
};

Aimed AimAtEdges(const Placed& placed, double away, double size, Random* random) {
  Aimed aimed;
  for (int i = 0; i < kRaysPerDistance; ++i) {
    const auto [target, direction] = placed.Target(random);
    Ray ray;
    ray.origin = target - away * size * direction;
    ray.direction = target - ray.origin;
    const double distance = Normalize(&ray.direction);
    aimed.rays.push_back(ray);
    // Rounding and, where the ray grazes, what it makes of it: nothing lies behind so near.
    aimed.limits.push_back(distance + 1e-6 * size + 1e-10 * distance);
  }
  return aimed;
}

// How many rays get through, as nearest hits or as shadow rays, in bundles of all sizes.
int Leaks(const Placed& placed, const Aimed& aimed) {
  int leaks = 0;
  const size_t count = aimed.rays.size();
  for (const size_t bundle : {size_t{1}, size_t{7}, size_t{64}, size_t{1024}}) {
    std::vector<Hit> hits(count);
    std::vector<uint8_t> blocked(count);
    OpCounts counts;
    for (size_t i = 0; i < count; i += bundle) {
      const size_t n = std::min(bundle, count - i);
      placed.set().Nearest({aimed.rays.data() + i, n}, {hits.data() + i, n}, &counts);
      placed.set().Block({aimed.rays.data() + i, n}, {aimed.limits.data() + i, n},
                         {blocked.data() + i, n}, &counts);
    }
    for (size_t i = 0; i < count; ++i) {
      leaks += !(hits[i].distance <= aimed.limits[i]);
      leaks += !blocked[i];
    }
  }
  return leaks;
}

// The same for rays from all sides towards one lamp, as rows of shadow rays.
int LeaksTowards(const Placed& placed, const Vector& lamp, double away, double size,
                 Random* random) {
  constexpr size_t kCount = kRaysPerDistance, kRoom = (kCount + 7) / 8 * 8;
  std::vector<double> rows[8];  // origin, direction, limit, time
  for (std::vector<double>& row : rows) row.assign(kRoom, .5);
  for (size_t i = 0; i < kCount; ++i) {
    const Vector target = placed.Target(random).first;
    const Vector origin = target + away * size * Normalized(target - lamp);
    Vector toward = lamp - origin;
    rows[6][i] = Normalize(&toward);
    rows[7][i] = 0;
    for (int k = 0; k < 3; ++k) {
      rows[k][i] = origin[k];
      rows[3 + k][i] = toward[k];
    }
  }
  double reach = 0;
  for (int k = 0; k < 3; ++k) {
    for (const double x : rows[k]) reach = std::max(reach, std::abs(x));
    reach = std::max(reach, std::abs(lamp[k]));
  }
  std::vector<uint8_t> blocked(kRoom);
  OpCounts counts;
  placed.set().Block({{rows[0].data(), rows[1].data(), rows[2].data()},
                      {rows[3].data(), rows[4].data(), rows[5].data()},
                      rows[6].data(),
                      rows[7].data(),
                      {lamp.x, lamp.y, lamp.z},
                      reach,
                      blocked.data(),
                      nullptr,
                      static_cast<uint32_t>(kCount)},
                     &counts);
  return static_cast<int>(std::count(blocked.begin(), blocked.begin() + kCount, 0));
}

// size: of the mesh in the world; inside: a place within the closed mesh, where there is one.
void ExpectClosed(const Mesh& mesh, std::optional<Transform> transform, double size,
                  std::optional<Vector> inside) {
  Placed placed(mesh, transform);
  for (const char* simd : kAllKernels) {
    placed.Build(simd);
    Random random(11);
    for (double away = .01; away <= kFarthest; away *= 100) {
      SCOPED_TRACE(testing::Message() << simd << " from " << away);
      EXPECT_EQ(0, Leaks(placed, AimAtEdges(placed, away, size, &random)));
      if (!inside) continue;
      EXPECT_EQ(0, LeaksTowards(placed, *inside, away, size, &random));
    }
  }
}

// Turned by an angle that is no simple fraction, stretched and far from the origin.
Transform Pose(double size) {
  bool degenerate;
  return Compose(
      Compose(*Scale({size, 1.25 * size, .75 * size}), *Rotate({1, 2, .5}, 33.3, &degenerate)),
      Translate({7 * size, -5 * size, 3 * size}));
}

TEST(Watertight, AClosedMeshOfTriangles) {
  Random random(1);
  for (const double roughness : {0., .1}) {
    const Mesh rock = Rock(3, roughness, &random);
    ExpectClosed(rock, {}, 1, Vector{});
    ExpectClosed(rock, Pose(3), 3, Pose(3).Point({}));
  }
}

TEST(Watertight, AClosedMeshThatWasMovedBeforeItWasWritten) {
  Random random(2);
  Mesh rock = Rock(3, .1, &random);
  const Transform pose = Pose(1e3);
  for (Vector& p : rock.points) p = pose.Point(p);
  rock.faces.clear();
  rock.Close();
  ExpectClosed(rock, {}, 1e3, pose.Point({}));
}

TEST(Watertight, AClosedMeshOfPolygons) {
  Random random(3);
  for (const int sides : {3, 4, 11}) {
    const Mesh drum = Drum(sides, &random);
    ExpectClosed(drum, {}, 1, Vector{});
    ExpectClosed(drum, Pose(.2), .2, Pose(.2).Point({}));
  }
}

TEST(Watertight, AHeightfield) {
  Random random(4);
  for (const double height : {.05, 3.}) {
    const Mesh relief = Relief(40, height, &random);
    ExpectClosed(relief, {}, 1, {});
    ExpectClosed(relief, Pose(30), 30, {});
  }
}

}  // namespace
}  // namespace rayshade
