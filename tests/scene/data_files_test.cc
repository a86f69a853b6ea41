// Colour maps, height fields and images [rayshade4/2 s.6.12, rayshade4/3 s.9.3, 11.4].
#include "rayshade/scene/data_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "rayshade/image/png.h"
#include "tests/support/recording_sink.h"

namespace rayshade {
namespace {

class DataFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = (std::filesystem::temp_directory_path() / "rayshade-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder_.data()), nullptr);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ + "/" + name, std::ios::binary) << bytes;
  }
  static std::string Heights(int32_t size, const std::vector<float>& altitudes) {
    std::string bytes(reinterpret_cast<const char*>(&size), sizeof size);
    bytes.append(reinterpret_cast<const char*>(altitudes.data()), altitudes.size() * sizeof(float));
    return bytes;
  }
  // A scene in the folder, read from elsewhere.
  Reading Scene(const std::string& text) {
    Write("scene.ray", text + "\nsphere 1 0 0 0\n");
    return ReadFile(folder_ + "/scene.ray");
  }

  std::string folder_;
};

TEST_F(DataFile, AreFoundBesideTheSceneWhereTheWorkingDirectoryHasNone) {
  Write("hill", Heights(2, {1, 2, 3, 4}));
  const Reading r = Scene("heightfield hill heightfield diffuse 1 1 1 hill");
  ASSERT_TRUE(r.good) << r.messages;
  const auto& first = std::get<HeightfieldSpec>(r.sink.geoms.at(0));
  EXPECT_EQ(first.size, 2);
  EXPECT_EQ(*first.altitudes, (std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(first.altitudes, std::get<HeightfieldSpec>(r.sink.geoms.at(1)).altitudes)
      << "read once";
}

TEST_F(DataFile, HeightfieldsIgnoreApplysurf) {  // [rayshade4/1 s.4.4]
  Write("hill", Heights(2, {1, 2, 3, 4}));
  const Reading r = Scene("applysurf ambient 1 0 0 heightfield hill heightfield cursurf hill");
  EXPECT_EQ(r.sink.calls, (std::vector<std::string>{"heightfield", "heightfield s0", "sphere s0"}));
}

TEST_F(DataFile, BrokenHeightfieldsAreErrors) {
  Write("empty", "");
  Write("short", Heights(3, {1, 2}));
  Write("one", Heights(1, {1}));
  Write("minus", Heights(-5, {1}));
  Write("huge", Heights(2147483647, {1}));
  const auto message = [this](const std::string& text) { return Scene(text).messages; };
  EXPECT_NE(message("heightfield empty").find("Cannot read height field size."), std::string::npos);
  EXPECT_NE(message("heightfield short").find("Not enough heightfield data."), std::string::npos);
  EXPECT_NE(message("heightfield huge").find("Not enough heightfield data."), std::string::npos);
  EXPECT_NE(message("heightfield one").find("Invalid height field size."), std::string::npos);
  EXPECT_NE(message("heightfield minus").find("Invalid height field size."), std::string::npos);
  EXPECT_NE(message("heightfield nosuch").find("Cannot open heightfield file \"nosuch\"."),
            std::string::npos);
  EXPECT_EQ(Scene("heightfield nosuch").status, 1);
}

TEST_F(DataFile, ColorMapsHaveUpTo256LinesOfThreeIntegers) {
  Write("two.map", "255 0 51\n300 1 2 and more\n");
  Write("bad.map", "1 2 3\n\n4 5 6\n");
  const Reading r = Scene("sphere 1 0 0 0 texture marble two.map");
  const auto& map = *std::get<MarbleSpec>(r.sink.textures.at(0).kind).map;
  ASSERT_EQ(map.size(), 256u);
  EXPECT_EQ(map[0], (Color{255 * (1 / 255.0), 0, 51 * (1 / 255.0)}));
  EXPECT_GT(map[1].r, 1);
  EXPECT_EQ(map[2], (Color{0, 0, 0}));
  EXPECT_EQ(Scene("sphere 1 0 0 0 texture mount bad.map 1 2").status, 2);
  EXPECT_EQ(Scene("sphere 1 0 0 0 texture mount nosuch 1 2").status, 1);
}

TEST_F(DataFile, GenericImagesStartWithTheRowOfVZero) {
  Write("photo", "2 1\nabcdef");
  const Reading r = Scene(
      "sphere 1 0 0 0 texture image photo tile 1 2 range .9 .1 smooth textsurf diffuse 1 1 1 "
      "component body "
      "map cylindrical");
  ASSERT_TRUE(r.good) << r.messages;
  const ImageSpec& spec = std::get<ImageSpec>(r.sink.textures.at(0).kind);
  EXPECT_EQ(spec.image->width, 2);
  EXPECT_EQ(spec.image->color, (std::vector<uint8_t>{'a', 'b', 'c', 'd', 'e', 'f'}));
  EXPECT_EQ(spec.range_high, .9);
  EXPECT_EQ(spec.range_low, .1);
  EXPECT_EQ(spec.tile_v, 2);
  EXPECT_TRUE(spec.smooth);
  EXPECT_EQ(spec.component, ImageComponent::kBody);
  EXPECT_EQ(spec.mapping.kind, MappingKind::kCylindrical);
}

TEST_F(DataFile, PngImagesAreReadToo) {
  Picture picture(2, 2);
  picture.at(0, 0).color = {1, 0, 0};
  WritePng(picture, folder_ + "/image.png", 1, AlphaChannel::kNone);
  const Reading r = Scene("sphere 1 0 0 0 texture image image.png heightfield image.png");
  ASSERT_TRUE(r.good) << r.messages;
  EXPECT_EQ(std::get<ImageSpec>(r.sink.textures.at(0).kind).image->width, 2);
  EXPECT_EQ(*std::get<HeightfieldSpec>(r.sink.geoms.at(1)).altitudes,
            (std::vector<float>{0, 0, 1, 0}))
      << "bottom row first";
}

TEST_F(DataFile, UtahPicturesAreRefusedWithAWayOut) {
  Write("sky.rle", "\x52\xcc" + std::string(40, '\0'));
  const Reading r = Scene("sphere 1 0 0 0 texture image sky.rle");
  EXPECT_EQ(r.status, 1);
  EXPECT_NE(r.messages.find("Image file sky.rle is Utah RLE"), std::string::npos) << r.messages;
  EXPECT_NE(r.messages.find("rletopnm sky.rle | pnmtopng > sky.rle.png"), std::string::npos);
}

TEST_F(DataFile, NumbersFromAnImageNeedOneChannel) {
  Write("photo", "1 1\nabc");
  Write("cut", "100 100\nabc");
  EXPECT_EQ(Scene("sphere 1 0 0 0 texture image photo component bump").status, 2);
  EXPECT_EQ(Scene("sphere 1 0 0 0 texture image cut").status, 1);
  EXPECT_NE(
      Scene("sphere 1 0 0 0 texture image nosuch").messages.find("Cannot open image file nosuch."),
      std::string::npos);
}

}  // namespace
}  // namespace rayshade
