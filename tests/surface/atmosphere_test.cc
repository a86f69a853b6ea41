// The rows of [rayshade4/3 s.16.5] that one ray decides; six digits of the original.
#include "rayshade/surface/atmosphere.h"

#include <gtest/gtest.h>

namespace rayshade {
namespace {

constexpr double kTolerance = 1e-6;

void ExpectColor(const Color& actual, const Color& expected) {
  EXPECT_NEAR(actual.r, expected.r, kTolerance);
  EXPECT_NEAR(actual.g, expected.g, kTolerance);
  EXPECT_NEAR(actual.b, expected.b, kTolerance);
}

Atmosphere Air(std::vector<Effect> effects) {
  Atmosphere air;
  air.effects = std::move(effects);
  return air;
}

const Color kDisc{.5, .25, 1};
const Vector kEye{0, -10, 0}, kAhead{0, 1, 0};
const Vector kHighEye{0, -10, 2};
const Vector kDown = Normalized({0, 10, -3});
const Color kFogColor{.9, .1, .3};

TEST(Fog, EachChannelHasItsOwnThinness) {
  const Atmosphere air = Air({Fog{kFogColor, {14, 5, 1}}});
  ExpectColor(air.Apply(kEye, kAhead, 10, kDisc), {0.656197, 0.1375, 0.300684});
}

TEST(Fog, LastListedIsAppliedFirst) {
  const Atmosphere air = Air({Fog{{1, 0, 0}, {10, 10, 10}}, Fog{{0, 0, 1}, {5, 5, 5}}});
  ExpectColor(air.Apply(kEye, kAhead, 10, kDisc), {0.5625, 0.03125, 0.5});
}

TEST(Fog, HidesTheBackgroundCompletely) {
  const Atmosphere air = Air({Fog{kFogColor, {14, 5, 1}}});
  EXPECT_EQ(air.Apply(kEye, kAhead, kFar, kDisc), kFogColor);
}

TEST(Fog, WithoutHalfDistanceIsOpaque) {
  const Atmosphere air = Air({Fog{kFogColor, {0, 0, 0}}});
  EXPECT_EQ(air.Apply(kEye, kAhead, 1e-3, kDisc), kFogColor);
}

TEST(Mist, ThinsOutWithHeight) {
  const Atmosphere air = Air({Mist{kFogColor, {14, 5, 30}, .5, 3}});
  const double distance = Length({0, 10, -3});
  ExpectColor(air.Apply(kHighEye, kDown, distance, kDisc), {0.7114, 0.118274, 0.792859});
}

TEST(Mist, OfALevelRayIsThatOfItsHeight) {
  const Atmosphere air = Air({Mist{kFogColor, {14, 5, 30}, .5, 3}});
  ExpectColor(air.Apply(kHighEye, kAhead, 10, kDisc), {0.636944, 0.146394, 0.875651});
}

TEST(Mist, WithoutAScaleIsDefined) {
  const Atmosphere air = Air({Mist{kFogColor, {14, 5, 30}, .5, 0}});
  EXPECT_EQ(air.Apply({0, 0, 0}, kAhead, 10, kDisc), kFogColor);
}

TEST(FogDeck, IsSeenByVerticalRaysOnly) {
  const Atmosphere air = Air({FogDeck{1, .1, {1, 1, 1}, .5, 4, kFogColor, {5, 5, 5}}});
  EXPECT_EQ(air.Apply(kHighEye, kDown, Length({0, 10, -3}), kDisc), kDisc);
  ExpectColor(air.Apply({.3, .2, 5}, {0, 0, -1}, 8, kDisc), {0.551478, 0.230696, 0.909913});
}

TEST(FogDeck, BehindTheHitHasNoEffect) {
  const Atmosphere air = Air({FogDeck{1, .1, {1, 1, 1}, .5, 4, kFogColor, {5, 5, 5}}});
  EXPECT_EQ(air.Apply({.3, .2, 5}, {0, 0, -1}, 3.9, kDisc), kDisc);
  EXPECT_EQ(air.Apply({.3, .2, 5}, {0, 0, 1}, 8, kDisc), kDisc);
}

TEST(Atmosphere, WithoutEffectsChangesNothing) {
  EXPECT_EQ(Atmosphere{}.Apply(kEye, kAhead, kFar, kDisc), kDisc);
}

}  // namespace
}  // namespace rayshade
