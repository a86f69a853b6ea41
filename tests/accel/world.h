// A scene in an ObjectSet and as a list of all its objects, each asked through its Geom.
#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "rayshade/accel/object_set.h"
#include "rayshade/geom/make_geom.h"
#include "tests/support/random.h"

namespace rayshade::test {

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
    double near = ray.min_distance, far = std::numeric_limits<double>::infinity();
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

inline Ray MakeRay(const Vector& origin, const Vector& direction) {
  Ray ray;
  ray.origin = origin;
  ray.direction = direction;
  return ray;
}

inline void AddSpheres(World* world, Random* random, int count, double size,
                       const Vector& at = {}) {
  for (int i = 0; i < count; ++i) {
    world->Add(SphereSpec{Uniform(random, 0.001, 0.1) * size, at + RandomPoint(random, size)},
               static_cast<PlacementId>((*random)() % 2));
  }
}

inline void AddFlat(World* world, Random* random, int count, double size, const Vector& at = {}) {
  for (int i = 0; i < count; ++i) {
    const Vector a = at + RandomPoint(random, size);
    const Vector b = a + RandomPoint(random, size / 4), c = a + RandomPoint(random, size / 4);
    const PlacementId placement = static_cast<PlacementId>((*random)() % 3);
    if (i % 2 == 0) {
      world->Add(TriangleSpec{{a, b, c}}, placement);
    } else {
      world->Add(PolygonSpec{{a, b, b + 0.5 * (c - a), c}}, placement);
    }
  }
}

}  // namespace rayshade::test
