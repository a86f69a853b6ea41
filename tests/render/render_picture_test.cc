// The sequential program flow: names of files, continuing, what is left behind.
#include "rayshade/render/render_picture.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "rayshade/geom/spec.h"
#include "rayshade/render/partial_picture.h"
#include "rayshade/render/pixel_sampling.h"
#include "rayshade/render/sequential_tracer.h"

namespace rayshade {
namespace {

namespace fs = std::filesystem;

TEST(FrameFile, NumbersFilesOnlyWhereThereAreSeveralFrames) {
  Settings settings;
  settings.output = "a.png";
  EXPECT_EQ(FrameFile(settings, 3), "a.png");
  settings.frames = 5;
  EXPECT_EQ(FrameFile(settings, 3), "a.0003.png");
  settings.output = "a.ppm";
  EXPECT_EQ(FrameFile(settings, 12), "a.ppm.0012");
}

class RenderPicture : public ::testing::Test {
 protected:
  RenderPicture() : folder_(fs::temp_directory_path() / ("render." + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    settings_.output = (folder_ / "a.png").string();
    settings_.width = settings_.height = 24;
    settings_.quiet = true;
    options_.program = "rayshade";
  }
  ~RenderPicture() override {
    fs::remove_all(folder_);
    std::fclose(messages_);
  }

  static void AddBall(const Settings& settings, SceneBuilder* scene) {
    scene->AddPrimitive(SphereSpec{2, {0, 0, 0}}, {});
    scene->OnSettings(settings);
  }
  int Render() {
    SceneBuilder scene;
    AddBall(settings_, &scene);
    return RenderPictures(options_, &scene, &diagnostics_, Stopwatch());
  }
  std::string Picture() const {
    std::ifstream in(settings_.output, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // What an interrupted run leaves: some bundles are traced.
  void CutShort(int bundles) {
    SceneBuilder scene;
    AddBall(settings_, &scene);
    const SceneBuilder::Built built = scene.Build(0);
    const Camera camera(settings_, 0);
    PixelSampling sampling(settings_, camera, false);
    OpCounts counts;
    for (int i = 0; i < bundles; ++i) {
      const std::vector<Sample> samples = sampling.Next(64);
      RayBundle bundle;
      for (const Sample& sample : samples) bundle.rays.push_back(camera.PrimaryRay(sample));
      std::vector<RayResult> results(samples.size());
      TraceBundle(*built.scene, *built.objects, bundle, results, &counts);
      for (size_t k = 0; k < samples.size(); ++k) sampling.Put(samples[k], results[k]);
    }
    WritePartial(settings_.output, PictureFingerprint(settings_, 0, built.objects->size()),
                 sampling.Save());
  }

  fs::path folder_;
  std::FILE* messages_ = std::tmpfile();
  Diagnostics diagnostics_{"rayshade", messages_};
  Options options_;
  Settings settings_;
};

TEST_F(RenderPicture, GoesOnToTheSameBytesAfterAnInterruption) {
  ASSERT_EQ(Render(), 0);
  const std::string whole = Picture();
  fs::remove(settings_.output);
  CutShort(8);
  options_.continue_picture = true;
  ASSERT_EQ(Render(), 0);
  EXPECT_EQ(Picture(), whole);
  EXPECT_FALSE(fs::exists(PartialFile(settings_.output)));
}

TEST_F(RenderPicture, DoesNotGoOnWithAnotherPicture) {
  CutShort(3);
  options_.continue_picture = true;
  settings_.samples = 4;
  EXPECT_THROW(Render(), std::runtime_error);
}

TEST_F(RenderPicture, HasNothingToGoOnWith) {
  options_.continue_picture = true;
  EXPECT_EQ(Render(), 1);
}

TEST_F(RenderPicture, RefusesAViewBeforeAnythingIsDone) {
  settings_.eye = settings_.look;
  EXPECT_EQ(Render(), 2);
  EXPECT_FALSE(fs::exists(settings_.output));
}

TEST_F(RenderPicture, WritesStatisticsThatAddUp) {
  options_.stats_file = (folder_ / "s.json").string();
  ASSERT_EQ(Render(), 0);
  std::ifstream in(options_.stats_file);
  const std::string json{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(json.find("\"objects\":1,"), std::string::npos) << json;
}

}  // namespace
}  // namespace rayshade
