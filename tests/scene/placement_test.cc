#include "rayshade/scene/placement.h"

#include <gtest/gtest.h>

namespace rayshade {
namespace {

PathLevel Level(const Transform& transform) {
  PathLevel level;
  level.attributes.transforms.Append(transform);
  return level;
}

// translate (10 * time, 0, 0)
AnimatedTransform Moving() {
  const Expression time({{ExpressionOp::kTime, 0}});
  const Expression ten_times = Apply(ExpressionOp::kMultiply, {Expression(10.0), time});
  return {TransformKind::kTranslate, {ten_times, Expression(0.0), Expression(0.0)}};
}

TEST(Placement, FinishSaysWhatIsOnThePath) {
  Placement bare;
  bare.levels.resize(2);
  bare.levels[1].attributes.surface = 4;
  bare.Finish();
  EXPECT_TRUE(bare.plain);
  EXPECT_TRUE(bare.in_place);
  EXPECT_EQ(bare.surface, 4u);

  bare.levels[0].attributes.surface = 7;
  bare.levels[1].attributes.textures = {0};
  bare.Finish();
  EXPECT_FALSE(bare.plain);
  EXPECT_TRUE(bare.in_place);
  EXPECT_EQ(bare.surface, 7u) << "an inner surface beats an outer one";

  bare.levels[1] = Level(Translate({1, 0, 0}));
  bare.Finish();
  EXPECT_FALSE(bare.in_place);

  Placement clipped;
  clipped.levels.resize(1);
  clipped.levels[0].clip = Bounds{{0, 0, 0}, {1, 1, 1}};
  clipped.Finish();
  EXPECT_FALSE(clipped.in_place);
  EXPECT_EQ(clipped.surface, kNoSurface);
}

TEST(Placement, ARayPassesTheOutermostLevelFirst) {
  // Inner scale 2, outer translate (5, 0, 0): the object's (1, 0, 0) stands at (7, 0, 0).
  Placement placement;
  placement.levels = {Level(*Scale({2, 2, 2})), Level(Translate({5, 0, 0}))};
  placement.Finish();
  ObjectRay object;
  double scale = 0;
  ASSERT_TRUE(ToObject(placement, {{7, 0, 4}, {0, 0, -1}, {}}, 0, kFar, &object, &scale));
  EXPECT_EQ(object.origin, (Vector{1, 0, 2}));
  EXPECT_EQ(object.direction, (Vector{0, 0, -1}));
  EXPECT_DOUBLE_EQ(scale, 0.5);
}

// Rayshade loses them [rayshade4/2 s.3.6]; s.15 has it among what is to be repaired.
TEST(Placement, ObjectsEnlargedBeyondTheNormaliseGuardStay) {
  Placement placement;
  ObjectRay object;
  double scale = 0;
  const ObjectRay ray{{0, 0, 9}, {0, 0, -1}, {}};
  placement.levels = {Level(*Scale({9e4, 9e4, 9e4}))};
  EXPECT_TRUE(ToObject(placement, ray, 0, kFar, &object, &scale));
  placement.levels = {Level(*Scale({100001, 100001, 100001}))};
  EXPECT_TRUE(ToObject(placement, ray, 0, kFar, &object, &scale));
  EXPECT_DOUBLE_EQ(scale, 1. / 100001);
  EXPECT_DOUBLE_EQ(object.direction.z, -1);
}

TEST(Placement, RaysThatMissAClipBoxDoNotSeeTheObject) {
  Placement placement;
  placement.levels.resize(1);
  placement.levels[0].clip = Bounds{{-1, -1, -1}, {1, 1, 1}};
  ObjectRay object;
  double scale = 0;
  const Vector down{0, 0, -1};
  EXPECT_TRUE(ToObject(placement, {{0, 0, 5}, down, {}}, 0, kFar, &object, &scale));
  EXPECT_TRUE(ToObject(placement, {{0, 0, 0}, down, {}}, 0, kFar, &object, &scale));
  EXPECT_FALSE(ToObject(placement, {{1.5, 0, 5}, down, {}}, 0, kFar, &object, &scale));
  EXPECT_FALSE(ToObject(placement, {{0, 0, 5}, down, {}}, 0, 3.5, &object, &scale)) << "too short";
  EXPECT_FALSE(ToObject(placement, {{0, 0, -5}, down, {}}, 0, kFar, &object, &scale)) << "behind";
}

TEST(Placement, ClipBoxesAreInTheLevelsOuterSpace) {
  Placement placement;
  placement.levels = {{}, Level(Translate({5, 0, 0})), {}};
  placement.levels[1].clip = Bounds{{4, -1, -1}, {6, 1, 1}};
  ObjectRay object;
  double scale = 0;
  EXPECT_TRUE(ToObject(placement, {{5, 0, 9}, {0, 0, -1}, {}}, 0, kFar, &object, &scale));
  EXPECT_FALSE(ToObject(placement, {{0, 0, 9}, {0, 0, -1}, {}}, 0, kFar, &object, &scale));
}

TEST(Placement, BoundsGrowBeforeAndAfterTheTransforms) {
  // Part 2, s.2.2: unit sphere translated by (3, 0, 0): x from 1.99998 to 4.00002.
  Placement placement;
  placement.levels = {Level(Translate({3, 0, 0}))};
  const Bounds box = WorldBounds(placement, {{-1, -1, -1}, {1, 1, 1}}, {});
  EXPECT_NEAR(box.low.x, 1.99998, 1e-12);
  EXPECT_NEAR(box.high.x, 4.00002, 1e-12);
}

TEST(Placement, BoundsOfMovingObjectsCoverTheShutter) {
  Placement placement;
  placement.levels.resize(1);
  placement.levels[0].attributes.transforms.Append(Moving());
  const Bounds own{{-1, -1, -1}, {1, 1, 1}};
  const Bounds box = WorldBounds(placement, own, {0, 2, 3});
  EXPECT_NEAR(box.low.x, 19, 1e-4);
  EXPECT_NEAR(box.high.x, 31, 1e-4);
  const Bounds still = WorldBounds(placement, own, {0, 2, 2});
  EXPECT_NEAR(still.high.x, 21, 1e-4);
}

TEST(Placement, RaysSeeMovingObjectsWhereTheyAreAtTheirTime) {
  Placement placement;
  placement.levels.resize(1);
  placement.levels[0].attributes.transforms.Append(Moving());
  ObjectRay object;
  double scale = 0;
  ASSERT_TRUE(ToObject(placement, {{7, 0, 9}, {0, 0, -1}, {0, .5}}, 0, kFar, &object, &scale));
  EXPECT_DOUBLE_EQ(object.origin.x, 2);
}

}  // namespace
}  // namespace rayshade
