// The steps of shading on scenes whose answer is known in closed form.
#include "rayshade/shade/shade.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "rayshade/shade/slack.h"
#include "tests/shade/text_scene.h"

namespace rayshade {
namespace {

using test::TextScene;

double Radians(double degrees) { return degrees * kPi / 180; }

TEST(ResolveHit, NormalsOfASquashedSphereAreThoseOfTheEllipsoid) {
  TextScene scene("sphere 1 0 0 0 scale 3 2 1 rotate 0 0 1 90\n");
  // The x axis of length 3 lies along y after the rotation; at (x, y) = (-1, ...) on the ellipse.
  const SurfaceHit hit = scene.HitBy({-1, -10, 0}, {0, 1, 0});
  const double y = -3 * std::sqrt(1 - 1.0 / 4);
  EXPECT_NEAR(hit.point.y, y, 1e-12);
  const Vector normal = Normalized({-1.0 / 4, y / 9, 0});
  EXPECT_NEAR(hit.normal.x, normal.x, 1e-12);
  EXPECT_NEAR(hit.normal.y, normal.y, 1e-12);
  EXPECT_TRUE(hit.entering);
}

TEST(ResolveHit, PlainSpheresAreResolvedAsTheirDescriptionSays) {
  // A tree of leaves, so that rows of spheres are read from their middles, too.
  std::string text = "surface s diffuse .5 .4 .3\n";
  for (int i = 0; i < 60; ++i) {
    text += "sphere s ." + std::to_string(20 + i) + " " + std::to_string(i % 8) + " " +
            std::to_string(i / 8) + " ." + std::to_string(100 + i) + "\n";
  }
  TextScene scene(text);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector from = i % 4 == 0 ? Vector{i % 8 + .01, i % 7 + .02, .1} : Vector{3.1, 2.9, 20};
    const Ray ray = TextScene::RayTo(from, {i % 13 - 6.3, i % 11 - 5.2, i % 4 == 0 ? 3 : -19.});
    Hit hit;
    OpCounts counts;
    scene.objects().Nearest({&ray, 1}, {&hit, 1}, &counts);
    if (!hit.found()) continue;
    ++found;
    SurfaceHit resolved;
    ResolveHit(scene.scene(), ray, hit, &resolved);
    HitPath path;
    hit.set->Describe(ray, hit, &path);
    const bool enters = Dot(ray.direction, path.normal) <= 0;
    EXPECT_EQ(resolved.entering, enters);
    EXPECT_EQ(resolved.point, path.point);
    EXPECT_EQ(resolved.normal, enters ? path.normal : -path.normal);
    EXPECT_EQ(resolved.face, resolved.normal);
    EXPECT_EQ(resolved.slack, SlackOf(ray, path.reach, hit.distance));
    EXPECT_EQ(resolved.surface().diffuse, (Color{.5, .4, .3}));
  }
  EXPECT_GT(found, 50);
}

TEST(ResolveHit, NormalsFaceTheViewerFromInsideToo) {
  TextScene scene("sphere 1 0 0 0\n");
  const SurfaceHit hit = scene.HitBy({0, 0, 0}, {0, 1, 0});
  EXPECT_EQ(hit.normal, (Vector{0, -1, 0}));
  EXPECT_FALSE(hit.entering);
  EXPECT_EQ(hit.facing, 1);
}

TEST(ResolveHit, TexturesOfEnclosingObjectsComeLastAndInTheirOwnSpace) {
  // A checker at x in (0, 1) is even, in (1, 2) odd; the list carries its members' checks along.
  const std::string head = "surface r ambient 1 0 0\nsurface g ambient 0 1 0\n";
  const std::string disc = "disc r 9 0 .5 0 0 1 0 translate 1 0 0 texture checker g\n";
  const Vector eye{.5, -10, .5}, ahead{0, 1, 0};
  const Color still = TextScene(head + disc).HitBy(eye, ahead).surface().ambient;
  const Color carried = TextScene(head + "list " + disc + " end translate 1 0 0\n")
                            .HitBy(eye, ahead)
                            .surface()
                            .ambient;
  EXPECT_NE(still, carried);
  const SurfaceHit both = TextScene(head + "surface w ambient 1 1 1\nlist " + disc +
                                    "end texture stripe w .9 0 map planar\n")
                              .HitBy(eye, ahead);
  EXPECT_EQ(both.surface().ambient, (Color{1, 1, 1}));
  EXPECT_TRUE(both.textured);
}

TEST(Shading, ALitSphereFollowsTheCosine) {
  TextScene scene(
      "light .5 directional 0 -1 0\nsphere ambient .1 .2 .3 diffuse .4 .5 .6 1 0 0 0\n");
  for (double x = -.95; x < 1; x += .1) {
    const double cosine = std::sqrt(1 - x * x);
    const Color color = scene.Trace({x, -10, 0}, {0, 1, 0}).color;
    EXPECT_NEAR(color.r, .1 + .4 * cosine * .5, 1e-12) << x;
    EXPECT_NEAR(color.g, .2 + .5 * cosine * .5, 1e-12) << x;
    EXPECT_NEAR(color.b, .3 + .6 * cosine * .5, 1e-12) << x;
  }
}

TEST(Shading, AHighlightIsAPowerOfTheMirrorCosine) {
  TextScene scene(
      "light 1 point 3 -10 0\nplane specular 1 .5 .25 specpow 7 diffuse 0 0 0 0 0 0 0 -1 0\n");
  for (double x = -2; x <= 2; x += .5) {
    // Seen straight on at (x, 0, 0): the mirror direction is -y.
    const Vector toward = Normalized(Vector{3, -10, 0} - Vector{x, 0, 0});
    const double power = std::pow(-toward.y, 7);
    const Color color = scene.Trace({x, -5, 0}, {0, 1, 0}).color;
    EXPECT_NEAR(color.r, power, 1e-12) << x;
    EXPECT_NEAR(color.b, .25 * power, 1e-12) << x;
  }
}

TEST(Shading, ASlabOfGlassAbsorbsByTheLengthOfTheRefractedPath) {
  TextScene scene(
      "background 1 1 1\nlight 0 directional 0 -1 0\n"
      "box transp .9 body .8 1 .5 index 1.5 extinct .7 -99 0 -99 99 2 99\n");
  for (double degrees : {0.0, 20.0, 40.0, 60.0, 80.0}) {
    const double inside = std::asin(std::sin(Radians(degrees)) / 1.5);
    const double length = 2 / std::cos(inside);
    const double left = std::pow(.7, length);
    const Vector direction{std::sin(Radians(degrees)), std::cos(Radians(degrees)), 0};
    const Color color = scene.Trace(Vector{0, 0, 0} - 3.0 * direction, direction).color;
    EXPECT_NEAR(color.r, .72 * .72 * left, 1e-9) << degrees;
    EXPECT_NEAR(color.g, .81 * left, 1e-9) << degrees;
    EXPECT_NEAR(color.b, .2025 * left, 1e-9) << degrees;
  }
}

TEST(SpawnSecondary, BeyondTheCriticalAngleEverythingIsReflected) {
  TextScene scene("box transp 1 index 1.5 -9 -9 -9 9 9 9\n");
  const double critical = std::asin(1 / 1.5) * 180 / kPi;
  for (double degrees : {critical - .1, critical + .1}) {
    const Ray ray =
        TextScene::RayTo({0, 8, 0}, {std::sin(Radians(degrees)), std::cos(Radians(degrees)), 0});
    Hit hit;
    OpCounts counts;
    scene.objects().Nearest({&ray, 1}, {&hit, 1}, &counts);
    SurfaceHit resolved;
    ResolveHit(scene.scene(), ray, hit, &resolved);
    const Medium glass{1.5, 1};
    RayBundle transmitted, reflected;
    const Secondary secondary =
        SpawnSecondary(scene.scene(), ray, {&glass, 1}, resolved, &transmitted, &reflected);
    const bool total = degrees > critical;
    EXPECT_EQ(secondary.transmitted.wanted, !total);
    EXPECT_EQ(secondary.reflected.wanted, total);
    EXPECT_EQ(transmitted.size(), total ? 0u : 1u);
    ASSERT_EQ(reflected.size(), total ? 1u : 0u);
    if (total) {
      EXPECT_EQ(reflected.rays[0].media_count, 1) << "a mirror ray stays in its medium";
      EXPECT_EQ(reflected.media[0], glass);
    } else {
      EXPECT_EQ(transmitted.rays[0].media_count, 0) << "outside again";
    }
  }
}

TEST(SpawnSecondary, RaysThatEnterCarryTheirMedia) {
  TextScene scene("sphere transp 1 index 1.25 extinct .5 1 0 0 0\n");
  const Ray ray = TextScene::RayTo({0, -10, 0}, {0, 1, 0});
  Hit hit;
  OpCounts counts;
  scene.objects().Nearest({&ray, 1}, {&hit, 1}, &counts);
  SurfaceHit resolved;
  ResolveHit(scene.scene(), ray, hit, &resolved);
  const Medium outside[] = {{1.1, .9}, {1.2, .8}};
  RayBundle bundle;
  bundle.media = {{3, 3}};  // of a ray that is there already
  const Secondary secondary =
      SpawnSecondary(scene.scene(), ray, outside, resolved, &bundle, &bundle);
  ASSERT_TRUE(secondary.transmitted.wanted);
  EXPECT_EQ(secondary.transmitted.extinct, .5);
  ASSERT_EQ(bundle.size(), 1u);
  const Ray& next = bundle.rays[0];
  EXPECT_EQ(next.depth, 1);
  EXPECT_EQ(next.kind, RayKind::kRefracted);
  ASSERT_EQ(next.media_count, 3);
  EXPECT_EQ(bundle.media[next.media_begin], outside[0]);
  EXPECT_EQ(bundle.media[next.media_begin + 2], (Medium{1.25, .5}));
}

TEST(Lights, SurfacesAndLightsWithoutShadowsTraceNoShadowRays) {
  const auto shadow_rays = [](const std::string& text) {
    TextScene scene(text);
    scene.Trace({0, -10, 0}, {0, 1, 0});
    return scene.counts().shadow_rays;
  };
  const std::string sphere = "sphere diffuse 1 1 1 1 0 0 0\n";
  EXPECT_EQ(shadow_rays("light 1 point 0 -9 0\nlight 1 directional 1 -1 0\n" + sphere), 2u);
  EXPECT_EQ(shadow_rays("light 1 point 0 -9 0 noshadow\n" + sphere), 0u);
  EXPECT_EQ(shadow_rays("light 1 point 0 9 0\n" + sphere), 0u) << "behind the surface";
  EXPECT_EQ(shadow_rays("light 1 point 0 -9 0\nsphere diffuse 1 1 1 noshadow 1 0 0 0\n"), 0u);
}

}  // namespace
}  // namespace rayshade
