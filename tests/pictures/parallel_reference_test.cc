// Every scene of the reference set and of the gallery is the same picture, to the bit, by every
// schedule with 1, 4 and 7 processes; and images and height fields are only where they are needed.
// Resolution is reduced where no window in pixels stands in its way, unless RAYSHADE_FULL_SIZE is
// set (`make reference-parallel`).
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/parallel_run.h"

namespace rayshade::parallel {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string name;
  fs::path folder;                 // empty: there is nothing to test
  std::vector<std::string> words;  // of the command line, program and output left out
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

std::vector<Case> ReferenceCases() {
  const char* shared = std::getenv("RAYSHADE_SHARED");
  const fs::path folder = fs::path(shared ? shared : "../shared") / "reference" / "public";
  std::vector<Case> cases;
  std::ifstream in(folder / "manifest.tsv");
  std::string line, name, word;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream columns(line);
    std::getline(columns, name, '\t');
    std::string command;
    std::getline(columns, command, '\t');
    Case c{name, folder, {}};
    std::istringstream words(command);
    words >> word;
    while (words >> word) {
      const bool redirected = word == "<" || word == "-O";
      if (word == "-O") words >> word;
      if (!redirected) c.words.push_back(word);
    }
    cases.push_back(c);
  }
  if (cases.empty()) cases.push_back({"absent", {}, {}});
  return cases;
}

std::vector<Case> GalleryCases() {
  std::vector<Case> cases;
  const fs::path folder = "scenes/gallery";
  if (fs::exists(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      const fs::path file = entry.path();
      if (file.extension() != ".ray") continue;
      cases.push_back({file.stem().string(), folder, {file.filename().string()}});
    }
  }
  std::sort(cases.begin(), cases.end(),
            [](const Case& a, const Case& b) { return a.name < b.name; });
  if (cases.empty()) cases.push_back({"absent", {}, {}});
  return cases;
}

Options OptionsOf(const Case& c) {
  std::vector<const char*> arguments{"rayshade"};
  for (const std::string& word : c.words) arguments.push_back(word.c_str());
  const OptionsResult result =
      ParseOptions(static_cast<int>(arguments.size()), arguments.data(), {});
  if (!result.options) throw std::runtime_error("a bad command line");
  Options options = *result.options;
  options.input = (c.folder / options.input).string();
  return options;
}

class EveryScene : public testing::TestWithParam<Case> {};

TEST_P(EveryScene, IsTheSamePictureByEveryScheduleAndNumberOfProcesses) {
  const Case& c = GetParam();
  if (c.folder.empty()) GTEST_SKIP() << "skipped: no scenes here";
  Options options = OptionsOf(c);
  ObjectSpool spool;
  const Settings settings = ParseInto(options, &spool);
  ObjectSpool small;
  const bool reduced = std::getenv("RAYSHADE_FULL_SIZE") == nullptr && !settings.window &&
                       settings.width * settings.height > 36 * 36;
  if (reduced) {
    const int most = std::max(settings.width, settings.height);
    options.resolution = {std::max(1, 36 * settings.width / most),
                          std::max(1, 36 * settings.height / most)};
    ParseInto(options, &small);
  }
  const TestPicture sequential = RenderSequentially(options);
  for (const Schedule schedule :
       {Schedule::kDataParallel, Schedule::kDemandDriven, Schedule::kHybrid}) {
    for (const int processes : {1, 4, 7}) {
      RunOptions run;
      run.schedule = schedule;
      run.processes = static_cast<uint16_t>(processes);
      run.cell_bytes = 600;
      run.pyramid = 64;
      TestPicture parallel;
      ASSERT_NO_THROW(parallel = RenderInParallel(reduced ? &small : &spool, settings.first_frame,
                                                  run, static_cast<uint64_t>(processes)))
          << Name(schedule) << ", " << processes << " processes";
      EXPECT_TRUE(Identical(sequential.picture, parallel.picture))
          << Name(schedule) << ", " << processes << " processes";
      // Rays that the adaptive rule has traced ahead in vain are counted too.
      if (parallel.counts.primary_rays != sequential.counts.primary_rays) continue;
      EXPECT_EQ(sequential.counts.shadow_rays, parallel.counts.shadow_rays);
      EXPECT_EQ(sequential.counts.hits, parallel.counts.hits);
    }
  }
}

std::string TestName(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Reference, EveryScene, testing::ValuesIn(ReferenceCases()), TestName);
INSTANTIATE_TEST_SUITE_P(Gallery, EveryScene, testing::ValuesIn(GalleryCases()), TestName);

// A scene in which a picture of 256 x 256 is on one small sphere among others. With cells and their
// owners as they are, one or two processes own it.
class OneImage : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("one-image-" + std::to_string(getpid()));
    fs::create_directory(folder_);
    std::ofstream image(folder_ / "picture", std::ios::binary);
    image << "256 256\n" << std::string(256 * 256 * 3, '\x7f');
    std::ofstream scene(folder_ / "scene.ray");
    scene << "screen 24 24\nsample 1 nojitter\neyep 0 -9 0\nlookp 0 0 0\nfov 40\nlight 1 point 3 "
             "-8 4\n";
    for (int i = 0; i < 40; ++i) {
      scene << "sphere .2 " << (i % 8 - 3.5) * .7 << " 0 " << (i / 8 - 2) << "\n";
    }
    scene << "sphere .3 -2 -1 1.4 texture image picture component diffuse range .2 1\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST_F(OneImage, GoesOnlyToProcessesThatOwnWhatItCovers) {
  Options options;
  options.input = (folder_ / "scene.ray").string();
  options.raw_input = true;
  const TestPicture sequential = RenderSequentially(options);
  ObjectSpool spool;
  ParseInto(options, &spool);
  RunOptions run;
  run.schedule = Schedule::kDataParallel;
  run.processes = 7;
  run.cell_bytes = 300;
  const TestPicture parallel = RenderInParallel(&spool, 0, run, 1);
  EXPECT_TRUE(Identical(sequential.picture, parallel.picture));
  constexpr uint64_t kImage = 256 * 256 * 3;
  const uint64_t all = parallel.bytes[static_cast<int>(Tag::kSetUp)] +
                       parallel.bytes[static_cast<int>(Tag::kObjects)] +
                       parallel.bytes[static_cast<int>(Tag::kCellReply)];
  EXPECT_GE(all, kImage);
  EXPECT_LT(all, 4 * kImage);
  EXPECT_LT(parallel.bytes[static_cast<int>(Tag::kSetUp)], kImage);
  int holders = 0;
  for (const Statistics& s : parallel.processes) holders += s.bytes_held_max > kImage;
  EXPECT_GE(holders, 1);
  EXPECT_LE(holders, 3);
}

TEST_F(OneImage, IsFetchedWithTheCellOnDemand) {
  Options options;
  options.input = (folder_ / "scene.ray").string();
  options.raw_input = true;
  const TestPicture sequential = RenderSequentially(options);
  ObjectSpool spool;
  ParseInto(options, &spool);
  RunOptions run;
  run.schedule = Schedule::kDemandDriven;
  run.processes = 5;
  run.cell_bytes = 300;
  run.cache = 1;  // cells come again and again, the image does not
  const TestPicture parallel = RenderInParallel(&spool, 0, run, 1);
  EXPECT_TRUE(Identical(sequential.picture, parallel.picture));
  EXPECT_LT(parallel.bytes[static_cast<int>(Tag::kCellReply)], 7u * 256 * 256 * 3);
}

}  // namespace
}  // namespace rayshade::parallel
