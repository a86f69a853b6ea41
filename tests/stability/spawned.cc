// Spawned rays beside their own surface; see spawned.h.
#include "tests/stability/spawned.h"

#include <algorithm>
#include <cmath>

#include "rayshade/geom/unit.h"
#include "rayshade/scene/scene_builder.h"
#include "rayshade/shade/shade.h"
#include "tests/stability/next_crossing.h"
#include "tests/stability/random_object.h"

namespace rayshade::stability {
namespace {

constexpr int kTries = 40;  // primary rays for each ray to be spawned, before an object is given up

// One object under three lights.
class Stage {
 public:
  Stage(const RandomObject& object, Random* random) : object_(object) {
    SceneBuilder builder;
    Surface glass;
    glass.diffuse = glass.specular = {.5, .5, .5};
    glass.reflect = glass.transp = 1;
    glass.index = Uniform(random, .6, 2);
    PlacedSpec placed = object.placed;
    placed.attributes.surface = builder.AddSurface(glass);
    whole_ = placed.attributes.transforms.Whole({});
    builder.AddPrimitive(std::move(placed.geom), std::move(placed.attributes));
    for (int i = 0; i < 3; ++i) {
      builder.AddLight({{1, 1, 1}, false, DirectionalLightSpec{RandomDirection(random)}});
    }
    builder.OnSettings({});
    built_ = builder.Build(0);
  }

  // A ray from somewhere towards a point in or near the object.
  Ray Aim(Random* random) const {
    const double away = std::pow(10.0, Uniform(random, -1, 4)) * object_.reach;
    const Vector target =
        object_.center + Uniform(random, 0, 1) * object_.reach * RandomDirection(random);
    Ray ray;
    ray.origin = whole_.Point(target + away * RandomDirection(random));
    ray.direction = UnitOf(whole_.Point(target) - ray.origin);
    return ray;
  }

  // Appends what a hit of the ray spawns; false where nothing is hit.
  bool Spawn(const Ray& ray, std::vector<Ray>* spawned, Vector* face, bool* at_edge) {
    Hit hit = Nearest(ray);
    if (!hit.found()) return false;
    HitPath path;
    SurfaceHit resolved;
    ResolveHit(*built_.scene, ray, hit, &path, &resolved);
    built_.objects->Describe(ray, hit, &path);
    *face = FaceAt(path, resolved, at_edge);
    RayBundle bundle;
    SpawnSecondary(*built_.scene, ray, {}, resolved, &bundle, &bundle);
    *spawned = bundle.rays;
    std::vector<ShadowRay> shadows;
    SpawnShadows(*built_.scene, ray, resolved, &shadows, &counts_);
    for (const ShadowRay& shadow : shadows) spawned->push_back(shadow.ray);
    return true;
  }

  Hit Nearest(const Ray& ray) {
    Hit hit;
    built_.objects->Nearest({&ray, 1}, {&hit, 1}, &counts_);
    return hit;
  }

  // Is the hit the place where the ray begins?
  bool IsOwn(const Ray& ray, const Hit& hit, const Vector& face) const {
    HitPath path;
    built_.objects->Describe(ray, hit, &path);
    if (HasFaces()) {
      bool at_edge;
      return FaceAt(path, {}, &at_edge) == face;
    }
    return path.distance <
           .5 * NextCrossing(object_.placed.geom, path.ray.origin, path.ray.direction);
  }

 private:
  bool HasFaces() const {
    return std::holds_alternative<BoxSpec>(object_.placed.geom) ||
           std::holds_alternative<HeightfieldSpec>(object_.placed.geom);
  }

  // Which face of the object is it, by its normal in object space?
  Vector FaceAt(const HitPath& path, const SurfaceHit& resolved, bool* at_edge) const {
    *at_edge = false;
    const auto* box = std::get_if<BoxSpec>(&object_.placed.geom);
    if (box == nullptr) return path.normal;
    // Within rounding of an edge, the hit may count to either face.
    double gaps[6];
    for (int i = 0; i < 6; ++i) {
      const double side = (i % 2 == 0 ? box->corner : box->opposite)[i / 2];
      gaps[i] = std::abs(path.point[i / 2] - side);
    }
    const int nearest = static_cast<int>(std::min_element(gaps, gaps + 6) - gaps);
    std::nth_element(gaps, gaps + 1, gaps + 6);
    const double blur = 1e-13 * (path.reach + SumOfSizes(path.ray.origin) + path.distance);
    *at_edge = gaps[1] < std::max(blur, 1e-3 * resolved.slack);
    Vector face;
    face[nearest / 2] = nearest % 2 == 0 ? -1 : 1;
    return face;
  }

  RandomObject object_;
  Transform whole_;
  SceneBuilder::Built built_;
  OpCounts counts_;
};

// Spawns `rays` rays from one object, and counts. False where hardly any ray hits it.
bool CountOne(const RandomObject& object, int rays, Random* random, SpawnedCount* count) {
  Stage stage(object, random);
  SpawnedCount own = *count;
  std::vector<Ray> spawned;
  int done = 0;
  for (int tries = 0; done < rays; ++tries) {
    if (tries > kTries * rays) return false;
    Vector face;
    bool at_edge;
    if (!stage.Spawn(stage.Aim(random), &spawned, &face, &at_edge)) continue;
    if (at_edge) {
      ++own.at_edges;
      continue;
    }
    for (Ray& ray : spawned) {
      if (done++ == rays) break;
      ++own.rays;
      const Hit hit = stage.Nearest(ray);
      if (hit.found()) {
        ++own.hits;
        own.own += stage.IsOwn(ray, hit, face);
      }
      ray.min_distance = ray.kind == RayKind::kShadow ? kShadowEpsilon : kEpsilon;
      const Hit original = stage.Nearest(ray);
      own.own_by_original += original.found() && stage.IsOwn(ray, original, face);
    }
  }
  *count = own;
  ++count->objects;
  return true;
}

}  // namespace

std::vector<SpawnedCount> CountOwnHits(int objects, int rays) {
  std::vector<SpawnedCount> counts;
  for (const char* kind : kKinds) {
    SpawnedCount count;
    count.primitive = kind;
    Random random(counts.size() + 1);
    while (count.objects < objects) {
      CountOne(MakeRandomObject(kind, &random), rays, &random, &count);
    }
    counts.push_back(count);
  }
  return counts;
}

}  // namespace rayshade::stability
