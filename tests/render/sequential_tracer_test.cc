#include "rayshade/render/sequential_tracer.h"

#include <gtest/gtest.h>

#include "rayshade/common/keyed_random.h"
#include "tests/shade/text_scene.h"

namespace rayshade {
namespace {

using test::TextScene;

// Mirrors, glass in glass, coloured shadows, textures, fog, several lights.
const char kScene[] =
    "background .2 .3 .4\natmosphere fog .5 .5 .5 50 60 70\nmaxdepth 6\ncutoff .0001\n"
    "light .5 point 9 -9 9\nlight .4 .5 .3 directional -1 -1 2\nlight .6 extended 1 -5 -8 6\n"
    "surface glass specular .8 .8 .8 reflect .3 transp .7 body .9 1 .8 index 1.4 extinct .9\n"
    "surface mirror diffuse .2 .2 .3 specular .7 .7 .7 specpow 20 reflect .8\n"
    "plane diffuse .6 .5 .4 0 0 -2 0 0 1 texture checker diffuse .1 .1 .1 reflect .5\n"
    "sphere glass 2 0 0 0\nsphere glass .8 .3 0 0\nsphere mirror 1.5 3 3 0\n"
    "sphere mirror 1.2 -3 2 .5 texture bump .3\n"
    "difference box glass -4 -4 -2 -2 -2 1 sphere glass 1 -3 -3 1 end\n";

RayBundle RandomRays(size_t count) {
  RayBundle bundle;
  for (size_t i = 0; i < count; ++i) {
    const auto random = [&](uint32_t index) { return KeyedRandom(i, RandomUse::kTime, index); };
    Ray ray = TextScene::RayTo({10 * random(0) - 5, -12, 6 * random(1)},
                               {random(2) - .5, 1.5, random(3) - .8});
    ray.key = MixBits(i);
    ray.sample_number = i % 9;
    bundle.rays.push_back(ray);
  }
  return bundle;
}

TEST(SequentialTracer, ABundleGivesWhatItsRaysGiveOneByOne) {
  TextScene scene(kScene);
  const RayBundle bundle = RandomRays(2500);
  std::vector<RayResult> together(bundle.size());
  OpCounts counts;
  SequentialTracer tracer(&scene.scene(), &scene.objects());
  tracer.Trace(bundle, together, &counts);
  size_t differ = 0;
  for (size_t i = 0; i < bundle.size(); ++i) {
    const RayResult alone = scene.Trace(bundle.rays[i]);
    differ += alone.color != together[i].color || alone.distance != together[i].distance;
  }
  EXPECT_EQ(differ, 0u);
  EXPECT_EQ(counts.primary_rays, 2500u);
  EXPECT_EQ(counts.reflected_rays, scene.counts().reflected_rays);
  EXPECT_EQ(counts.refracted_rays, scene.counts().refracted_rays);
  EXPECT_EQ(counts.shadow_rays, scene.counts().shadow_rays);
  EXPECT_GT(counts.refracted_rays, 500u);
  EXPECT_GT(counts.reflected_rays, 500u);
}

TEST(SequentialTracer, RoomIsReusedWithoutTraces) {
  TextScene scene(kScene);
  const RayBundle bundle = RandomRays(300);
  RayBundle first;
  first.rays.assign(bundle.rays.begin(), bundle.rays.begin() + 10);
  std::vector<RayResult> fresh(300), again(300), few(10);
  OpCounts counts;
  SequentialTracer tracer(&scene.scene(), &scene.objects());
  tracer.Trace(bundle, fresh, &counts);
  tracer.Trace(first, few, &counts);
  tracer.Trace(bundle, again, &counts);
  for (size_t i = 0; i < 300; ++i) EXPECT_EQ(fresh[i].color, again[i].color) << i;
  for (size_t i = 0; i < 10; ++i) EXPECT_EQ(fresh[i].color, few[i].color) << i;
}

TEST(SequentialTracer, FacingMirrorsCountEveryRay) {
  TextScene scene(
      "maxdepth 7\ncutoff 0\nplane specular 1 1 1 reflect .5 0 5 0 0 1 0\n"
      "plane specular 1 1 1 reflect .5 0 -15 0 0 1 0\n");
  scene.Trace({0, 0, 0}, {0, 1, 0});
  EXPECT_EQ(scene.counts().primary_rays, 1u);
  EXPECT_EQ(scene.counts().reflected_rays, 7u);
  EXPECT_EQ(scene.counts().shades, 8u);
}

Ray ShadowRayTo(const Vector& origin, const Vector& direction) {
  Ray ray = TextScene::RayTo(origin, direction);
  ray.min_distance = kShadowEpsilon;
  return ray;
}

TEST(ShadowTracer, TellsWhatArrives) {
  TextScene scene(
      "surface glass transp .5 body 1 .5 .25\n"
      "disc glass 1 0 -5 0 0 1 0\ndisc 1 10 -5 0 0 1 0\n");
  const std::vector<double> places = {0, 10, 20, 10, 0}, limits = {kFar, kFar, kFar, 4, 4};
  std::vector<Ray> rays;
  for (const double x : places) rays.push_back(ShadowRayTo({x, 0, 0}, {0, -1, 0}));
  std::vector<Color> colors(rays.size(), {1, 1, 1});
  std::vector<uint8_t> blocked(rays.size());
  OpCounts counts;
  ShadowTracer(&scene.scene(), &scene.objects()).Trace(rays, limits, colors, blocked, &counts);
  EXPECT_EQ(blocked, (std::vector<uint8_t>{0, 1, 0, 0, 0}));
  EXPECT_EQ(colors[0], (Color{.5, .25, .125}));
  EXPECT_EQ(colors[2], (Color{1, 1, 1}));
  EXPECT_EQ(colors[4], (Color{1, 1, 1}));
}

// A union has no walls inside; it was seen from a step of one bit behind the last crossing, where a
// ray may still be outside of the sphere that it has entered.
TEST(ShadowTracer, AGlassUnionIsCrossedTwice) {
  TextScene scene(
      "surface glass transp .5\n"
      "union sphere glass .9 -2.3 0 0 sphere glass .9 -1.2 0 0 end\n");
  ShadowTracer tracer(&scene.scene(), &scene.objects());
  for (int i = 0; i < 100; ++i) {
    const Ray ray = ShadowRayTo({-9, .0031 * i, .0017 * i}, {1, .0002 * i, -.0002 * i});
    const double limit = kFar;
    Color color{1, 1, 1};
    uint8_t blocked = 0;
    OpCounts counts;
    tracer.Trace({&ray, 1}, {&limit, 1}, {&color, 1}, {&blocked, 1}, &counts);
    ASSERT_FALSE(blocked);
    EXPECT_EQ(color.r, .25) << i;
  }
}

}  // namespace
}  // namespace rayshade
