// Lights as one point sees them [rayshade4/3 s.6]; rows L3-L7 of s.16.2.
#include "rayshade/light/light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <vector>

#include "rayshade/common/keyed_random.h"
#include "rayshade/common/sample_pattern.h"

namespace rayshade {
namespace {

const Vector kFacing{0, -1, 0};  // normal of a disc at the origin

LightSpec Spec(Color intensity, decltype(LightSpec::source) source) {
  LightSpec spec;
  spec.intensity = intensity;
  spec.source = source;
  return spec;
}

// Lambert's part of what a white disc at the origin sends back, nothing being in the way.
Color Lit(const LightSpec& spec) {
  const auto light = MakeLight(spec);
  const LightDirection direction = light->Toward({}, {});
  const auto arrival = light->Arrive({}, direction, {});
  if (!arrival) return {};
  return Dot(direction.toward, kFacing) * arrival->color;
}

TEST(PointLight, HasNoFalloffWithDistance) {
  const LightSpec spec = Spec({.5, .25, 1}, PointLightSpec{{0, -1000, 0}});
  EXPECT_EQ(Lit(spec), (Color{.5, .25, 1}));
  EXPECT_EQ(MakeLight(spec)->Toward({0, -1, 0}, {}).distance, 999);
}

TEST(PointLight, AtThePointItselfHasNoDirection) {
  const LightDirection direction =
      MakeLight(Spec({1, 1, 1}, PointLightSpec{{1, 2, 3}}))->Toward({1, 2, 3}, {});
  EXPECT_EQ(direction.toward, Vector{});
  EXPECT_EQ(direction.distance, 0);
}

TEST(DirectionalLight, IsFarAwayInTheNormalisedDirection) {
  const auto light = MakeLight(Spec({1, 1, 1}, DirectionalLightSpec{{0, -5, 0}}));
  const LightDirection direction = light->Toward({7, 8, 9}, {});
  EXPECT_EQ(direction.toward, (Vector{0, -1, 0}));
  EXPECT_EQ(direction.distance, kFar);
  const auto arrival = light->Arrive({7, 8, 9}, direction, {});
  ASSERT_TRUE(arrival);
  EXPECT_EQ(arrival->shadow_direction, direction.toward);
  EXPECT_EQ(arrival->shadow_distance, kFar);
}

TEST(SpotLight, WithoutAnglesIsDark) {
  EXPECT_EQ(Lit(Spec({1, 1, 1}, SpotLightSpec{{0, -5, 0}, {0, 0, 0}, 1, 0, 0})), Color{});
}

TEST(SpotLight, FallsOffBetweenItsAngles) {
  const Color lit = Lit(Spec({1, 1, 1}, SpotLightSpec{{1, -5, 0}, {1, 0, 0}, 1, 5, 30}));
  EXPECT_NEAR(lit.r, 0.923353, 1e-6);
}

TEST(SpotLight, WithAWideInnerAngleHasNoRamp) {
  const Color lit = Lit(Spec({1, 1, 1}, SpotLightSpec{{1, -5, 0}, {1, 0, 0}, 3, 90, 90}));
  EXPECT_NEAR(lit.g, 0.924556, 1e-6);
}

TEST(SpotLight, FailsOutsideOfItsConeAndBehindIt) {
  EXPECT_EQ(Lit(Spec({1, 1, 1}, SpotLightSpec{{1, -5, 0}, {1, 0, 0}, 1, 2, 5})), Color{});
  EXPECT_EQ(Lit(Spec({1, 1, 1}, SpotLightSpec{{0, -5, 0}, {0, -9, 0}, 1, 120, 120})), Color{});
}

TEST(SpotLight, InsideItsInnerAngleIsFullyBright) {
  const Color lit = Lit(Spec({.5, .5, 1}, SpotLightSpec{{0, -5, 0}, {0, 0, 0}, 4, 10, 20}));
  EXPECT_EQ(lit, (Color{.5, .5, 1}));
}

TEST(AreaCell, DrawsItsSixNumbersComponentByComponent) {
  const AreaCellSpec cell{{-1, -5, -1}, {2, .5, 0}, {0, .25, 2}};
  const auto light = MakeLight(Spec({1, 1, 1}, cell));
  LightKey key;
  key.key = 12345;
  key.light = 3;
  const auto r = [&](uint32_t i) {
    return KeyedRandom(key.key, RandomUse::kAreaLight, 6 * key.light + i);
  };
  const Vector place{-1 + r(0) * 2, -5 + r(1) * .5 + r(4) * .25, -1 + r(5) * 2};
  const LightDirection direction = light->Toward({.1, .2, .3}, key);
  const Vector to_place = place - Vector{.1, .2, .3};
  EXPECT_NEAR(direction.distance, Length(to_place), 1e-12);
  EXPECT_NEAR(Dot(direction.toward, Normalized(to_place)), 1, 1e-12);

  const auto arrival = light->Arrive({.1, .2, .3}, direction, key);
  ASSERT_TRUE(arrival);
  EXPECT_EQ(arrival->shadow_direction, direction.toward);
  EXPECT_EQ(arrival->shadow_distance, direction.distance);
}

TEST(AreaCell, OtherKeysAndOtherLightsChooseOtherPlaces) {
  const auto light = MakeLight(Spec({1, 1, 1}, AreaCellSpec{{-1, -5, -1}, {2, 0, 0}, {0, 0, 2}}));
  LightKey a, b, c;
  b.key = 1;
  c.light = 1;
  const Vector toward = light->Toward({}, a).toward;
  EXPECT_EQ(toward, light->Toward({}, a).toward);
  EXPECT_NE(toward, light->Toward({}, b).toward);
  EXPECT_NE(toward, light->Toward({}, c).toward);
}

// An area light of `cells` cells, as its light sources see it.
std::vector<std::unique_ptr<const Light>> Cells(uint32_t cells) {
  std::vector<std::unique_ptr<const Light>> lights;
  for (uint32_t order = 0; order < cells; ++order) {
    const AreaCellSpec cell{{double(order), -5, -1}, {1, 0, 0}, {0, 0, 1}, 0, order, cells};
    lights.push_back(MakeLight(Spec({1, 1, 1}, cell)));
  }
  return lights;
}

TEST(AreaCell, ASampleAsksAsManyCellsAsItShouldAndTheyStandForAll) {
  for (const uint32_t cells : {1, 2, 5, 12, 64}) {
    const auto lights = Cells(cells);
    for (const int asked : {1, 2, 3, 7, 16}) {
      LightKey key;
      key.samples = 4;
      key.area_cells = asked;
      for (uint64_t k = 0; k < 64; ++k) {
        key.key = MixBits(k);
        key.sample_number = k % 16;
        uint32_t in_use = 0;
        double sum = 0;
        for (const auto& light : lights) {
          in_use += light->Share(key) > 0;
          sum += light->Share(key);
        }
        EXPECT_EQ(in_use, std::min<uint32_t>(asked, cells));
        EXPECT_NEAR(sum, cells, 1e-9);
      }
    }
  }
}

TEST(AreaCell, TheSamplesOfAPixelAskEveryCellOnceWhereThereAreAsManyQuestionsAsCells) {
  const auto lights = Cells(64);
  LightKey key;
  key.samples = 4;
  key.area_cells = 4;
  std::vector<double> shares(64);
  for (uint32_t s = 0; s < 16; ++s) {
    key.sample_number = s;
    key.key = MixBits(s);
    for (size_t i = 0; i < 64; ++i) shares[i] += lights[i]->Share(key);
  }
  for (const double share : shares) EXPECT_EQ(share, 16);
}

TEST(AreaCell, OnTheAverageEveryCellIsAskedEquallyOften) {
  const auto lights = Cells(12);
  LightKey key;
  key.samples = 3;
  key.area_cells = 5;
  constexpr int kTimes = 20000;
  std::vector<double> shares(12);
  for (int k = 0; k < kTimes; ++k) {
    key.sample_number = k % 9;
    key.key = MixBits(k);
    for (size_t i = 0; i < 12; ++i) shares[i] += lights[i]->Share(key) / kTimes;
  }
  for (const double share : shares) EXPECT_NEAR(share, 1, .05);
}

TEST(Lights, OfOtherKindsStandForThemselves) {
  LightKey key;
  key.area_cells = 1;
  EXPECT_EQ(MakeLight(Spec({1, 1, 1}, PointLightSpec{{0, -5, 0}}))->Share(key), 1);
  EXPECT_EQ(MakeLight(Spec({1, 1, 1}, ExtendedLightSpec{1, {0, -5, 0}}))->Share(key), 1);
}

TEST(ExtendedLight, LightsFromItsCentre) {
  const auto light = MakeLight(Spec({1, 1, 1}, ExtendedLightSpec{1, {0, -5, 0}}));
  const LightDirection direction = light->Toward({}, {});
  EXPECT_EQ(direction.toward, (Vector{0, -1, 0}));
  EXPECT_EQ(direction.distance, 5);
}

TEST(ExtendedLight, SendsTheShadowRayToTheCellOfTheSampleNumber) {
  const double radius = 1.5;
  const auto light = MakeLight(Spec({1, 1, 1}, ExtendedLightSpec{radius, {0, -5, 0}}));
  LightKey key;
  key.samples = 3;
  key.light = 2;
  for (uint32_t s = 0; s < 9; ++s) {
    key.sample_number = s;
    for (uint64_t k = 0; k < 20; ++k) {
      key.key = MixBits(k);
      const auto arrival = light->Arrive({}, light->Toward({}, key), key);
      ASSERT_TRUE(arrival);
      // Across (0, -5, 0) the axes are u = (1, 0, 0) and w = (0, 0, 1).
      const Vector place = arrival->shadow_distance * arrival->shadow_direction;
      EXPECT_NEAR(place.y, -5, 1e-12);
      const double v = (place.z + radius) / (2 * radius / 3);
      const double u = (place.x + radius) / (2 * radius / 3);
      EXPECT_EQ(std::floor(v), s % 3) << s;
      EXPECT_EQ(std::floor(u), s / 3) << s;
    }
  }
}

TEST(ExtendedLight, InALowDiscrepancyPatternIsHitOnceInEachOfItsRowsAndColumns) {
  const auto light = MakeLight(Spec({1, 1, 1}, ExtendedLightSpec{1, {0, -5, 0}}));
  LightKey key;
  key.samples = 4;
  std::set<int> columns, rows;
  for (uint32_t s = 0; s < 16; ++s) {
    key.sample_number = WithShift(s, MixBits(7));
    key.key = MixBits(s);
    const auto arrival = light->Arrive({}, light->Toward({}, key), key);
    const Vector place = arrival->shadow_distance * arrival->shadow_direction;
    columns.insert(static_cast<int>((place.x + 1) * 8));
    rows.insert(static_cast<int>((place.z + 1) * 8));
  }
  EXPECT_EQ(columns.size(), 16u);
  EXPECT_EQ(rows.size(), 16u);
}

TEST(ExtendedLight, BeyondTheLastSampleNumberLiesOutsideOfThePattern) {
  const auto light = MakeLight(Spec({1, 1, 1}, ExtendedLightSpec{1, {0, -5, 0}}));
  LightKey key;
  key.samples = 6;
  key.sample_number = 36;
  const auto arrival = light->Arrive({}, light->Toward({}, key), key);
  ASSERT_TRUE(arrival);
  EXPECT_GE((arrival->shadow_distance * arrival->shadow_direction).x, 1);
}

TEST(Light, KeepsWhetherItCastsShadows) {
  LightSpec spec = Spec({1, 1, 1}, PointLightSpec{});
  EXPECT_FALSE(MakeLight(spec)->noshadow());
  spec.noshadow = true;
  EXPECT_TRUE(MakeLight(spec)->noshadow());
}

}  // namespace
}  // namespace rayshade
