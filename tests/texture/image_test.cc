// Images and mappings [rayshade4/3 s.11], apart from the original's pixels
// (texture_pixels_test.cc).
#include "rayshade/texture/image.h"

#include <gtest/gtest.h>

#include "rayshade/texture/mapping.h"
#include "tests/texture/one_hit.h"

namespace rayshade {
namespace {

// 2 x 1 grey pixels: 51 (0.2) and 204 (0.8).
ImageSpec Grey() {
  ImageData data;
  data.width = 2;
  data.height = 1;
  data.channels = 1;
  data.color = {51, 204};
  ImageSpec spec;
  spec.image = std::make_shared<const ImageData>(data);
  spec.mapping.kind = MappingKind::kPlanar;
  return spec;
}

ImageSpec GreyWithAlpha(uint8_t alpha) {
  ImageSpec spec = Grey();
  ImageData data = *spec.image;
  data.alpha = {alpha, alpha};
  spec.image = std::make_shared<const ImageData>(data);
  return spec;
}

class ImageTextureTest : public testing::Test {
 protected:
  ImageTextureTest() : sphere_(1, {}) {
    path_.primitive = &sphere_;
    path_.geometric_normal = {0, 0, 1};
  }

  TextureHit HitAt(double u, double v) const {
    TextureHit hit;
    hit.point = {u, v, 0};
    hit.normal = {0, 0, 1};
    hit.path = &path_;
    Surface& s = hit.surface;
    s.ambient = s.diffuse = s.specular = s.body = {1, 1, 1};
    s.reflect = s.transp = s.index = 1;
    s.specpow = 10;
    return hit;
  }
  TextureHit Applied(const ImageSpec& spec, double u, double v) const {
    TextureHit hit = HitAt(u, v);
    Surface textsurf;
    textsurf.diffuse = {.5, .5, .5};
    MakeTexture({spec, {}}, {textsurf})->Apply(&hit);
    return hit;
  }
  bool Inside(const ImageSpec& spec, double u, double v) const {
    return Applied(spec, u, v).surface != HitAt(u, v).surface;
  }

