// The rows of [rayshade4/3 s.16.6]: pixels of the original, one texture application each, byte
// for byte.
#include <gtest/gtest.h>

#include "tests/texture/one_hit.h"

namespace rayshade {
namespace {

using test::Bytes;
using test::OneHitScene;
using test::OnePlane;
using test::OneSphere;

constexpr SurfaceId kS1 = 0, kTextSurf = 1;

Surface S0() {
  Surface s;
  s.ambient = {.1, .2, .3};
  s.diffuse = {.5, .4, .3};
  s.specular = {.2, .2, .2};
  s.specpow = 4;
  return s;
}

std::vector<Surface> Surfaces() {
  std::vector<Surface> surfaces(2);
  surfaces[kS1].ambient = {0, .3, 0};
  surfaces[kS1].diffuse = {.1, .1, .6};
  surfaces[kTextSurf].ambient = {.3, .3, .3};
  surfaces[kTextSurf].diffuse = {.9, .8, .7};
  return surfaces;
}

std::shared_ptr<const ColorMap> TestMap() {
  ColorMap map;
  for (int i = 0; i < 256; ++i) {
    map.push_back({7 * i % 256 * (1.0 / 255), 3 * i % 256 * (1.0 / 255), (255 - i) * (1.0 / 255)});
  }
  return std::make_shared<const ColorMap>(map);
}

std::shared_ptr<const ImageData> TestImage() {
  ImageData image;
  image.width = 4;
  image.height = 3;
  for (int i = 0; i < 36; ++i) image.color.push_back(static_cast<uint8_t>((37 * i + 11) % 256));
  return std::make_shared<const ImageData>(image);
}

Transform Turn(const Vector& axis, double degrees) {
  bool degenerate = false;
  return *Rotate(axis, degrees, &degenerate);
}

TransformChain Chain(const std::vector<Transform>& links) {
  TransformChain chain;
  for (const Transform& link : links) chain.Append(link);
  return chain;
}

MappingSpec Unframed(MappingKind kind) {
  MappingSpec mapping;
  mapping.kind = kind;
  return mapping;
}

// Textures in the order of application, and the pixels (5, 3), (3, 5), (6, 6), (4, 4).
struct Row {
  const char* name;
  std::vector<TextureSpec> textures;
  Bytes pixels[4];
};

void ExpectRows(OneHitScene scene, const std::vector<Row>& rows) {
  constexpr int kPlaces[4][2] = {{5, 3}, {3, 5}, {6, 6}, {4, 4}};
  scene.surface = S0();
  for (const Row& row : rows) {
    std::vector<std::unique_ptr<const Texture>> textures;
    scene.textures.clear();
    for (const TextureSpec& spec : row.textures) {
      textures.push_back(MakeTexture(spec, Surfaces()));
      scene.textures.push_back(textures.back().get());
    }
    for (int place = 0; place < 4; ++place) {
      const auto& [column, line] = kPlaces[place];
      const Bytes pixel = scene.Pixel(column, line);
      EXPECT_EQ(pixel, row.pixels[place])
          << row.name << " pixel (" << column << ", " << line << ")";
    }
  }
}

// clang-format off
TEST(TexturePixels, SolidTexturesOnAPlaneAreThoseOfTheOriginal) {
  const OnePlane plane({0, .37, 0}, {0, -1, 0});
  OneHitScene scene;
  scene.geom = &plane;
  ExpectRows(scene, {
      {"X1", {TextureSpec{CheckerSpec{kS1}, {}}}, {{25, 102, 153}, {200, 200, 200}, {202, 202, 202}, {202, 202, 202}}},
      {"X2", {TextureSpec{CheckerSpec{kS1}, Chain({*Scale({.5, .6, .7}), Turn({0, 0, 1}, 30), Translate({.1, .2, .3})})}}, {{200, 200, 200}, {200, 200, 200}, {202, 202, 202}, {202, 202, 202}}},
      {"X3", {TextureSpec{BlotchSpec{0, kS1}, {}}}, {{183, 190, 195}, {200, 200, 200}, {202, 202, 202}, {154, 174, 188}}},
      {"X4", {TextureSpec{BlotchSpec{-.5, kS1}, {}}}, {{129, 159, 179}, {178, 187, 193}, {161, 179, 190}, {110, 149, 175}}},
      {"X5", {TextureSpec{BumpSpec{.7}, {}}}, {{194, 195, 196}, {175, 175, 176}, {200, 200, 200}, {175, 176, 178}}},
      {"X6", {TextureSpec{MarbleSpec{}, {}}}, {{168, 168, 168}, {93, 93, 93}, {51, 51, 51}, {90, 90, 90}}},
      {"X7", {TextureSpec{MarbleSpec{TestMap()}, {}}}, {{123, 102, 80}, {59, 184, 155}, {66, 56, 199}, {185, 173, 160}}},
      {"X8", {TextureSpec{FbmSpec{.5, 1.5, .6, 2.1, 5, -.1, nullptr}, {}}}, {{124, 124, 124}, {124, 124, 124}, {125, 125, 125}, {243, 243, 243}}},
      {"X9", {TextureSpec{FbmSpec{.5, 1.5, .6, 2.1, 5, -.1, TestMap()}, {}}}, {{120, 122, 124}, {120, 122, 124}, {121, 124, 126}, {198, 201, 49}}},
      {"X10", {TextureSpec{FbmBumpSpec{.1, .8, .5, 2, 4}, {}}}, {{161, 163, 165}, {255, 253, 252}, {255, 255, 255}, {126, 132, 137}}},
      {"X11", {TextureSpec{WoodSpec{}, {}}}, {{151, 112, 122}, {78, 67, 70}, {94, 83, 85}, {108, 95, 98}}},
      {"X12", {TextureSpec{SkySpec{.7, .5, 2, 5, .6, .45}, {}}}, {{236, 164, 129}, {242, 159, 117}, {253, 151, 100}, {204, 200, 198}}},
      {"X13", {TextureSpec{WindySpec{.5, .7, 2, .6, 3, 2.2, .6, .4}, {}}}, {{172, 173, 175}, {190, 191, 191}, {202, 202, 202}, {203, 203, 203}}},
      {"X14", {TextureSpec{WindySpec{.5, .7, 0, .6, 3, 2.2, .6, .4}, {}}}, {{157, 159, 161}, {158, 160, 162}, {200, 200, 200}, {169, 170, 172}}},
      {"X15", {TextureSpec{MountSpec{TestMap(), .4, -.3}, {}}}, {{195, 199, 0}, {37, 188, 137}, {0, 0, 202}, {197, 200, 0}}},
      {"X16", {TextureSpec{MarbleSpec{}, {}}, TextureSpec{BumpSpec{.3}, Chain({*Scale({.5, .5, .5})})}, TextureSpec{CheckerSpec{kS1}, {}}}, {{25, 101, 150}, {92, 92, 92}, {52, 52, 52}, {91, 91, 91}}},
  });
}

TEST(TexturePixels, ImagesAndStripesOnASphereAreThoseOfTheOriginal) {
  const OneSphere sphere(3, {.2, .3, .1});
  OneHitScene scene;
  scene.geom = &sphere;
  ExpectRows(scene, {
      {"X18", {TextureSpec{ImageSpec{.image = TestImage(), .mapping = {}}, {}}}, {{90, 113, 136}, {88, 110, 134}, {12, 36, 60}, {101, 125, 149}}},
      {"X19", {TextureSpec{ImageSpec{.image = TestImage(), .smooth = true, .mapping = {}}, {}}}, {{108, 131, 18}, {63, 85, 61}, {53, 77, 47}, {90, 114, 44}}},
      {"X20", {TextureSpec{ImageSpec{.image = TestImage(), .tile_u = 2, .tile_v = -1, .mapping = Unframed(MappingKind::kPlanar)}, {}}}, {{109, 132, 9}, {136, 139, 143}, {12, 36, 60}, {156, 157, 159}}},
      {"X21", {TextureSpec{ImageSpec{.image = TestImage(), .mapping = {MappingKind::kPlanar, true, {5, 6, 7}, {0, .5, 2}, {1.5, .2, 0}}}, {}}}, {{11, 32, 53}, {111, 134, 14}, {34, 57, 81}, {74, 98, 122}}},
      {"X22", {TextureSpec{ImageSpec{.image = TestImage(), .mapping = Unframed(MappingKind::kCylindrical)}, {}}}, {{11, 32, 53}, {124, 7, 28}, {12, 36, 60}, {59, 82, 106}}},
      {"X23", {TextureSpec{ImageSpec{.image = TestImage(), .mapping = {MappingKind::kCylindrical, true, {.1, .2, .3}, {0, 1, 2}, {1, .3, 0}}}, {}}}, {{53, 75, 97}, {51, 73, 96}, {131, 155, 16}, {142, 8, 31}}},
      {"X24", {TextureSpec{ImageSpec{.image = TestImage(), .mapping = {MappingKind::kSpherical, true, {.1, .2, .3}, {0, 1, 2}, {1, .3, 0}}}, {}}}, {{90, 113, 136}, {88, 110, 134}, {55, 79, 103}, {101, 125, 149}}},
      {"X25", {TextureSpec{ImageSpec{.image = TestImage(), .component = ImageComponent::kDiffuse, .range_low = .2, .range_high = .9, .mapping = Unframed(MappingKind::kPlanar)}, {}}}, {{111, 129, 94}, {77, 101, 121}, {70, 99, 123}, {78, 105, 127}}},
      {"X26", {TextureSpec{ImageSpec{.image = TestImage(), .surface = kTextSurf, .mapping = Unframed(MappingKind::kPlanar)}, {}}}, {{218, 238, 15}, {104, 132, 154}, {23, 60, 90}, {61, 95, 122}}},
      {"X27", {TextureSpec{ImageSpec{.image = TestImage(), .mapping = {}}, Chain({*Scale({.5, .25, 1}), Translate({.2, .1, 0})})}}, {{6, 26, 48}, {10, 31, 52}, {6, 30, 54}, {80, 104, 128}}},
      {"X28", {TextureSpec{StripeSpec{kS1, .15, .4, Unframed(MappingKind::kPlanar)}, {}}}, {{22, 99, 135}, {136, 139, 143}, {160, 162, 163}, {156, 157, 159}}},
      {"X29", {TextureSpec{StripeSpec{kS1, .15, .4, {}}, {}}}, {{140, 143, 146}, {136, 139, 143}, {160, 162, 163}, {156, 157, 159}}},
      {"X30", {TextureSpec{StripeSpec{kS1, .15, .4, Unframed(MappingKind::kCylindrical)}, Chain({*Scale({.5, .25, 1}), Turn({0, 0, 1}, 25)})}}, {{22, 99, 135}, {22, 98, 132}, {150, 152, 154}, {130, 135, 139}}},
  });
}

TEST(TexturePixels, TexturesOnATransformedSphereAreThoseOfTheOriginal) {
  const OneSphere sphere(3, {.2, .3, .1});
  OneHitScene scene;
  scene.geom = &sphere;
  scene.object = Compose(Compose(*Scale({1.1, .9, 1.2}), Turn({1, 0, 0}, 30)),
                         Translate({.3, .1, .2}));
  ExpectRows(scene, {
      {"X31", {TextureSpec{ImageSpec{.image = TestImage(), .mapping = {}}, Chain({*Scale({.5, .25, 1}), Translate({.2, .1, 0})})}}, {{8, 36, 64}, {106, 129, 14}, {73, 95, 118}, {84, 108, 133}}},
      {"X32", {TextureSpec{CheckerSpec{kS1}, {}}}, {{191, 191, 192}, {130, 134, 139}, {142, 145, 148}, {163, 165, 166}}},
      {"X33", {TextureSpec{StripeSpec{kS1, .15, .4, {}}, Chain({*Scale({.5, .25, 1}), Turn({0, 0, 1}, 25)})}}, {{25, 101, 151}, {130, 134, 139}, {22, 99, 136}, {124, 130, 135}}},
  });
}

TEST(TexturePixels, CloudsAreThoseOfTheOriginal) {
  const OneSphere sphere(1, {0, 0, 0});
  OneHitScene scene;
  scene.geom = &sphere;
  scene.fov = 15;
  ExpectRows(scene, {
      {"X34", {TextureSpec{CloudSpec{.3, .7, 2.1, 5, .4, .6, .3}, {}}}, {{204, 102, 51}, {139, 143, 147}, {145, 148, 151}, {188, 125, 94}}},
  });
  scene.object = Compose(*Scale({1.3, .8, 1.1}), Turn({0, 0, 1}, 20));
  ExpectRows(scene, {
      {"X35", {TextureSpec{CloudSpec{.3, .7, 2.1, 5, .4, .6, .3}, {}}}, {{205, 103, 52}, {194, 195, 197}, {144, 147, 151}, {193, 147, 125}}},
  });
}
// clang-format on

}  // namespace
}  // namespace rayshade
