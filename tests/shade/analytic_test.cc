// Pictures that can be written down as formulas: a box of mirrors, a slab and a rod of glass, a lit
// sphere. The renderer's linear colours agree with the formulas to 1e-12. The formulas know no
// hits: they unfold the box, walk through the glass by Snell's law, and take the sphere's normal
// from its equation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/shade/text_scene.h"
#include "tests/support/random.h"

namespace rayshade::test {
namespace {

constexpr double kTolerance = 1e-12;
constexpr int kRays = 500;

void ExpectColor(const Color& expected, const Color& actual) {
  EXPECT_NEAR(expected.r, actual.r, kTolerance);
  EXPECT_NEAR(expected.g, actual.g, kTolerance);
  EXPECT_NEAR(expected.b, actual.b, kTolerance);
}

// The brightness of a matte surface at p with unit normal n, light at `light` without shadows.
double Lambert(const Vector& p, const Vector& n, const Vector& light) {
  return std::max(0.0, Dot(Normalized(light - p), n));
}

// A box of six mirrors, each with colours of its own, a lamp in the middle and fog between them.
constexpr int kBounces = 24;
const Vector kBox{3, 2, 1.5};  // from the origin
const Vector kLamp{1.3, .9, .8};
const Color kFog{.2, .5, .7};
const Color kHalf{9, 12, 15};       // distances in which the fog takes half
constexpr double kLn2 = .69314718;  // as Rayshade knows it [rayshade4/3 s.1]

struct Wall {
  Color ambient, diffuse, tint;
};
constexpr double kReflect = .9;

Wall WallOf(int axis, bool far) {
  const double a = .1 + .05 * axis + (far ? .02 : 0);
  return {{a, 2 * a, .3 - a}, {.4 - a, .3, a}, {1 - a, .9, .8 + a}};
}

std::string MirrorBox() {
  std::ostringstream text;
  text.precision(17);
  text << "maxdepth " << kBounces << "\ncutoff 0\nlight 1 point " << kLamp.x << " " << kLamp.y
       << " " << kLamp.z << " noshadow\natmosphere 1 fog .2 .5 .7 9 12 15\n";
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool far : {false, true}) {
      const Wall w = WallOf(axis, far);
      Vector at{}, normal{};
      at[axis] = far ? kBox[axis] : 0;
      normal[axis] = 1;
      text << "plane ambient " << w.ambient.r << " " << w.ambient.g << " " << w.ambient.b
           << " diffuse " << w.diffuse.r << " " << w.diffuse.g << " " << w.diffuse.b << " specular "
           << w.tint.r << " " << w.tint.g << " " << w.tint.b << " specpow 0 reflect .9 " << at.x
           << " " << at.y << " " << at.z << " " << normal.x << " " << normal.y << " " << normal.z
           << "\n";
    }
  }
  return text.str();
}

// Where the straight line through the unfolded boxes crosses a mirror.
struct Crossing {
  double distance;
  int axis;
  int64_t plane;  // its number along the axis: even ones are images of the near wall
};

std::vector<Crossing> Crossings(const Vector& origin, const Vector& direction) {
  std::vector<Crossing> crossings;
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i <= kBounces; ++i) {
      const int64_t plane = direction[axis] > 0 ? 1 + i : -i;
      crossings.push_back(
          {(static_cast<double>(plane) * kBox[axis] - origin[axis]) / direction[axis], axis,
           plane});
    }
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.distance < b.distance; });
  crossings.resize(kBounces + 1);
  return crossings;
}

// From a place in the unfolded boxes to the one in the box.
double Folded(double x, double side) {
  const double rest = x - 2 * side * std::floor(x / (2 * side));
  return rest < side ? rest : 2 * side - rest;
}

Color MirrorFormula(const Vector& origin, const Vector& direction) {
  const std::vector<Crossing> crossings = Crossings(origin, direction);
  Color color;
  for (size_t i = crossings.size(); i-- > 0;) {
    const Crossing& c = crossings[i];
    const bool far = c.plane % 2 != 0;
    const Wall wall = WallOf(c.axis, far);
    Vector place = origin + c.distance * direction, normal{};
    for (int axis = 0; axis < 3; ++axis) place[axis] = Folded(place[axis], kBox[axis]);
    place[c.axis] = far ? kBox[c.axis] : 0;
    normal[c.axis] = far ? -1 : 1;
    const double leg = c.distance - (i == 0 ? 0 : crossings[i - 1].distance);
    for (int k = 0; k < 3; ++k) {
      // What comes out of the mirror, and what of it the fog lets through.
      const double lit = wall.ambient[k] + wall.diffuse[k] * Lambert(place, normal, kLamp) +
                         kReflect * wall.tint[k] * color[k];
      const double left = std::exp(-kLn2 * leg / kHalf[k]);
      color[k] = left * lit + (1 - left) * kFog[k];
    }
  }
  return color;
}