  test::OneSphere sphere_;
  HitPath path_;
};

TEST_F(ImageTextureTest, OneChannelServesAllColours) {
  const Surface s = Applied(Grey(), .25, .5).surface;
  EXPECT_EQ(s.diffuse, (Color{.2, .2, .2}));
  EXPECT_EQ(s.specular, s.diffuse);
  EXPECT_EQ(s.ambient, s.diffuse);
  EXPECT_EQ(s.body, (Color{1, 1, 1}));
  EXPECT_EQ(Applied(Grey(), 7.75, -3.5).surface.diffuse, (Color{.8, .8, .8}));
}

TEST_F(ImageTextureTest, SmoothingWrapsAroundAtTheLastColumn) {
  ImageSpec spec = Grey();
  spec.smooth = true;
  EXPECT_NEAR(Applied(spec, 0, 0).surface.diffuse.r, .2, 1e-15);
  EXPECT_NEAR(Applied(spec, .25, 0).surface.diffuse.r, .5, 1e-15);
  EXPECT_NEAR(Applied(spec, .75, 0).surface.diffuse.r, .5, 1e-15);
  EXPECT_NEAR(Applied(spec, .875, 0).surface.diffuse.r, .35, 1e-15);
}

TEST_F(ImageTextureTest, ComponentsAreScaledByTheRange) {
  ImageSpec spec = Grey();
  spec.range_low = .5;
  spec.range_high = 2;
  const double v = .5 + .2 * 1.5;
  const auto with = [&](ImageComponent component) {
    spec.component = component;
    return Applied(spec, .25, .5).surface;
  };
  Surface expected = HitAt(0, 0).surface;
  expected.ambient = {v, v, v};
  EXPECT_EQ(with(ImageComponent::kAmbient), expected);
  expected = HitAt(0, 0).surface;
  expected.diffuse = {v, v, v};
  EXPECT_EQ(with(ImageComponent::kDiffuse), expected);
  expected = HitAt(0, 0).surface;
  expected.specular = {v, v, v};
  EXPECT_EQ(with(ImageComponent::kSpecular), expected);
  expected = HitAt(0, 0).surface;
  expected.body = {v, v, v};
  EXPECT_EQ(with(ImageComponent::kBody), expected);
  expected = HitAt(0, 0).surface;
  expected.reflect = v;
  EXPECT_EQ(with(ImageComponent::kReflect), expected);
  expected = HitAt(0, 0).surface;
  expected.transp = v;
  EXPECT_EQ(with(ImageComponent::kTransp), expected);
  expected = HitAt(0, 0).surface;
  expected.specpow = 10 * v;
  EXPECT_EQ(with(ImageComponent::kSpecpow), expected);
  expected = HitAt(0, 0).surface;
  expected.index = v;
  EXPECT_EQ(with(ImageComponent::kIndex), expected);
}

TEST_F(ImageTextureTest, TextsurfReplacesTheSurfaceForAllColoursOnly) {
  ImageSpec spec = Grey();
  spec.surface = 0;
  EXPECT_NEAR(Applied(spec, .25, .5).surface.diffuse.r, .1, 1e-15);
  EXPECT_EQ(Applied(spec, .25, .5).surface.transp, 0);
  spec.component = ImageComponent::kDiffuse;
  EXPECT_NEAR(Applied(spec, .25, .5).surface.diffuse.r, .2, 1e-15);
}

TEST_F(ImageTextureTest, AlphaBlendsAndZeroLeavesTheSurfaceAlone) {
  EXPECT_EQ(Applied(GreyWithAlpha(0), .25, .5).surface, HitAt(0, 0).surface);
  EXPECT_EQ(Applied(GreyWithAlpha(255), .25, .5).surface, Applied(Grey(), .25, .5).surface);
  EXPECT_NEAR(Applied(GreyWithAlpha(51), .25, .5).surface.diffuse.g, .8 + .2 * .2, 1e-15);
}

TEST_F(ImageTextureTest, BumpLeansByTheDifferenceToTheNextPixel) {
  ImageSpec spec = Grey();
  spec.component = ImageComponent::kBump;
  // n + fu (n x dv) - fv (n x du), du and dv being x and y.
  EXPECT_EQ(Applied(spec, .25, .5).normal, Normalized({-(.8 - .2), 0, 1}));
  EXPECT_EQ(Applied(spec, .75, .5).normal, Normalized({.8 - .2, 0, 1}));
  EXPECT_EQ(Applied(spec, .25, .5).surface, HitAt(0, 0).surface);
}

TEST_F(ImageTextureTest, TilesFollowTheSignsOfBothSizes) {
  ImageSpec spec = Grey();
  const auto tile = [&](double u, double v) {
    spec.tile_u = u;
    spec.tile_v = v;
  };
  EXPECT_TRUE(Inside(spec, 99.5, -7.5));
  tile(2, 3);
  EXPECT_TRUE(Inside(spec, 1.5, 2.5));
  EXPECT_FALSE(Inside(spec, 2.5, 2.5));
  EXPECT_FALSE(Inside(spec, 1.5, -.5));
  tile(2, 0);
  EXPECT_TRUE(Inside(spec, 1.5, 99.5));
  EXPECT_FALSE(Inside(spec, -.5, 0.5));
  tile(0, 3);
  EXPECT_TRUE(Inside(spec, -8.5, 2.5));
  EXPECT_FALSE(Inside(spec, 1.5, 3.5));
  tile(-2, -3);
  EXPECT_FALSE(Inside(spec, 1.5, 2.5));
  EXPECT_TRUE(Inside(spec, 1.5, 3.5));
  EXPECT_TRUE(Inside(spec, -.5, 2.5));
  tile(-2, 0);
  EXPECT_FALSE(Inside(spec, 1.5, 99.5));
  EXPECT_TRUE(Inside(spec, 2.5, .5));
  tile(0, -3);
  EXPECT_FALSE(Inside(spec, 1.5, 1.5));
  EXPECT_TRUE(Inside(spec, 1.5, -1.5));
  tile(2, -3);
  EXPECT_FALSE(Inside(spec, 1.5, 1.5));
  EXPECT_TRUE(Inside(spec, 1.5, 3.5));
  EXPECT_FALSE(Inside(spec, 2.5, 3.5));
}

TEST_F(ImageTextureTest, PlanarFramesIgnoreTheirOrigin) {
  MappingSpec spec;
  spec.kind = MappingKind::kPlanar;
  spec.framed = true;
  spec.up = {0, 2, 0};
  spec.u_axis = {4, 0, 0};
  const TextureHit hit = HitAt(6, 5);
  for (const Vector& origin : {Vector{}, Vector{7, 8, 9}}) {
    spec.origin = origin;
    const MappedPoint at = Mapping(spec).Map(hit, TextureSpace({}), true);
    EXPECT_EQ(at.u, 1.5);
    EXPECT_EQ(at.v, 2.5);
    EXPECT_EQ(at.du, (Vector{1, 0, 0}));
  }
}

TEST_F(ImageTextureTest, SphericalMappingHasItsPolesOnTheAxis) {
  MappingSpec spec;
  spec.kind = MappingKind::kSpherical;
  TextureHit hit = HitAt(0, 0);
  hit.point = {0, 0, -2};
  EXPECT_EQ(Mapping(spec).Map(hit, TextureSpace({}), false).v, 0);
  hit.point = {0, 0, 5};
  EXPECT_EQ(Mapping(spec).Map(hit, TextureSpace({}), false).v, 1);
  hit.point = {0, 3, 0};
  const MappedPoint side = Mapping(spec).Map(hit, TextureSpace({}), true);
  EXPECT_NEAR(side.u, .25, 1e-15);
  EXPECT_NEAR(side.v, .5, 1e-15);
  EXPECT_NEAR(Dot(side.du, {-1, 0, 0}), 1, 1e-12);
  EXPECT_NEAR(Dot(side.dv, {0, 0, 1}), 1, 1e-12);
}

TEST_F(ImageTextureTest, TexturesTransformationsActOnUv) {
  TransformChain chain;
  chain.Append(*Scale({.5, .25, 1}));
  chain.Append(Translate({.2, .1, 0}));
  MappingSpec spec;
  spec.kind = MappingKind::kPlanar;
  const MappedPoint at = Mapping(spec).Map(HitAt(1.2, 1.1), TextureSpace(chain), false);
  EXPECT_NEAR(at.u, 2, 1e-12);
  EXPECT_NEAR(at.v, 4, 1e-12);
}

}  // namespace
}  // namespace rayshade
