// Pictures written and read back [rayshade4/1 s.10], and files that are whole or as before.
#include "rayshade/image/png.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace rayshade {
namespace {

namespace fs = std::filesystem;

class Png : public ::testing::Test {
 protected:
  Png() : folder_(fs::temp_directory_path() / ("png_test." + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~Png() override { fs::remove_all(folder_); }
  std::string Name(const char* name) const { return (folder_ / name).string(); }
  size_t files() const { return std::distance(fs::directory_iterator(folder_), {}); }

  fs::path folder_;
};

Picture Row(std::initializer_list<double> reds) {
  Picture picture(static_cast<int>(reds.size()), 1);
  int x = 0;
  for (const double red : reds) picture.at(x++, 0).color = {red, 0, 0};
  return picture;
}

std::vector<int> Reds(const ImageData& image) {
  std::vector<int> reds;
  for (size_t i = 0; i < image.color.size(); i += 3) reds.push_back(image.color[i]);
  return reds;
}

std::string Contents(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(Png, TruncatesAndClampsColours) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  WritePng(Row({-1, 0, .1, .5, .9, .999, 1, 7, nan}), Name("a.png"), 1, AlphaChannel::kNone);
  EXPECT_EQ(Reds(ReadPng(Name("a.png"))), (std::vector<int>{0, 0, 25, 127, 229, 254, 255, 255, 0}));
}

TEST_F(Png, CorrectsForGamma) {
  WritePng(Row({.5, .9, 1}), Name("a.png"), 2.2, AlphaChannel::kNone);
  EXPECT_EQ(Reds(ReadPng(Name("a.png"))), (std::vector<int>{186, 243, 255}));
  WritePng(Row({.5, .999, 1}), Name("a.png"), 0, AlphaChannel::kNone);
  EXPECT_EQ(Reds(ReadPng(Name("a.png"))), (std::vector<int>{0, 0, 255}));
}

TEST_F(Png, WritesCoverageOrSampleMapAsAlphaWithoutGamma) {
  Picture picture = Row({1, 1, 1});
  picture.at(0, 0).alpha = .5;
  picture.at(1, 0).full = true;
  WritePng(picture, Name("a.png"), 2.2, AlphaChannel::kCoverage);
  EXPECT_EQ(ReadPng(Name("a.png")).alpha, (std::vector<uint8_t>{127, 0, 0}));
  WritePng(picture, Name("a.png"), 2.2, AlphaChannel::kSampleMap);
  EXPECT_EQ(ReadPng(Name("a.png")).alpha, (std::vector<uint8_t>{0, 255, 0}));
}

TEST_F(Png, ReadsTheBottomRowFirst) {
  Picture picture(1, 2);
  picture.at(0, 0).color = {1, 1, 1};
  WritePng(picture, Name("a.png"), 1, AlphaChannel::kNone);
  EXPECT_EQ(ReadPng(Name("a.png")).color, (std::vector<uint8_t>{0, 0, 0, 255, 255, 255}));
}

TEST_F(Png, HoldsNothingButThePixels) {
  WritePng(Row({.5}), Name("a.png"), 1, AlphaChannel::kNone);
  const std::string bytes = Contents(Name("a.png"));
  for (const char* chunk : {"tIME", "tEXt", "iTXt", "zTXt"}) {
    EXPECT_EQ(bytes.find(chunk), std::string::npos) << chunk;
  }
}

TEST_F(Png, LeavesNoOtherFileBehind) {
  WritePng(Row({.5}), Name("a.png"), 1, AlphaChannel::kNone);
  EXPECT_EQ(files(), 1u);
}

TEST_F(Png, NamesAFullDisk) {
  if (access("/dev/full", W_OK) != 0) GTEST_SKIP() << "skipped: no /dev/full here";
  try {
    WritePng(Row({.5}), "/dev/full", 1, AlphaChannel::kNone);
    FAIL() << "no error";
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "Cannot write /dev/full: No space left on device.");
  }
  struct stat device;
  ASSERT_EQ(stat("/dev/full", &device), 0);
  EXPECT_TRUE(S_ISCHR(device.st_mode));
}

TEST_F(Png, SaysBeforehandThatADirectoryIsMissing) {
  EXPECT_NO_THROW(CheckWritable(Name("a.png")));
  EXPECT_NO_THROW(CheckWritable("-"));
  EXPECT_THROW(CheckWritable(Name("nodir/a.png")), std::runtime_error);
  EXPECT_THROW(CheckWritable(folder_.string()), std::runtime_error);
}

TEST_F(Png, RefusesWhatIsNoPngAndWhatWasCutShort) {
  std::ofstream(Name("text.png")) << "hello";
  EXPECT_THROW(ReadPng(Name("text.png")), std::runtime_error);
  EXPECT_THROW(ReadPng(Name("none.png")), std::runtime_error);
  WritePng(Picture(100, 100), Name("a.png"), 1, AlphaChannel::kNone);
  fs::resize_file(Name("a.png"), fs::file_size(Name("a.png")) - 60);
  EXPECT_THROW(ReadPng(Name("a.png")), std::runtime_error);
}

}  // namespace
}  // namespace rayshade
