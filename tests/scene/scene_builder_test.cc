// What scenes made through the builder show: ties, clips, instances, surfaces, frames.
#include "rayshade/scene/scene_builder.h"

#include <gtest/gtest.h>

#include "rayshade/render/camera.h"
#include "tests/shade/text_scene.h"

namespace rayshade {
namespace {

// Surfaces that show nothing but their ambient colour: red, green, blue.
const char kHead[] =
    "surface r ambient 1 0 0\nsurface g ambient 0 1 0\nsurface b ambient 0 0 1\n"
    "light 0 directional 0 -1 0\n";

// r, g, b; "." where nothing is hit. Looking along +y from (x, -10, z).
char Seen(const std::string& text, double x = 0, double z = 0, int frame = 0, double time = 0) {
  test::TextScene scene(kHead + text + "\n", frame);
  Ray ray = test::TextScene::RayTo({x, -10, z}, {0, 1, 0});
  ray.time = time;
  const RayResult result = scene.Trace(ray);
  return !result.hit ? '.' : result.color.r > 0 ? 'r' : result.color.g > 0 ? 'g' : 'b';
}

TEST(SceneBuilder, CoincidentObjectsShowByRayshadesRules) {
  // Part 2, s.8.2 and 8.3: identical copies, red written first.
  EXPECT_EQ(Seen("sphere r 1 0 0 0 sphere g 1 0 0 0"), 'g');
  EXPECT_EQ(Seen("disc r 1 0 0 0 0 1 0 disc g 1 0 0 0 0 1 0"), 'r');
  EXPECT_EQ(Seen("plane r 0 0 0 0 1 0 plane g 0 0 0 0 1 0"), 'r');
  EXPECT_EQ(Seen("grid 1 1 1 sphere r 1 0 0 0 sphere g 1 0 0 0 end"), 'r');
  EXPECT_EQ(Seen("grid 1 1 1 disc r 1 0 0 0 0 1 0 disc g 1 0 0 0 0 1 0 end"), 'g');
}

TEST(SceneBuilder, InclusiveKindsWinOverPlanesAndBoxesWhateverTheOrder) {
  EXPECT_EQ(Seen("disc r 1 0 0 0 0 1 0 plane g 0 0 0 0 1 0"), 'r');
  EXPECT_EQ(Seen("plane g 0 0 0 0 1 0 disc r 1 0 0 0 0 1 0"), 'r');
  EXPECT_EQ(Seen("disc r 1 0 0 0 0 1 0 box g -1 0 -1 1 1 1"), 'r');
  EXPECT_EQ(Seen("box g -1 0 -1 1 1 1 disc r 1 0 0 0 0 1 0"), 'r');
}

TEST(SceneBuilder, SurfacesComeFromTheInnermostObjectThatHasOne) {
  // The table of part 2, s.4.1; d is red, a green.
  EXPECT_EQ(Seen("name f sphere 1 0 0 0 object r f"), 'r');
  EXPECT_EQ(Seen("name f sphere g 1 0 0 0 object r f"), 'g');
  EXPECT_EQ(Seen("applysurf g list sphere 1 0 0 0 end"), 'g');
  EXPECT_EQ(Seen("applysurf g list applysurf b sphere 1 0 0 0 applysurf r end"), 'b');
  EXPECT_EQ(Seen("name f list sphere 1 0 0 0 end applysurf b object f"), 'b');
}

TEST(SceneBuilder, InstancesAreWhereTheirPathPutsThem) {
  const std::string scene =
      "name f list sphere r 1 0 0 0 translate 1 0 0 end scale 2 2 2\n"
      "object f translate 10 0 0 list object f end translate 0 0 20";
  EXPECT_EQ(Seen(scene, 12), 'r');
  EXPECT_EQ(Seen(scene, 13.9), 'r');
  EXPECT_EQ(Seen(scene, 9.9), '.');
  EXPECT_EQ(Seen(scene, 2, 20), 'r');
  EXPECT_EQ(Seen(scene, 2), '.');
}

TEST(SceneBuilder, ANamedObjectThatIsNotPlacedIsNotSeen) {
  EXPECT_EQ(Seen("name f sphere r 1 0 0 0 sphere g 1 5 0 0"), '.');
}

TEST(SceneBuilder, ABoundedListClipsItsPlane) {
  // Part 2, s.8.5: the plane is visible only where the ray meets the world's box.
  const std::string list = "list plane r 0 5 0 0 1 0 sphere g 1 0 0 0 end\n";
  EXPECT_EQ(Seen(list, .9, .9), 'r');
  EXPECT_EQ(Seen(list, 1.5), '.');
  EXPECT_EQ(Seen("plane r 0 5 0 0 1 0 sphere g 1 0 0 0", 1.5), 'r');
  EXPECT_EQ(Seen(list + "sphere b 1 9 0 9", 1.5), 'r') << "a far object enlarges the box";
  EXPECT_EQ(Seen("name f list plane r 0 5 0 0 1 0 sphere g 1 0 0 0 end object f", 1.5), '.');
}

TEST(SceneBuilder, AUnionWithAPlaneIsClippedByItsOwnBoxAndOthers) {
  // Part 2, s.8.5 and 9.2: it counts as bounded, and ends where the world's box does.
  const std::string both = "union plane r 0 5 0 0 -1 0 sphere g 1 0 0 0 end\n";
  EXPECT_EQ(Seen(both), 'g');
  EXPECT_EQ(Seen(both, .9, .9), 'r');
  EXPECT_EQ(Seen(both, 1.5), '.');
  EXPECT_EQ(Seen(both + "sphere b 1 9 0 9", 1.5), 'r') << "a far object enlarges the box";
  EXPECT_EQ(Seen("list " + both + "end", 1.5), '.');
  EXPECT_EQ(Seen("name f " + both + "object f", 1.5), '.');
  // Without a box it has no end: only the second operand has one.
  EXPECT_EQ(Seen("difference plane r 0 5 0 0 1 0 sphere g 1 0 5 0 end sphere g 1 0 9 0", 9), 'r');
}

// The pictures that part 2, s.8.5 counts: pixels that show the plane.
TEST(SceneBuilder, APlaneShowsInAsManyPixelsAsInTheOriginal) {
  const auto pixels = [](const std::string& text) {
    test::TextScene scene(kHead + ("screen 32 32 sample 1 nojitter eyep 0 -10 3 fov 30\n" + text));
    const Camera camera(scene.scene().settings(), 0);
    int red = 0;
    for (int i = 0; i < 32 * 32; ++i) {
      Sample sample;
      sample.x = i % 32;
      sample.y = i / 32;
      sample.single = true;
      red += scene.Trace(camera.PrimaryRay(sample)).color.r > 0;
    }
    return red;
  };
  const std::string both = "plane r 0 0 -1 0 0 1 sphere g 1 0 0 0 ";
  EXPECT_EQ(pixels(both), 912);
  EXPECT_EQ(pixels("list " + both + "end"), 66);
  EXPECT_EQ(pixels("grid 1 1 1 " + both + "end"), 66);
  EXPECT_EQ(pixels("union " + both + "end"), 66);
  EXPECT_EQ(pixels("name f list " + both + "end object f"), 66);
  EXPECT_EQ(pixels("list " + both + "end box 100 100 100 101 101 101"), 425);
}

TEST(SceneBuilder, NamedObjectsBringTheirContentIntoCsg) {
  const std::string scene =
      "name hole list sphere g 1 0 0 0 end translate 0 -1 0\n"
      "difference box r -1 -1 -1 1 1 1 object hole end";
  EXPECT_EQ(Seen(scene), 'g') << "the cut face";
  EXPECT_EQ(Seen(scene, .99, .99), 'r');
}

TEST(SceneBuilder, ObjectsMayBeEnlargedByAnyFactor) {
  // Part 2, s.3.6 and 15: the original lost them beyond 1e5, and left their normals short.
  test::TextScene scene(
      "light 1 directional 0 -1 0\nsphere diffuse 1 1 1 1e-4 0 0 0 scale 1e3 1e3 1e3 scale 1e4 1e4 "
      "1e4\n");
  EXPECT_NEAR(scene.Trace({0, -1e4, 0}, {0, 1, 0}).color.r, 1, 1e-9);
  EXPECT_NEAR(scene.Trace({600, -1e4, 0}, {0, 1, 0}).color.r, .8, 1e-9);
  EXPECT_FALSE(scene.Trace({1001, -1e4, 0}, {0, 1, 0}).hit);
}

TEST(SceneBuilder, EachFrameHasItsObjectsWhereTheyAreThen) {
  const std::string scene =
      "frames 3\nsphere r 1 0 0 0 translate (10 * time) 0 0\n"
      "name f box g -1 -1 -1 1 1 1\nobject f translate 0 0 (10 * frame)\n"
      "grid 2 2 2 sphere b 1 0 0 -10 sphere b 1 0 0 -20 end";
  SceneBuilder builder;
  Options options;
  Diagnostics diagnostics("test");
  ASSERT_TRUE(ParseText(kHead + scene + "\n", options, &diagnostics, &builder));
  for (int frame = 0; frame < 3; ++frame) {
    const SceneBuilder::Built built = builder.Build(frame);
    OpCounts counts;
    const auto hits = [&](double x, double z) {
      Ray ray = test::TextScene::RayTo({x, -10, z}, {0, 1, 0});
      ray.time = frame;
      Hit hit;
      built.objects->Nearest({&ray, 1}, {&hit, 1}, &counts);
      return hit.found();
    };
    for (int other = 1; other < 3; ++other) {
      EXPECT_EQ(hits(10 * other, 0), frame == other);
      EXPECT_EQ(hits(0, 10 * other), frame == other);
      EXPECT_TRUE(hits(0, -10 * other));
    }
  }
}

TEST(SceneBuilder, TexturesMoveWhereObjectsAreStale) {
  // Part 1, s.5.12 and 5.14: all rays have time 0, objects stand where they are at time 1.
  const std::string scene =
      "plane r 0 5 0 0 1 0 texture checker g translate (.5 + time) .5 .5\nshutter 1\n";
  EXPECT_EQ(Seen(scene, 0, 0, 0, 0), 'r');
  EXPECT_EQ(Seen(scene, 0, 0, 0, 1), 'g');
  EXPECT_EQ(Seen(scene + "sample 1 nojitter", 0, 0, 0, 1), 'r');
}

TEST(SceneBuilder, CountsPrimitivesAsOftenAsTheyArePlaced) {
  SceneBuilder builder;
  Options options;
  Diagnostics diagnostics("test");
  ASSERT_TRUE(
      ParseText("name a list sphere 1 0 0 0 box 1 1 1 2 2 2 end name b object a name u sphere 1 "
                "0 0 0\nname c union sphere 1 0 0 0 object a end\n"
                "list object a object b end object c grid 1 1 1 object c end disc 1 0 0 0 0 0 1",
                options, &diagnostics, &builder));
  EXPECT_EQ(builder.primitives_placed(), 2u + 2 + 3 + 3 + 1);
}

TEST(SceneBuilder, WhatIsNotUsedCostsNothing) {
  std::string spheres, extra;
  for (int i = 0; i < 200; ++i) {
    spheres += "sphere r 1 " + std::to_string(3 * (i % 20)) + " " + std::to_string(i / 20) + " 0\n";
  }
  const std::string bare = kHead + spheres;
  const std::string dressed = std::string(kHead) +
                              "surface glass transp 1 index 1.5\nname unused list sphere glass 1 "
                              "0 0 0 texture bump .3 end\nlight 0 point 1 2 3\ngrid 5 5 5\n" +
                              spheres + "end\n";
  test::TextScene a(bare), b(dressed);
  for (int i = 0; i < 100; ++i) {
    const Vector eye{.6 * i, -10, 3}, to{0, 5, -1.5};
    EXPECT_EQ(a.Trace(eye, to).color, b.Trace(eye, to).color);
  }
  EXPECT_EQ(a.counts().primitive_tests, b.counts().primitive_tests);
  EXPECT_EQ(a.counts().node_visits, b.counts().node_visits);
  EXPECT_EQ(a.counts().shadow_rays, b.counts().shadow_rays);
  EXPECT_EQ(a.objects().bytes(), b.objects().bytes());
}

}  // namespace
}  // namespace rayshade
