// The primitives that are measured; see subjects.h.
#include "tests/stability/subjects.h"

#include <cmath>
#include <limits>

#include "rayshade/geom/make_geom.h"
#include "rayshade/geom/to_object.h"

namespace rayshade::stability {
namespace {

std::shared_ptr<const std::vector<float>> Relief(int size) {
  auto altitudes = std::make_shared<std::vector<float>>();
  for (int i = 0; i < size * size; ++i) {
    const int x = i % size, y = i / size;
    altitudes->push_back(.2f + .15f * std::sin(2.f * static_cast<float>(x)) *
                                   std::cos(1.5f * static_cast<float>(y)));
  }
  return altitudes;
}

}  // namespace

std::optional<double> Subject::Intersect(const Vector& origin, const Vector& direction, double min,
                                         double max) const {
  ObjectRay ray{origin, direction, {}};
  double to_object = 1, s;
  if (!ToObject(placement, &ray, &to_object)) return std::nullopt;
  if (!geom->Intersect(ray, min * to_object, max * to_object, &s)) return std::nullopt;
  return s / to_object;
}

std::vector<Subject> SubjectsOf(double size) {
  const auto at = [size](double x, double y, double z) {
    return Vector{size * x, size * y, size * z};
  };
  const Vector c = at(.3, -.2, .4), tilted{.36, -.48, .8};
  const Vector along = size * tilted;
  const Vector corner[4] = {c + at(-.9, -.5, -.3), c + at(.9, -.6, -.1), c + at(.5, .9, .6),
                            c + at(-.8, .4, .1)};
  const Vector flat[5] = {c + at(-.8, -.6, 0), c + at(.8, -.6, 0), c + at(.1, 0, 0),
                          c + at(.7, .7, 0), c + at(-.7, .5, 0)};
  std::vector<Subject> all = {
      {"sphere", SphereSpec{size, c}, c, size, 1, nullptr, {}},
      {"box", BoxSpec{c - at(.6, .5, .55), c + at(.4, .6, .5)}, c, size, 1, nullptr, {}},
      {"plane", PlaneSpec{c, tilted}, c, size, 1, nullptr, {}},
      {"disc", DiscSpec{size, c, tilted}, c, size, 1, nullptr, {}},
      {"triangle", TriangleSpec{{corner[0], corner[1], corner[2]}}, c, size, 1, nullptr, {}},
      {"Phong triangle",
       PhongTriangleSpec{{corner[0], corner[1], corner[3]}, {tilted, {0, .1, 1}, {.1, 0, 1}}},
       c,
       size,
       1,
       nullptr,
       {}},
      {"polygon", PolygonSpec{{flat, flat + 5}}, c, size, 1, nullptr, {}},
      {"cylinder",
       CylinderSpec{.6 * size, c - .8 * along, c + .8 * along},
       c,
       size,
       1,
       nullptr,
       {}},
      {"cone",
       ConeSpec{.6 * size, c - .8 * along, .1 * size, c + .8 * along},
       c,
       size,
       1,
       nullptr,
       {}},
      {"torus", TorusSpec{.7 * size, .3 * size, c, tilted}, c, size, 1, nullptr, {}},
      {"blob",
       BlobSpec{.4,
                {{1, .8 * size, c - at(.2, 0, 0)},
                 {1, .7 * size, c + at(.3, .1, 0)},
                 {.8, .5 * size, c + at(0, -.4, .1)}}},
       c,
       size,
       1,
       nullptr,
       {}},
      {"heightfield",
       HeightfieldSpec{"relief", 7, Relief(7)},
       at(.5, .5, .2),
       .75 * size,
       size,
       nullptr,
       {}},
  };
  std::vector<Subject> usable;
  for (Subject& subject : all) {
    const auto complaint = CheckGeom(subject.spec);
    if (complaint && complaint->dropped) continue;
    if (subject.scale != 1) {
      const auto scale = Scale({size, size, size});
      if (!scale) continue;
      subject.placement.Append(*scale);
    }
    subject.geom = MakeGeom(subject.spec);
    usable.push_back(std::move(subject));
  }
  return usable;
}

}  // namespace rayshade::stability
