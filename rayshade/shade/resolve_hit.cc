// From a hit in the space of its primitive to a surface in the world [rayshade4/2 s.2.5, 4;
// rayshade4/3 s.4, 9].
#include "rayshade/common/check.h"
#include "rayshade/geom/unit.h"
#include "rayshade/shade/shade.h"
#include "rayshade/shade/slack.h"

namespace rayshade {
namespace {

// Turns both normals towards the viewer; true where the ray enters, by the normals alone.
bool TurnToViewer(HitPath* path) {
  double k = Dot(path->ray.direction, path->normal);
  if (path->smooth) {
    const double geometric = Dot(path->ray.direction, path->geometric_normal);
    if ((k <= 0 && geometric > 0) || (k >= 0 && geometric < 0)) k = geometric;
  }
  if (k > 0) {
    path->normal = -path->normal;
    path->geometric_normal = -path->geometric_normal;
  }
  return k <= 0;
}

// The first bound surface from the primitive outwards.
const Surface& BoundSurface(const Scene& scene, const HitPath& path, const Placement& placement) {
  for (const Attributes* inner : path.inner) {
    if (inner->surface != kNoSurface) return scene.bound_surface(inner->surface);
  }
  return scene.bound_surface(placement.surface);
}

// Calls visit for all that is written around the primitive, from inside outwards.
template <class Visit>
void ForEachLevel(const HitPath& path, const Placement& placement, Visit visit) {
  for (const Attributes* inner : path.inner) visit(*inner);
  for (const PathLevel& level : placement.levels) visit(level.attributes);
}

// Rays that leave an edge may graze a face other than that of the normal: they count as grazing
// all.
void MindEdges(const HitPath& path, const Transform* to_world, SurfaceHit* resolved) {
  if (path.primitive != nullptr && path.primitive->AtEdge(path.point, to_world, resolved->slack)) {
    resolved->face = {};
  }
}

// Transformations and textures on the path. resolved: point and normals in primitive space so far.
class PathWalk {
 public:
  PathWalk(const Scene& scene, const Ray& ray, const HitPath& path, const Placement& placement)
      : scene_(scene), ray_(ray), path_(path), placement_(placement) {
    moment_ = {scene.shutter.frame, ray.time};
    ForEachLevel(path, placement, [&](const Attributes& attributes) {
      transformed_ |= !attributes.transforms.empty();
      textured_ |= !attributes.textures.empty();
    });
  }

  void Resolve(double distance, SurfaceHit* resolved) const {
    if (textured_) {
      WithTextures(distance, resolved);
    } else if (transformed_) {
      Plainly(distance, resolved);
    } else {
      MindEdges(path_, nullptr, resolved);
    }
  }

 private:
  void Plainly(double distance, SurfaceHit* resolved) const {
    Transform whole;
    bool first = true;
    ForEachLevel(path_, placement_, [&](const Attributes& attributes) {
      if (attributes.transforms.empty()) return;
      const Transform level = attributes.transforms.Whole(moment_);
      whole = first ? level : Compose(whole, level);
      first = false;
    });
    resolved->normal = UnitOf(whole.Normal(resolved->normal));
    resolved->geometric_normal = UnitOf(whole.Normal(resolved->geometric_normal));
    resolved->point = ray_.origin + distance * ray_.direction;
    resolved->face = UnitOf(resolved->geometric_normal);
    resolved->slack = SlackOf(ray_, path_, distance, whole);
    MindEdges(path_, &whole, resolved);
  }

