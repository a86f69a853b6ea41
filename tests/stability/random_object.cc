// Random primitives; see random_object.h.
#include "tests/stability/random_object.h"

#include <cmath>

#include "rayshade/geom/make_geom.h"

namespace rayshade::stability {
namespace {

double Magnitude(Random* random, double low, double high) {
  return std::pow(10.0, Uniform(random, low, high));
}

double Coordinate(Random* random) {
  const double size = Magnitude(random, -8, 8);
  return (*random)() % 2 == 0 ? size : -size;
}

Vector RandomPoint(Random* random) {
  return {Coordinate(random), Coordinate(random), Coordinate(random)};
}

Vector Corner(const RandomObject& object, Random* random) {
  return object.center + object.reach * RandomDirection(random);
}

PolygonSpec RandomPolygon(const RandomObject& object, Random* random) {
  const Vector a = RandomDirection(random), b = Normalized(Cross(a, RandomDirection(random)));
  const int corners = 3 + static_cast<int>((*random)() % 5);
  PolygonSpec polygon;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * kPi * i / corners, r = object.reach * Uniform(random, .3, 1);
    polygon.points.push_back(object.center + r * std::cos(turn) * a + r * std::sin(turn) * b);
  }
  return polygon;
}

BlobSpec RandomBlob(const RandomObject& object, Random* random) {
  BlobSpec blob;
  blob.threshold = Uniform(random, .1, .6);
  const int balls = 1 + static_cast<int>((*random)() % 4);
  for (int i = 0; i < balls; ++i) {
    const Vector off = Uniform(random, 0, .4) * object.reach * RandomDirection(random);
    blob.balls.push_back({Uniform(random, .8, 2), object.reach * Uniform(random, .4, .6),
                          i == 0 ? object.center : object.center + off});
  }
  return blob;
}

HeightfieldSpec RandomHeightfield(Random* random) {
  const int size = 2 + static_cast<int>((*random)() % 20);
  auto altitudes = std::make_shared<std::vector<float>>();
  for (int i = 0; i < size * size; ++i) {
    altitudes->push_back(static_cast<float>(Uniform(random, 0, .5)));
  }
  return {"random", size, std::move(altitudes)};
}

GeomSpec RandomSpec(const std::string& kind, RandomObject* object, Random* random) {
  const double r = object->reach;
  const Vector c = object->center, axis = RandomDirection(random);
  if (kind == "sphere") return SphereSpec{r, c};
  if (kind == "box") {
    const auto side = [&] { return r * Uniform(random, .05, .55); };
    const Vector half{side(), side(), side()};
    return BoxSpec{c - half, c + half};
  }
  if (kind == "plane") return PlaneSpec{c, axis};
  if (kind == "disc") return DiscSpec{r, c, axis};
  if (kind == "polygon") return RandomPolygon(*object, random);
  if (kind == "cylinder") {
    const Vector half = r * Uniform(random, .1, .9) * axis;
    return CylinderSpec{r * Uniform(random, .05, .5), c - half, c + half};
  }
  if (kind == "cone") {
    const Vector half = r * Uniform(random, .1, .9) * axis;
    return ConeSpec{r * Uniform(random, .1, .5), c - half, r * Uniform(random, 0, .5), c + half};
  }
  if (kind == "torus") {
    const double tube = Uniform(random, .05, .45);
    return TorusSpec{r * (1 - tube), r * tube, c, axis};
  }
  if (kind == "blob") return RandomBlob(*object, random);
  if (kind == "heightfield") {
    object->center = {.5, .5, .25};
    object->reach = .8;
    return RandomHeightfield(random);
  }
  const Vector p[3] = {Corner(*object, random), Corner(*object, random), Corner(*object, random)};
  if (kind == "triangle") return TriangleSpec{{p[0], p[1], p[2]}};
  const Vector n = Normalized(Cross(p[1] - p[0], p[2] - p[1]));
  const auto normal = [&] { return n + .3 * RandomDirection(random); };
  return PhongTriangleSpec{{p[0], p[1], p[2]}, {normal(), normal(), normal()}};
}

TransformChain RandomPlacement(Random* random) {
  TransformChain chain;
  const auto factor = [&] { return Magnitude(random, -2, 2); };
  bool degenerate;
  chain.Append(*Scale({factor(), factor(), factor()}));
  chain.Append(*Rotate(RandomDirection(random), Uniform(random, 0, 360), &degenerate));
  chain.Append(Translate(RandomPoint(random)));
  return chain;
}

}  // namespace

double Uniform(Random* random, double low, double high) {
  return low + (high - low) * (static_cast<double>((*random)() >> 11) * 0x1.0p-53);
}

Vector RandomDirection(Random* random) {
  for (;;) {
    const Vector p{Uniform(random, -1, 1), Uniform(random, -1, 1), Uniform(random, -1, 1)};
    const double square = Dot(p, p);
    if (square <= 1 && square > .01) return Normalized(p);
  }
}

RandomObject MakeRandomObject(const std::string& kind, Random* random) {
  for (;;) {
    RandomObject object{{}, RandomPoint(random), Magnitude(random, -8, 8)};
    object.placed.geom = RandomSpec(kind, &object, random);
    const auto complaint = CheckGeom(object.placed.geom);
    if (complaint && complaint->dropped) continue;
    if ((*random)() % 2 == 0) object.placed.attributes.transforms = RandomPlacement(random);
    return object;
  }
}

}  // namespace rayshade::stability
