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

  // Appends what a hit of the ray spawns; false where nothing is hit. faces: where it is.
  bool Spawn(const Ray& ray, std::vector<Ray>* spawned, std::vector<Vector>* faces) {
    Hit hit = Nearest(ray);
    if (!hit.found()) return false;
    HitPath path;
    SurfaceHit resolved;
    ResolveHit(*built_.scene, ray, hit, &path, &resolved);
    built_.objects->Describe(ray, hit, &path);
    *faces = FacesAt(path, resolved);
    RayBundle bundle;
    SpawnSecondary(*built_.scene, ray, {}, resolved, &bundle, &bundle);
    *spawned = bundle.rays;
    LightSample sample;
    Ray shadow;
    for (uint32_t light = 0; light < built_.scene->lights.size(); ++light) {
      if (SampleLight(*built_.scene, light, ray, resolved, &sample, &shadow, &counts_))
        spawned->push_back(shadow);
    }
    return true;
  }

  Hit Nearest(const Ray& ray) {
    Hit hit;
    built_.objects->Nearest({&ray, 1}, {&hit, 1}, &counts_);
    return hit;
  }

  // Is the hit the place where the ray begins? faces: FacesAt there.
  bool IsOwn(const Ray& ray, const Hit& hit, const std::vector<Vector>& faces) const {
    HitPath path;
    built_.objects->Describe(ray, hit, &path);
    if (!HasFaces()) {
      return path.distance <
             .5 * NextCrossing(object_.placed.geom, path.ray.origin, path.ray.direction);
    }
    // A line crosses a plane once: whatever lies only on planes in which the ray begins is wrong.
    SurfaceHit resolved;
    ResolveHit(*built_.scene, ray, hit, &path, &resolved);
    built_.objects->Describe(ray, hit, &path);
    const std::vector<Vector> there = FacesAt(path, resolved);
    return std::all_of(there.begin(), there.end(), [&](const Vector& face) {
      return std::find(faces.begin(), faces.end(), face) != faces.end();
    });
  }

 private:
  bool HasFaces() const {
    return std::holds_alternative<BoxSpec>(object_.placed.geom) ||
           std::holds_alternative<HeightfieldSpec>(object_.placed.geom);
  }

  // On which faces of the object is it, by their normals in object space? At an edge of a box, all
  // that rounding cannot tell from the point.
  std::vector<Vector> FacesAt(const HitPath& path, const SurfaceHit& resolved) const {
    const auto* box = std::get_if<BoxSpec>(&object_.placed.geom);
    if (box == nullptr) return {path.normal};
    double gaps[6];  // in the world
    for (int i = 0; i < 6; ++i) {
      const double side = (i % 2 == 0 ? box->corner : box->opposite)[i / 2];
      gaps[i] = std::abs(path.point[i / 2] - side) / Length(whole_.Normal(FaceNormal(i)));
    }
    const double nearest = *std::min_element(gaps, gaps + 6);
    std::vector<Vector> faces;
    for (int i = 0; i < 6; ++i) {
      if (gaps[i] <= std::max(nearest, resolved.slack / 8)) faces.push_back(FaceNormal(i));
    }
    return faces;
  }

  static Vector FaceNormal(int face) {
    Vector normal;
    normal[face / 2] = face % 2 == 0 ? -1 : 1;
    return normal;
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
    std::vector<Vector> faces;
    if (!stage.Spawn(stage.Aim(random), &spawned, &faces)) continue;
    for (Ray& ray : spawned) {
      if (done++ == rays) break;
      ++own.rays;
      own.at_edges += faces.size() > 1;
      const Hit hit = stage.Nearest(ray);
      if (hit.found()) {
        ++own.hits;
        own.own += stage.IsOwn(ray, hit, faces);
      }
      ray.min_distance = ray.kind == RayKind::kShadow ? kShadowEpsilon : kEpsilon;
      const Hit original = stage.Nearest(ray);
      own.own_by_original += original.found() && stage.IsOwn(ray, original, faces);
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