  // Each level's transformations, then its textures. The geometric normal stays where it is
  // [rayshade4/3 s.4.5].
  void WithTextures(double distance, SurfaceHit* resolved) const {
    TextureHit hit;
    hit.surface = *resolved->bound;
    hit.normal = resolved->normal;
    hit.point = resolved->point;
    hit.ray_origin = path_.ray.origin;
    hit.ray_direction = path_.ray.direction;
    hit.path = &path_;
    hit.moment = moment_;
    if (scene_.objects_are_stale) hit.moment.time = scene_.shutter.open;
    hit.key = ray_.key;
    hit.sample_number = ray_.sample_number;
    hit.samples = scene_.settings().samples;
    ForEachLevel(path_, placement_, [&](const Attributes& attributes) {
      if (!attributes.transforms.empty()) {
        const Transform level = attributes.transforms.Whole(moment_);
        hit.point = level.Point(hit.point);
        hit.normal = UnitOf(level.Normal(hit.normal));
        hit.ray_origin = level.Point(hit.ray_origin);
        hit.ray_direction = UnitOf(level.Direction(hit.ray_direction));
        hit.primitive_to_model = Compose(hit.primitive_to_model, level);
      }
      for (TextureId texture : attributes.textures) {
        scene_.textures[texture]->Apply(&hit);
        ++hit.application;
      }
    });
    resolved->textured = true;
    resolved->own = hit.surface;
    resolved->point = hit.point;
    resolved->normal = hit.normal;
    Normalize(&resolved->geometric_normal);
    if (!transformed_) return MindEdges(path_, nullptr, resolved);
    resolved->face = UnitOf(hit.primitive_to_model.Normal(resolved->face));
    resolved->slack = SlackOf(ray_, path_, distance, hit.primitive_to_model);
    MindEdges(path_, &hit.primitive_to_model, resolved);
  }

  const Scene& scene_;
  const Ray& ray_;
  const HitPath& path_;
  const Placement& placement_;
  Moment moment_;
  bool transformed_ = false, textured_ = false;
};

void SetMirror(const Ray& ray, SurfaceHit* resolved) {
  resolved->facing = -Dot(ray.direction, resolved->normal);
  resolved->mirror = ray.direction + (2 * resolved->facing) * resolved->normal;
}

// The same as Describe and the general way, without a path.
void ResolvePlain(const Scene& scene, const Ray& ray, double distance,
                  const ObjectSet::PlainSphere& plain, SurfaceHit* resolved) {
  const double* const c = plain.center;
  const Vector center = {c[0], c[plain.stride], c[2 * plain.stride]};
  const double radius = c[3 * plain.stride];
  resolved->point = ray.origin + distance * ray.direction;
  const Vector n = resolved->point - center;
  Vector normal = {n.x / radius, n.y / radius, n.z / radius};
  resolved->entering = Dot(ray.direction, normal) <= 0;
  if (Dot(ray.direction, normal) > 0) normal = -normal;
  resolved->normal = resolved->geometric_normal = resolved->face = normal;
  resolved->smooth = false;
  resolved->slack = SlackOf(ray, SumOfSizes(center) + 3 * radius, distance);
  resolved->textured = false;
  resolved->bound = &scene.bound_surface(plain.surface);
  resolved->bound_transp = resolved->bound->transp;
  SetMirror(ray, resolved);
}

}  // namespace

void ResolveHit(const Scene& scene, const Ray& ray, const Hit& hit, HitPath* path,
                SurfaceHit* resolved) {
  CHECK(hit.set != nullptr);
  ObjectSet::PlainSphere plain;
  if (hit.set->IsPlainSphere(hit.object, &plain)) {
    return ResolvePlain(scene, ray, hit.distance, plain, resolved);
  }
  hit.set->Describe(ray, hit, path);
  const Placement& placement = scene.placement(hit.set->placement_of(hit.object));
  const bool enters = TurnToViewer(path);
  resolved->entering = path->stamp == Stamp::kNone ? enters : path->stamp == Stamp::kEntering;
  resolved->point = path->point;
  resolved->normal = path->normal;
  resolved->geometric_normal = path->geometric_normal;
  resolved->smooth = path->smooth;
  resolved->face = path->geometric_normal;
  resolved->slack = SlackOf(ray, path->reach, hit.distance);
  resolved->textured = false;
  resolved->bound = &BoundSurface(scene, *path, placement);
  resolved->bound_transp = resolved->bound->transp;
  if (!placement.plain || !path->inner.empty()) {
    PathWalk(scene, ray, *path, placement).Resolve(hit.distance, resolved);
  } else {
    MindEdges(*path, nullptr, resolved);
  }
  SetMirror(ray, resolved);
}

void ResolveHit(const Scene& scene, const Ray& ray, const Hit& hit, SurfaceHit* resolved) {
  HitPath path;
  ResolveHit(scene, ray, hit, &path, resolved);
}

}  // namespace rayshade
