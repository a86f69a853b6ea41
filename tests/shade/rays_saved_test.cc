// Rays that provably cannot change the picture are counted but not traced. What they are is told by
// pictures: with nothing saved (a scene that is not known to be finite) each one is the same to the
// byte.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "rayshade/render/camera.h"
#include "rayshade/render/pixel_sampling.h"
#include "rayshade/render/sequential_tracer.h"
#include "rayshade/scene/parse.h"
#include "rayshade/scene/scene_builder.h"
#include "tests/support/parallel_run.h"

namespace rayshade {
namespace {

struct Rendered {
  Picture picture{0, 0};
  OpCounts counts;
};

Rendered Render(SceneBuilder* builder, int frame, bool save) {
  const SceneBuilder::Built built = builder->Build(frame);
  built.scene->finite &= save;
  const Camera camera(built.scene->settings(), frame);
  PixelSampling sampling(built.scene->settings(), camera, /*ahead=*/false);
  Rendered rendered;
  while (!sampling.done()) {
    const std::vector<Sample> samples = sampling.Next(1024);
    RayBundle bundle;
    for (const Sample& s : samples) bundle.rays.push_back(camera.PrimaryRay(s));
    std::vector<RayResult> results(samples.size());
    TraceBundle(*built.scene, *built.objects, bundle, results, &rendered.counts);
    for (size_t i = 0; i < samples.size(); ++i) sampling.Put(samples[i], results[i]);
  }
  rendered.picture = sampling.picture();
  return rendered;
}

// Renders one scene that was read twice, with and without saving, compares, and returns how many
// rays were saved.
uint64_t Compared(SceneBuilder* first, SceneBuilder* second) {
  const int frame = first->settings().first_frame;
  const Rendered saving = Render(first, frame, true), whole = Render(second, frame, false);
  EXPECT_TRUE(parallel::Identical(saving.picture, whole.picture));
  EXPECT_EQ(saving.counts.shadow_rays, whole.counts.shadow_rays);
  EXPECT_EQ(saving.counts.total_rays(), whole.counts.total_rays());
  EXPECT_EQ(whole.counts.rays_saved, 0u);
  return saving.counts.rays_saved;
}

uint64_t SavedIn(const std::string& text) {
  SCOPED_TRACE(text);
  SceneBuilder first, second;
  for (SceneBuilder* builder : {&first, &second}) {
    Diagnostics diagnostics("test");
    Options options;
    options.program = "test";
    EXPECT_TRUE(ParseText(text, options, &diagnostics, builder));
  }
  return Compared(&first, &second);
}

uint64_t SavedInFile(const std::string& file, int pixels) {
  SCOPED_TRACE(file);
  SceneBuilder first, second;
  for (SceneBuilder* builder : {&first, &second}) {
    Diagnostics diagnostics("test");
    diagnostics.set_quiet(true);
    Options options;
    options.program = "test";
    options.input = file;
    options.resolution = {pixels, pixels};
    EXPECT_TRUE(ParseScene(options, &diagnostics, builder));
  }
  return Compared(&first, &second);
}

const char kView[] = "screen 20 20\nsample 1 nojitter\neyep 0 -8 3\nlookp 0 0 0\n";

TEST(RaysSaved, AreNoneWhereEveryLightShows) {
  EXPECT_EQ(SavedIn(std::string(kView) + "light 1 point 3 -5 6\nsphere diffuse .5 .5 .5 1 0 0 0\n"),
            0u);
}

TEST(RaysSaved, AreAllWhereTheSurfaceTakesNoLight) {
  const std::string scene = std::string(kView) + "light 1 point 3 -5 6\n";
  EXPECT_GT(SavedIn(scene + "sphere ambient .5 .4 .3 diffuse 0 0 0 specular 0 0 0 1 0 0 0\n"), 0u);
  EXPECT_GT(SavedIn(scene + "sphere diffuse 0 0 0 specular 0 0 0 reflect 1 1 0 0 0\n"), 0u);
}

TEST(RaysSaved, AreThoseWithoutAHighlightWhereASurfaceOnlyShines) {
  const std::string text =
      std::string(kView) +
      "light 1 point 3 -5 6\nsphere diffuse 0 0 0 specular .9 .9 .9 specpow 20 2 0 0 0\n";
  EXPECT_GT(SavedIn(text), 0u);
}

TEST(RaysSaved, AreThoseOfALightWithoutTheSurfacesColours) {
  const std::string ball = "sphere diffuse .5 .4 0 specular 0 0 0 1 0 0 0\n";
  EXPECT_GT(SavedIn(std::string(kView) + "light 0 0 1 point 3 -5 6\n" + ball), 0u);
  EXPECT_EQ(SavedIn(std::string(kView) + "light 0 .1 1 point 3 -5 6\n" + ball), 0u);
}

TEST(RaysSaved, AreThoseThatAColouredMirrorSwallows) {
  const std::string text =
      std::string(kView) +
      "light 1 point 3 -5 6\nplane diffuse .1 .1 .1 specular .9 0 0 reflect 1 0 0 -1 0 0 1\n"
      "sphere diffuse 0 .5 .5 specular 0 0 0 1 0 0 0\n";
  EXPECT_GT(SavedIn(text), 0u);
}

TEST(RaysSaved, AreThoseBehindFog) {
  const std::string scene = std::string(kView) +
                            "light 1 point 3 -5 6\nplane diffuse .5 .5 .5 0 0 -1 0 0 1\n"
                            "sphere diffuse .5 .5 .5 specular .5 .5 .5 reflect .5 1 0 0 0\n";
  EXPECT_GT(SavedIn(scene + "atmosphere 1 fog .5 .5 .5 .5 .5 .5\n"), 0u);
  EXPECT_EQ(SavedIn(scene + "atmosphere 1 fog .5 .5 .5 50 50 500\n"), 0u);
}

TEST(RaysSaved, AreNoneBehindATranslucentSurfaceWhereEachLightScalesTheOthers) {
  const std::string text = std::string(kView) +
                           "light 0 0 1 point 0 5 3\nlight 1 point 1 5 3\n"
                           "disc diffuse 1 0 0 translucency .5 1 0 0 10 3 0 0 0 0 -1 0\n";
  EXPECT_EQ(SavedIn(text), 0u);
}

TEST(RaysSaved, ChangeNoPictureOfTheGallery) {
  uint64_t saved = 0;
  for (const auto& entry : std::filesystem::directory_iterator("scenes/gallery")) {
    if (entry.path().extension() == ".ray") saved += SavedInFile(entry.path().string(), 24);
  }
  EXPECT_GT(saved, 0u);
}

}  // namespace
}  // namespace rayshade
