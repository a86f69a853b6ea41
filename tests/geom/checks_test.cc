// What is refused, and in which words [rayshade4/2 s.6, s.13].
#include <limits>

#include "tests/geom/probe.h"

namespace rayshade {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

std::string Said(const GeomSpec& spec) {
  const auto complaint = CheckGeom(spec);
  return complaint ? complaint->text : "";
}
Severity HowBad(const GeomSpec& spec) { return CheckGeom(spec)->severity; }

TEST(CheckGeom, RefusesDegenerateObjectsInRayshadesWords) {
  EXPECT_EQ("Degenerate sphere.", Said(SphereSpec{.99e-5, {}}));
  EXPECT_EQ("", Said(SphereSpec{1e-5, {}}));
  EXPECT_EQ("Degenerate sphere.", Said(SphereSpec{-1, {}}));
  EXPECT_EQ("Degenerate box.", Said(BoxSpec{{0, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ("Degenerate plane normal.", Said(PlaneSpec{{}, {0, 0, 9e-6}}));
  EXPECT_EQ("", Said(PlaneSpec{{}, {0, 0, 2e-5}}));
  EXPECT_EQ("Degenerate disc.", Said(DiscSpec{0, {}, {0, 0, 1}}));
  EXPECT_EQ("Degenerate disc normal.", Said(DiscSpec{1, {}, {}}));
  EXPECT_EQ("Degenerate polygon.", Said(PolygonSpec{{{0, 0, 0}, {1, 0, 0}}}));
  EXPECT_EQ("Degenerate torus.", Said(TorusSpec{1, 0, {}, {0, 0, 1}}));
  EXPECT_EQ("Degenerate torus normal.", Said(TorusSpec{1, 1, {}, {}}));
  EXPECT_EQ("blob field not correct.", Said(BlobSpec{1, {}}));
  EXPECT_EQ("Degenerate metaball in blob (sr).", Said(BlobSpec{1, {{-1, 1, {}}}}));
}

TEST(CheckGeom, DropsTrianglesBelowTheAbsoluteAreaWithAdviceOnly) {
  const auto legs = [](double a) { return TriangleSpec{{{0, 0, 0}, {a, 0, 0}, {0, a, 0}}}; };
  EXPECT_EQ("Degenerate triangle.", Said(legs(3e-3)));
  EXPECT_EQ(Severity::kAdvise, HowBad(legs(3e-3)));
  EXPECT_EQ("", Said(legs(3.3e-3)));
}

TEST(CheckGeom, DropsPolygonsBelowTheAbsoluteArea) {
  const auto square = [](double a) {
    return PolygonSpec{{{0, 0, 0}, {a, 0, 0}, {a, a, 0}, {0, a, 0}}};
  };
  EXPECT_EQ("Degenerate polygon.", Said(square(2e-3)));
  EXPECT_EQ("", Said(square(3e-3)));
}

TEST(CheckGeom, AdvisesOnNormalsThatPointToTheOtherSideButKeepsTheTriangle) {
  PhongTriangleSpec spec{{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}}, {{0, 0, -1}, {0, 0, 1}, {0, 0, 1}}};
  EXPECT_EQ("Inconsistant triangle normals.", Said(spec));
  EXPECT_FALSE(CheckGeom(spec)->dropped);
  spec.flip = true;
  EXPECT_EQ("", Said(spec));
  spec.normal[2] = {};
  EXPECT_EQ("Degenerate vertex normal.", Said(spec));
}

TEST(CheckGeom, StopsAtSingularCylindersAndCones) {
  EXPECT_EQ("Invalid cylinder radius.", Said(CylinderSpec{0, {}, {0, 0, 1}}));
  EXPECT_EQ("Degenerate cylinder.", Said(CylinderSpec{1, {}, {}}));
  EXPECT_EQ("Singular matrix.", Said(CylinderSpec{1e-5, {}, {0, 0, .5}}));
  EXPECT_EQ(Severity::kFatal, HowBad(CylinderSpec{1e-5, {}, {0, 0, .5}}));
  EXPECT_EQ("Invalid cylinder radius.", Said(ConeSpec{0, {}, 0, {0, 0, 1}}));
  EXPECT_EQ("Degenerate cone.", Said(ConeSpec{1, {}, 2, {}}));
  EXPECT_EQ("Singular matrix.", Said(ConeSpec{-1, {}, 0, {0, 0, 1}}));
}

TEST(CheckGeom, RefusesNumbersThatAreNone) {
  const Vector bad{0, kNan, 0}, infinite{INFINITY, 0, 0};
  for (const Vector& v : {bad, infinite}) {
    EXPECT_NE("", Said(SphereSpec{1, v}));
    EXPECT_NE("", Said(BoxSpec{{-1, -1, -1}, v}));
    EXPECT_NE("", Said(PlaneSpec{v, {0, 0, 1}}));
    EXPECT_NE("", Said(PlaneSpec{{}, v}));
    EXPECT_NE("", Said(DiscSpec{1, v, {0, 0, 1}}));
    EXPECT_NE("", Said(TriangleSpec{{v, {1, 0, 0}, {0, 1, 0}}}));
    EXPECT_NE("", Said(PolygonSpec{{v, {1, 0, 0}, {0, 1, 0}}}));
    EXPECT_NE("", Said(CylinderSpec{1, v, {0, 0, 1}}));
    EXPECT_NE("", Said(ConeSpec{1, v, 2, {0, 0, 1}}));
    EXPECT_NE("", Said(TorusSpec{1, 1, v, {0, 0, 1}}));
    EXPECT_NE("", Said(BlobSpec{1, {{1, 1, v}}}));
  }
  EXPECT_NE("", Said(SphereSpec{kNan, {}}));
  EXPECT_NE("", Said(CylinderSpec{kNan, {}, {0, 0, 1}}));
  EXPECT_NE("", Said(ConeSpec{kNan, {}, 1, {0, 0, 1}}));
}

TEST(CheckGeom, WantsTwoOperandsForCsg) {
  const auto csg = [](size_t operands) {
    CompositeSpec spec;
    spec.members = std::make_shared<std::vector<PlacedSpec>>(operands);
    return spec;
  };
  EXPECT_EQ("CSG needs at least two objects.", Said(csg(1)));
  EXPECT_EQ("", Said(csg(2)));
  EXPECT_EQ("Currently, CSG only handles two objects.", Said(csg(3)));
}

TEST(CheckGeom, RefusesHeightfieldsWithoutEnoughSamples) {
  const auto samples = std::make_shared<std::vector<float>>(3);
  EXPECT_EQ("Not enough heightfield data.", Said(HeightfieldSpec{"", 2, samples}));
  EXPECT_NE("", Said(HeightfieldSpec{"", 1, samples}));
}

}  // namespace
}  // namespace rayshade