TEST(AnalyticPictures, ABoxOfMirrorsIsTheUnfoldedBox) {
  TextScene scene(MirrorBox());
  Random random(1);
  for (int i = 0; i < kRays; ++i) {
    const Vector origin{Uniform(&random, .1, 2.9), Uniform(&random, .1, 1.9),
                        Uniform(&random, .1, 1.4)};
    const Vector direction = RandomDirection(&random);
    SCOPED_TRACE(i);
    ExpectColor(MirrorFormula(origin, direction), scene.Trace(origin, direction).color);
  }
  EXPECT_EQ(scene.counts().reflected_rays, static_cast<uint64_t>(kRays) * kBounces);
}

// The glass below, and the floor behind it, whose brightness tells where it is met.
constexpr double kIndex = 1.5, kExtinct = .7;
const Color kBody{.8, 1, .5};
constexpr double kTransp = .9;
const char kGlass[] = "transp .9 body .8 1 .5 index 1.5 extinct .7 ";

TEST(AnalyticPictures, ASlabOfGlassMovesRaysAsideAndAbsorbsThem) {
  TextScene scene(
      "light 1 point 1 5 2 noshadow\nbackground 1 1 1\n"
      "plane ambient .1 .2 .3 diffuse .6 .5 .4 0 9 0 0 -1 0\n"
      "box " +
      std::string(kGlass) + "-999 0 -999 999 2 999\n");
  Random random(2);
  for (int i = 0; i < kRays; ++i) {
    Vector direction = RandomDirection(&random);
    direction.y = std::abs(direction.y);
    if (direction.y < .02) continue;
    const Vector entry{Uniform(&random, -2, 2), 0, Uniform(&random, -2, 2)};
    const Vector origin = entry - 3 * direction;

    // Snell: what lies in the surface is divided by the index.
    const Vector across = (1 / kIndex) * Vector{direction.x, 0, direction.z};
    const double down = std::sqrt(1 - Dot(across, across)), length = 2 / down;
    const Vector exit = entry + length * across + Vector{0, 2, 0};
    const Vector floor = exit + 7 / direction.y * direction;
    const double lit = Lambert(floor, {0, -1, 0}, {1, 5, 2}), left = std::pow(kExtinct, length);
    const Color matte{.1 + .6 * lit, .2 + .5 * lit, .3 + .4 * lit};
    const Color pane = kTransp * kBody;
    SCOPED_TRACE(i);
    ExpectColor(left * (pane * pane * matte), scene.Trace(origin, direction).color);
  }
}

TEST(AnalyticPictures, ASlabThatMirrorsInsideIsAGeometricSeries) {
  constexpr int kDepth = 12;
  TextScene scene(
      "maxdepth 12\ncutoff 0\nlight 0 directional 0 -1 0\n"
      "plane ambient .1 .2 .3 0 9 0 0 -1 0\nplane ambient .7 .6 .5 0 -9 0 0 1 0\n"
      "box " +
      std::string(kGlass) + "specular .9 .8 .7 reflect .5 -999 0 -999 999 2 999\n");
  const Color below{.1, .2, .3}, above{.7, .6, .5}, mirror{.45, .4, .35};
  const Color pane = kTransp * kBody;
  for (const double degrees : {0., 15., 30., 45., 60., 75.}) {
    const double sine = std::sin(degrees * kPi / 180);
    const double length = 2 / std::sqrt(1 - sine * sine / (kIndex * kIndex));
    Color expected;
    for (int k = 0; k < 3; ++k) {
      // The ray inside meets the lower face, the upper one, and so on; where `kDepth` ends it, it
      // neither leaves nor goes on. Mirrored ways through the glass are not absorbed [rayshade4/3
      // s.5.1].
      double inside = 0, weight = 1;
      for (int bounce = 0; bounce + 1 < kDepth; ++bounce, weight *= mirror[k]) {
        inside += weight * pane[k] * (bounce % 2 == 0 ? below : above)[k];
      }
      expected[k] = mirror[k] * above[k] + pane[k] * std::pow(kExtinct, length) * inside;
    }
    SCOPED_TRACE(degrees);
    const Vector direction{sine, std::cos(degrees * kPi / 180), 0};
    ExpectColor(expected, scene.Trace(-3.0 * direction, direction).color);
  }
}

