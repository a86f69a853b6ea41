// The original program's pictures, family by family: small scenes that each test one or two
// features. `make reference` shows the same at length.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "rayshade/common/diagnostics.h"
#include "rayshade/image/png.h"
#include "rayshade/render/render_picture.h"
#include "rayshade/scene/options.h"
#include "rayshade/scene/parse.h"
#include "rayshade/scene/scene_builder.h"

namespace rayshade {
namespace {

namespace fs = std::filesystem;

std::string Shared() {
  const char* shared = std::getenv("RAYSHADE_SHARED");
  return shared ? shared : "../shared";
}

struct Difference {
  double share_within = 0;  // of pixels, within 1/255
  double mean = 255;        // of bytes
};

Difference Compare(const ImageData& ours, const ImageData& theirs) {
  if (ours.width != theirs.width || ours.color.size() != theirs.color.size()) return {};
  size_t within = 0;
  double sum = 0;
  for (size_t i = 0; i < ours.color.size(); i += 3) {
    int largest = 0;
    for (size_t c = i; c < i + 3; ++c) {
      const int difference = std::abs(int(ours.color[c]) - int(theirs.color[c]));
      largest = std::max(largest, difference);
      sum += difference;
    }
    within += largest <= 1;
  }
  return {double(within) / (ours.color.size() / 3), sum / ours.color.size()};
}

// Renders with the words of a command line of the original. Messages are not shown.
int Render(const std::string& command, const std::string& output) {
  std::vector<std::string> words{"rayshade", "-q", "-O", output};
  std::istringstream in(command);
  std::string word;
  in >> word;
  while (in >> word) {
    if (word == "-O") {
      in >> word;
    } else {
      words.push_back(word);
    }
  }
  std::vector<const char*> argv;
  for (const std::string& w : words) argv.push_back(w.c_str());
  const OptionsResult result = ParseOptions(static_cast<int>(argv.size()), argv.data(), {});
  if (!result.options) return result.status;
  std::FILE* messages = std::tmpfile();
  Diagnostics diagnostics("rayshade", messages);
  SceneBuilder scene;
  const int status = ParseScene(*result.options, &diagnostics, &scene)
                         ? RenderPictures(*result.options, &scene, &diagnostics, Stopwatch())
                         : diagnostics.exit_status();
  std::fclose(messages);
  return status;
}

// Every deterministic scene of one family.
void ExpectFamily(const std::string& family) {
  const fs::path folder = fs::absolute(Shared() + "/reference/public");
  std::ifstream manifest(folder / "manifest.tsv");
  if (!manifest) GTEST_SKIP() << "skipped: no reference pictures at " << folder;
  const fs::path before = fs::current_path();
  const std::string output =
      (fs::temp_directory_path() / ("reference_test." + std::to_string(getpid()) + ".png"))
          .string();
  fs::current_path(folder);
  int scenes = 0;
  std::string line, name, command;
  while (std::getline(manifest, line)) {
    std::istringstream columns(line);
    std::getline(columns, name, '\t');
    std::getline(columns, command, '\t');
    if (name.rfind(family, 0) != 0 || command.find('<') != std::string::npos) continue;
    ++scenes;
    SCOPED_TRACE(name);
    EXPECT_EQ(Render(command, output), 0);
    if (!fs::exists(output)) continue;
    const Difference difference = Compare(ReadPng(output), ReadPng(name + ".png"));
    EXPECT_GE(difference.share_within, .999);
    EXPECT_LE(difference.mean, .05);
    fs::remove(output);
  }
  fs::current_path(before);
  EXPECT_GT(scenes, 0);
}

TEST(Reference, PrimitivesAreTheOriginals) { ExpectFamily("prim-"); }
TEST(Reference, CsgIsTheOriginals) { ExpectFamily("csg-"); }
TEST(Reference, SurfacesAreTheOriginals) { ExpectFamily("surf-"); }
TEST(Reference, LightsAreTheOriginals) { ExpectFamily("light-"); }
TEST(Reference, AirIsTheOriginals) { ExpectFamily("atmos-"); }
TEST(Reference, TexturesAreTheOriginals) { ExpectFamily("text-"); }
TEST(Reference, TransformsAreTheOriginals) { ExpectFamily("xform-"); }
TEST(Reference, CamerasAreTheOriginals) { ExpectFamily("cam-"); }
TEST(Reference, SamplingIsTheOriginals) { ExpectFamily("samp-"); }
TEST(Reference, TheLanguageIsTheOriginals) { ExpectFamily("lang-"); }

}  // namespace
}  // namespace rayshade
