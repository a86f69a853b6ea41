// No more than a scene needs: what a scene file mentions and no picture shows costs nothing, in
// operations per ray or in bytes per object.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rayshade/common/op_counts.h"
#include "rayshade/render/camera.h"
#include "rayshade/scene/scene_builder.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

// Three hundred balls and what stands before them; the view comes first in the text.
struct Parts {
  std::string before, balls, after;
  std::string text() const { return before + balls + after; }
};

Parts Plain() {
  Parts parts;
  parts.before =
      "screen 40 40\nsample 1 nojitter\ncontrast 1 1 1\neyep 4 -9 5\nlookp 0 0 0\nup 0 0 1\nfov "
      "30\nlight 1 point 5 -6 7\nlight .4 directional -1 -1 2\n"
      "surface dull ambient .1 .1 .1 diffuse .6 .5 .4\n"
      "surface shiny diffuse .3 .3 .4 specular .5 .5 .5 reflect .4\n";
  for (int i = 0; i < 300; ++i) {
    const int x = i % 10 - 5, y = i / 10 % 10 - 5, z = i / 100 - 1;
    parts.balls += "sphere " + std::string(i % 3 ? "dull " : "shiny ") + ".23 " +
                   std::to_string(x * .5) + " " + std::to_string(y * .5) + " " +
                   std::to_string(z * .5) + "\n";
  }
  return parts;
}

struct Cost {
  OpCounts counts;
  size_t object_bytes = 0;
  TestPicture picture;
};

Cost CostOf(const Parts& parts) {
  Cost cost;
  SceneBuilder builder;
  ParseText(parts.text(), &builder);
  cost.object_bytes = builder.Build(0).objects->bytes();
  cost.picture = RenderSequentially(parts.text());
  cost.counts = cost.picture.counts;
  return cost;
}

void ExpectSameCost(const Parts& with) {
  const Cost plain = CostOf(Plain()), more = CostOf(with);
  EXPECT_TRUE(Identical(plain.picture.picture, more.picture.picture));
  EXPECT_EQ(plain.object_bytes, more.object_bytes);
#define RAYSHADE_SAME(name) EXPECT_EQ(plain.counts.name, more.counts.name) << #name;
  RAYSHADE_OP_COUNTS(RAYSHADE_SAME)
#undef RAYSHADE_SAME
}

const char kSurfaces[] =
    "surface glass specular .5 .5 .5 transp .9 body .9 1 .9 index 1.5 extinct .8\n"
    "surface gold glass ambient .2 .1 0 diffuse .6 .5 .1\n";
const char kDarkLights[] =
    "light 0 point 1 2 3\nlight 0 0 0 area -1 0 5 1 0 5 3 -1 1 5 3\nlight 0 extended 1 3 3 3\n";
const char kNames[] =
    "name hidden list\n sphere shiny .5 0 0 0 texture marble texture bump .3\n cone dull 1 0 0 0 "
    ".5 0 0 1 rotate 1 0 0 (time * 9)\n difference sphere 1 0 0 0 box 0 0 0 1 1 1 end\nend\n"
    "name textured sphere dull 1 0 0 0 texture checker shiny scale 3 3 3\n";

TEST(Needs, SurfacesThatNoObjectHasCostNothing) {
  Parts parts = Plain();
  parts.before += kSurfaces;
  ExpectSameCost(parts);
}

TEST(Needs, LightsThatDoNotShineCostNothing) {
  Parts parts = Plain();
  parts.before += kDarkLights;
  ExpectSameCost(parts);
}

TEST(Needs, NamedObjectsAndTexturesThatAreNeverPlacedCostNothing) {
  Parts parts = Plain();
  parts.after += kNames;
  ExpectSameCost(parts);
}

TEST(Needs, AGridStatementCostsNothing) {
  Parts parts = Plain();
  parts.before += "grid 10 10 3\n";
  parts.after += "end\n";
  ExpectSameCost(parts);
}

TEST(Needs, AllTogetherCostNothing) {
  Parts parts = Plain();
  parts.before += std::string(kSurfaces) + kDarkLights + kNames + "grid 7 7 7\nlist\n";
  parts.after += "end\nend\n";
  ExpectSameCost(parts);
}

// The test of the tests: what is in the picture does cost.
TEST(Needs, WhatIsPlacedCosts) {
  Parts parts = Plain();
  parts.after += "cylinder dull .2 0 0 -1 0 0 2\n";
  const Cost plain = CostOf(Plain()), more = CostOf(parts);
  EXPECT_LT(plain.object_bytes, more.object_bytes);
  EXPECT_NE(plain.counts.primitive_tests, more.counts.primitive_tests);
}

}  // namespace
}  // namespace rayshade::parallel