// A rod from x = 0 to 20 between y = 0 and 1 and z = 0 and 1.2: whatever enters at its end is
// reflected totally at the sides (index > sqrt 2) and leaves at the other end.
TEST(AnalyticPictures, ARodOfGlassGuidesRaysByTotalReflection) {
  constexpr double kLength = 20;
  TextScene scene(
      "maxdepth 99\ncutoff 0\nlight 1 point 22 3 2 noshadow\nbackground 1 1 1\n"
      "plane ambient .1 .2 .3 diffuse .6 .5 .4 25 0 0 -1 0 0\n"
      "box " +
      std::string(kGlass) + "0 0 0 20 1 1.2\n");
  Random random(3);
  for (int i = 0; i < kRays; ++i) {
    Vector direction = RandomDirection(&random);
    direction.x = std::abs(direction.x);
    if (direction.x < .05) continue;
    const Vector entry{0, Uniform(&random, .1, .9), Uniform(&random, .1, 1.1)};
    const Vector origin = entry - 2 * direction;

    Vector inside = (1 / kIndex) * direction;
    inside.x = std::sqrt(1 - inside.y * inside.y - inside.z * inside.z);
    const double way = kLength / inside.x, sides[2] = {1, 1.2};
    double first = way;  // up to the first side, or to the end
    int bounces = 0;
    Vector leaving = direction, exit{kLength, 0, 0};
    for (int axis = 1; axis < 3; ++axis) {
      const double side = sides[axis - 1], end = entry[axis] + way * inside[axis];
      const int crossed = static_cast<int>(std::abs(std::floor(end / side)));
      bounces += crossed;
      exit[axis] = Folded(end, side);
      if (crossed % 2 != 0) leaving[axis] = -leaving[axis];
      const double wall = inside[axis] > 0 ? side : 0;
      first = std::min(first, (wall - entry[axis]) / inside[axis]);
    }
    const Vector floor = exit + 5 / leaving.x * leaving;
    const double lit = Lambert(floor, {-1, 0, 0}, {22, 3, 2});
    const Color matte{.1 + .6 * lit, .2 + .5 * lit, .3 + .4 * lit};
    Color expected;
    for (int k = 0; k < 3; ++k) {
      // One pane on the way in, one on the way out, one at each total reflection.
      expected[k] =
          std::pow(kTransp * kBody[k], 2 + bounces) * std::pow(kExtinct, first) * matte[k];
    }
    SCOPED_TRACE(i);
    ExpectColor(expected, scene.Trace(origin, direction).color);
  }
  EXPECT_GT(scene.counts().reflected_rays, 1000u);
}

// Ambient, diffuse and highlight of two lights, one of them hidden behind the sphere for a half.
TEST(AnalyticPictures, ALitSphereIsLambertAndPhong) {
  TextScene scene(
      "light .5 ambient\nlight .9 .8 .7 point 4 -5 6\nlight .3 .4 .5 directional -2 -1 .5\n"
      "sphere ambient .1 .2 .3 diffuse .4 .5 .6 specular .7 .5 .3 specpow 9 1.5 .2 .3 -.1\n");
  const Vector center{.2, .3, -.1}, lamp{4, -5, 6}, sun = Normalized(Vector{-2, -1, .5});
  const Color colors[2] = {{.9, .8, .7}, {.3, .4, .5}};
  const Color ambient{.1, .2, .3}, diffuse{.4, .5, .6}, specular{.7, .5, .3};
  Random random(4);
  for (int i = 0; i < kRays; ++i) {
    // Known before the ray: the point that it meets, and from where it comes.
    const Vector normal = RandomDirection(&random), point = center + 1.5 * normal;
    Vector from = RandomDirection(&random);
    if (Dot(from, normal) < 0) from = -from;
    const Vector eye = point + Uniform(&random, 1, 30) * from;
    const Vector mirrored = 2 * Dot(normal, from) * normal - from;
    const Vector towards[2] = {Normalized(lamp - point), sun};
    Color expected = .5 * ambient;
    for (int light = 0; light < 2; ++light) {
      const double cosine = Dot(towards[light], normal);
      if (cosine <= 0) continue;
      const double highlight = std::pow(std::max(0.0, Dot(mirrored, towards[light])), 9);
      for (int k = 0; k < 3; ++k) {
        expected[k] += (diffuse[k] * cosine + specular[k] * highlight) * colors[light][k];
      }
    }
    // Not at the border of the shadow, nor where the ray grazes: there a formula tells no side.
    if (Dot(from, normal) < .01 || std::abs(Dot(towards[0], normal)) < 1e-4 ||
        std::abs(Dot(sun, normal)) < 1e-4) {
      continue;
    }
    SCOPED_TRACE(i);
    ExpectColor(expected, scene.Trace(eye, point - eye).color);
  }
  EXPECT_GT(scene.counts().shadow_rays, 200u);
}

}  // namespace
}  // namespace rayshade::test
