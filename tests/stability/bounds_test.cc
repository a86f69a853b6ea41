// The bounds of doc/stability.md, on fewer rays than `make stability` shoots, and what the
// textbooks' formulas do in their place.
#include <gtest/gtest.h>

#include <map>

#include "tests/stability/measure.h"
#include "tests/stability/spawned.h"

namespace rayshade::stability {
namespace {

constexpr double kRounding = 0x1.0p-53;
constexpr int kRays = 200;

// In roundings of the distance and the size of the object, together. Cylinder and cone keep
// Rayshade's own arithmetic up to 30 sizes away.
double BoundOf(const std::string& primitive) {
  if (primitive == "cone") return 2000;
  if (primitive == "cylinder") return 100;
  return 20;
}

void ExpectRight(const Subject& subject, double size, double distance) {
  const Measurement m = Measure(subject, size, distance, kRays);
  SCOPED_TRACE(testing::Message() << subject.name << " of size " << size << " from " << distance);
  EXPECT_GT(m.hits, 10);
  EXPECT_EQ(0, m.ours.wrong);
  EXPECT_EQ(0, m.ours.wrong_counts);
  EXPECT_LE(m.ours.worst, BoundOf(subject.name) * kRounding * (1 + distance));
}

TEST(StabilityBounds, HoldFromAnyDistance) {
  for (const Subject& subject : SubjectsOf(1)) {
    for (const double distance : {1e-6, 1e-3, 1., 1e2, 1e4, 1e6, 1e8, 1e9}) {
      ExpectRight(subject, 1, distance);
    }
  }
}

TEST(StabilityBounds, HoldAtAnySize) {
  for (const double size : {1e-5, 1e-4, 1e-2, 1e3, 1e6, 1e9}) {
    for (const Subject& subject : SubjectsOf(size)) ExpectRight(subject, size, 10);
  }
}

Measurement MeasureOne(const std::string& name, double distance) {
  for (const Subject& subject : SubjectsOf(1)) {
    if (subject.name == name) return Measure(subject, 1, distance, kRays);
  }
  return {};
}

TEST(StabilityBounds, AreNotKeptByTheTextbooks) {
  const Measurement near = MeasureOne("sphere", 1e6), far = MeasureOne("sphere", 1e8);
  EXPECT_GT(near.plain.misplaced, .85 * near.hits);
  EXPECT_GT(far.plain.wrong_counts, .5 * far.rays);
  const Measurement torus = MeasureOne("torus", 1e4);
  EXPECT_GT(torus.plain.wrong_counts, .8 * torus.hits);
}

TEST(SpawnedRays, NeverMeetTheSurfaceWhereTheyBegin) {
  for (const SpawnedCount& count : CountOwnHits(40, 500)) {
    SCOPED_TRACE(count.primitive);
    EXPECT_EQ(20000, count.rays);
    EXPECT_EQ(0, count.own);
    EXPECT_GT(count.own_by_original, 0);  // such rays are among them
  }
}

}  // namespace
}  // namespace rayshade::stability
