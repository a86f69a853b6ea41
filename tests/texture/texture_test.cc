// What single textures do to a hit [rayshade4/3 s.9-10], apart from the original's pixels
// (texture_pixels_test.cc).
#include "rayshade/texture/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rayshade/texture/noise.h"
#include "rayshade/texture/texture_space.h"
#include "tests/texture/one_hit.h"

namespace rayshade {
namespace {

Surface Marked() {
  Surface s;
  s.diffuse = {.1, .2, .3};
  s.transp = .5;
  s.noshadow = true;
  return s;
}

TextureHit HitAt(const Vector& point) {
  TextureHit hit;
  hit.point = point;
  hit.normal = {0, -1, 0};
  hit.ray_origin = {0, -10, 0};
  hit.ray_direction = {0, 1, 0};
  hit.surface.ambient = hit.surface.diffuse = hit.surface.specular = {1, 1, 1};
  return hit;
}

TextureHit Applied(const TextureSpec& spec, TextureHit hit) {
  MakeTexture(spec, {Marked()})->Apply(&hit);
  return hit;
}

bool InChecker(const Vector& point) {
  return Applied({CheckerSpec{0}, {}}, HitAt(point)).surface == Marked();
}

AnimatedTransform Moving(TransformKind kind, std::vector<Expression> arguments) {
  return {kind, std::move(arguments)};
}

TEST(Checker, OddCellsGetTheWholeSurface) {
  EXPECT_FALSE(InChecker({.5, .5, .5}));
  EXPECT_TRUE(InChecker({1.5, .5, .5}));
  EXPECT_FALSE(InChecker({1.5, .5, 7.5}));
  EXPECT_TRUE(InChecker({1.5, 2.5, -3.5}) != InChecker({.5, 2.5, -3.5}));
}

TEST(Checker, NegativeCellsBeginAtOneAndZeroCountsAmongThem) {
  EXPECT_TRUE(InChecker({-.5, .5, .5}));
  EXPECT_FALSE(InChecker({-1.5, .5, .5}));
  EXPECT_TRUE(InChecker({0, .5, .5}));
}

TEST(TextureSpace, ConstantTransformationsActInWrittenOrder) {
  TransformChain chain;
  chain.Append(*Scale({2, 2, 2}));
  chain.Append(Translate({1, 0, 0}));
  EXPECT_EQ(TextureSpace(chain).PointOf(HitAt({5, 4, 2})), (Vector{2, 2, 1}));
}

TEST(TextureSpace, AnimatedTransformationsActInReverseOrder) {
  TransformChain chain;
  chain.Append(*Scale({2, 2, 2}));
  const Expression time({{ExpressionOp::kTime}});
  chain.Append(Moving(TransformKind::kTranslate, {time, Expression(0), Expression(0)}));
  TextureHit hit = HitAt({5, 4, 2});
  hit.moment.time = 1;
  EXPECT_EQ(TextureSpace(chain).PointOf(hit), (Vector{1.5, 2, 1}));
  hit.moment.time = 2;
  EXPECT_EQ(TextureSpace(chain).PointOf(hit), (Vector{.5, 2, 1}));
}

TEST(Bump, DisplacementIsNotRotatedBackToModelSpace) {
  bool degenerate = false;
  TransformChain chain;
  chain.Append(*Rotate({0, 0, 1}, 90, &degenerate));
  const TextureHit hit = HitAt({.3, .4, .5});
  const Vector local = TextureSpace(chain).PointOf(hit);
  EXPECT_EQ(Applied({BumpSpec{.5}, chain}, hit).normal,
            Normalized(hit.normal + .5 * DNoise(local)));
}

TEST(FbmBump, LeavesTheNormalUnnormalised) {
  const TextureHit hit = Applied({FbmBumpSpec{.2, 0, .5, 2, 1}, {}}, HitAt({1, 2, 3}));
  EXPECT_EQ(hit.normal, (Vector{.2, -.8, .2}));
}

TEST(Gloss, OfOneChangesNothing) {
  EXPECT_EQ(Applied({GlossSpec{1}, {}}, HitAt({})).normal, (Vector{0, -1, 0}));
}

TEST(Gloss, StaysInTheCellOfTheSampleNumber) {
  TextureHit hit = HitAt({});
  hit.samples = 2;
  for (uint32_t s = 0; s < 4; ++s) {
    hit.sample_number = s;
    for (uint64_t k = 0; k < 20; ++k) {
      hit.key = k;
      // Across (0, -1, 0) the axes are (1, 0, 0) and (0, 0, 1).
      const Vector n = Applied({GlossSpec{.5}, {}}, hit).normal;
      EXPECT_NEAR(Length(n), 1, 1e-15);
      EXPECT_EQ(n.x > 0, s % 2 == 1);
      EXPECT_EQ(n.z > 0, s / 2 == 1);
      EXPECT_LE(std::abs(n.x / n.y), .5);
    }
  }
}

TEST(Gloss, EachApplicationAndEachKeyDrawsItsOwnNumbers) {
  TextureHit hit = HitAt({});
  const Vector n = Applied({GlossSpec{.5}, {}}, hit).normal;
  EXPECT_EQ(Applied({GlossSpec{.5}, {}}, hit).normal, n);
  hit.application = 1;
  EXPECT_NE(Applied({GlossSpec{.5}, {}}, hit).normal, n);
  hit.application = 0;
  hit.key = 1;
  EXPECT_NE(Applied({GlossSpec{.5}, {}}, hit).normal, n);
}

TEST(Cloud, FromTheInsideIsClear) {
  TextureHit hit = HitAt({0, 1, 0});
  hit.ray_origin = {0, -1, 0};
  hit.surface.specular = {.2, .2, .2};
  hit = Applied({CloudSpec{.3, .7, 2.1, 5, .4, .6, .3}, {}}, hit);
  EXPECT_EQ(hit.surface.transp, 1);
  EXPECT_EQ(hit.surface.ambient, Color{});
  EXPECT_EQ(hit.surface.diffuse, Color{});
  EXPECT_EQ(hit.surface.specular, (Color{.2, .2, .2}));
}

TEST(Cloud, WithoutHIsEvenInsteadOfNotANumber) {
  const TextureHit hit = Applied({CloudSpec{0, 0, 2, 5, .4, .6, 1}, {}}, HitAt({0, -1, 0}));
  EXPECT_TRUE(std::isfinite(hit.surface.transp));
  EXPECT_TRUE(std::isfinite(hit.surface.diffuse.r));
}

TEST(Sky, WhatIsNotCloudIsTransparent) {
  const TextureHit hit = Applied({SkySpec{1, .5, 2, 5, .6, .45}, {}}, HitAt({1.3, 2.2, .7}));
  EXPECT_NEAR(hit.surface.transp + hit.surface.diffuse.r, 1, 1e-15);
  EXPECT_EQ(hit.surface.diffuse, hit.surface.ambient);
  EXPECT_EQ(hit.surface.specular, (Color{1, 1, 1}));
}

TEST(Mount, MultipliesSpecularTooAndClampsToItsMap) {
  ColorMap map(256, Color{1, 1, 1});
  map[0] = {.25, .25, .25};
  map[255] = {.5, .5, .5};
  const auto shared = std::make_shared<const ColorMap>(map);
  const Surface low = Applied({MountSpec{shared, 0, 0}, {}}, HitAt({0, 0, -9})).surface;
  EXPECT_EQ(low.specular, map[0]);
  const Surface high = Applied({MountSpec{shared, 0, 0}, {}}, HitAt({0, 0, 9})).surface;
  EXPECT_EQ(high.specular, map[255]);
  EXPECT_EQ(high.ambient, map[255]);
  EXPECT_EQ(high.diffuse, map[255]);
}

TEST(Blotch, SurfaceOfTheTextureShinesThrough) {
  const Vector p{5, -7, 3};  // noise 0.45
  EXPECT_EQ(Applied({BlotchSpec{.5, 0}, {}}, HitAt(p)).surface, HitAt(p).surface);
  const double mix = -.25, w = (Noise(p) - mix) / (1 - mix);
  const Surface blended = Applied({BlotchSpec{mix, 0}, {}}, HitAt(p)).surface;
  EXPECT_NEAR(blended.diffuse.g, (1 - w) + w * .2, 1e-15);
  EXPECT_NEAR(blended.transp, w * .5, 1e-15);
}

// Every texture, at places and with rays where nothing can be right but everything must be defined.
TEST(Textures, AreDefinedEverywhere) {
  const auto map = std::make_shared<const ColorMap>(256);
  ImageData grey;
  grey.width = grey.height = 2;
  grey.channels = 1;
  grey.color = {0, 50, 100, 150};
  ImageSpec image;
  image.image = std::make_shared<const ImageData>(grey);
  image.smooth = true;
  StripeSpec stripe;
  stripe.surface = 0;
  stripe.width = .1;
  std::vector<TextureSpec> specs = {{CheckerSpec{0}, {}},
                                    {BlotchSpec{0, 0}, {}},
                                    {BumpSpec{1}, {}},
                                    {GlossSpec{.5}, {}},
                                    {WoodSpec{}, {}},
                                    {MarbleSpec{map}, {}},
                                    {FbmSpec{0, 1e300, -3, 2, 1000, 0, map}, {}},
                                    {FbmBumpSpec{0, 1, -3, 2, 2000}, {}},
                                    {CloudSpec{0, 0, 0, 3, 0, 0, 0}, {}},
                                    {SkySpec{-1, -.5, 1, 3, 0, 0}, {}},
                                    {WindySpec{1, 1, 1, 1, 1000, 1e10, .5, 0}, {}},
                                    {MountSpec{map, 1e300, 1}, {}}};
  for (const auto kind : {MappingKind::kUv, MappingKind::kPlanar, MappingKind::kCylindrical,
                          MappingKind::kSpherical}) {
    for (const auto component : {ImageComponent::kAll, ImageComponent::kBump}) {
      image.mapping.kind = stripe.mapping.kind = kind;
      image.component = component;
      specs.push_back({image, {}});
      specs.push_back({stripe, {}});
    }
  }
  const test::OneSphere sphere(1, {});
  HitPath path;
  path.primitive = &sphere;
  path.geometric_normal = {0, -1, 0};
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (double far : {0.0, 1e9, -1e9, 1e14, -1e300, inf, -inf, nan}) {
    for (const TextureSpec& spec : specs) {
      TextureHit hit = HitAt({far, far, far});
      hit.path = &path;
      hit.sample_number = 64;
      hit.samples = 8;
      EXPECT_GT(MakeTexture(spec, {Marked()})->bytes(), sizeof(Texture));
      Applied(spec, hit);
    }
  }
}

TEST(Truncated, IsDefinedForAllNumbers) {
  EXPECT_EQ(Truncated(-1.9), -1);
  EXPECT_EQ(Truncated(2147483647.5), 2147483647);
  EXPECT_EQ(Truncated(-2147483648.5), -2147483647 - 1);
  EXPECT_EQ(Truncated(2147483648.0), -2147483647 - 1);
  EXPECT_EQ(Truncated(std::nan("")), -2147483647 - 1);
}

}  // namespace
}  // namespace rayshade
