// Scenes as they were written thirty years ago, with macros, conditions and included files, by
// editors of several systems, say what the same scene says in plain words.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "rayshade/scene/parse.h"
#include "tests/support/recording_sink.h"

namespace rayshade {
namespace {

namespace fs = std::filesystem;

const char kOld[] =
    "/*\n * Chess pieces.\tdo not edit \"lib/pieces.inc\"; it's generated\n */\n"
    "#ifndef SIZE\n#define SIZE 64\n#endif\n"
    "#define BLACK ambient .05 .05 .05 diffuse .1 .1 .1\n"
    "#define ROOK(surf,x,y) object surf rook translate x y 0\n"
    "#define TURNED( what , by )\twhat \\\n\t\trotate 0 0 1 by\n"
    "#include \"lib/pieces.inc\"\n"
    "#ifdef URT\n#define BOARD image board.rle\n#else\n#define BOARD checker BLACK\n#endif\n"
    "screen SIZE SIZE\n"
    "eyep\t0\t-10\t4\nlookp 0 0 1/* centre */\nup 0 0 1 fov 30/**/background .1 .2 .3\n"
    "light 1.4 point 10 -10 10\nlight .3 directional -1 -1 2noshadow\n"
    "#if 0\nthis is no scene\n#endif\n"
    "define tilt (15*dtor)\n"
    "plane BLACK 0 0 0 0 0 1 texture BOARD scale 1 1 1\n"
    "ROOK(ivory,-2,0) /* left */ ROOK(ebony, 2, 0)\n"
    "TURNED(box ivory -1 -1 3 1 1 4, 45)\n"
    "cylinder ebony .2 0 0 0 0 0(2 * cos(tilt))\n"
    "#undef SIZE\n";
const char kPieces[] =
    "surface ivory ambient .2 .2 .15\n\tdiffuse .8 .8 .6 specular .5 .5 .5 specpow 30.\n"
    "surface ebony ivory\n\tdiffuse .1 .1 .1\n"
    "name rook list\n\tcone .8 0 0 0 .5 0 0 1.5\n\ttorus .5 .1 0 0 1.5 0 0 1\nend";  // no line end
const char kPlain[] =
    "screen 64 64 eyep 0 -10 4 lookp 0 0 1 up 0 0 1 fov 30 background .1 .2 .3\n"
    "surface ivory ambient .2 .2 .15 diffuse .8 .8 .6 specular .5 .5 .5 specpow 30\n"
    "surface ebony ivory diffuse .1 .1 .1\n"
    "name rook list cone .8 0 0 0 .5 0 0 1.5 torus .5 .1 0 0 1.5 0 0 1 end\n"
    "light 1.4 point 10 -10 10 light .3 directional -1 -1 2 noshadow define tilt (15 * dtor)\n"
    "plane ambient .05 .05 .05 diffuse .1 .1 .1 0 0 0 0 0 1\n"
    "texture checker ambient .05 .05 .05 diffuse .1 .1 .1 scale 1 1 1\n"
    "object ivory rook translate -2 0 0 object ebony rook translate 2 0 0\n"
    "box ivory -1 -1 3 1 1 4 rotate 0 0 1 45 cylinder ebony .2 0 0 0 0 0 (2 * cos(tilt))\n";

std::string WithLineEnds(const std::string& text, const std::string& line_end) {
  std::string changed;
  for (const char c : text) changed += c == '\n' ? line_end : std::string(1, c);
  return changed;
}

class OldScene : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = (fs::temp_directory_path() / "rayshade-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder_.data()), nullptr);
    fs::create_directory(folder_ + "/lib");
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ + "/" + name, std::ios::binary) << text;
    return folder_ + "/" + name;
  }
  Reading ReadOld(const std::string& line_end, const Options& options = {}) {
    Write("lib/pieces.inc", WithLineEnds(kPieces, line_end));
    return ReadFile(Write("old.ray", WithLineEnds(kOld, line_end)), options);
  }

  std::string folder_;
};

void ExpectSame(const Reading& a, const Reading& b) {
  EXPECT_TRUE(a.good) << a.messages;
  EXPECT_EQ(a.messages, b.messages);
  EXPECT_EQ(a.sink.calls, b.sink.calls);
  EXPECT_EQ(a.sink.surfaces, b.sink.surfaces);
  ASSERT_EQ(a.sink.lights.size(), b.sink.lights.size());
  for (size_t i = 0; i < a.sink.lights.size(); ++i) {
    EXPECT_EQ(a.sink.lights[i].intensity, b.sink.lights[i].intensity);
    EXPECT_EQ(a.sink.lights[i].noshadow, b.sink.lights[i].noshadow);
  }
  ASSERT_EQ(a.sink.settings.size(), 1u);
  EXPECT_EQ(a.sink.settings[0].width, b.sink.settings.at(0).width);
  EXPECT_EQ(a.sink.settings[0].background, b.sink.settings[0].background);
  const auto* cylinder = std::get_if<CylinderSpec>(&a.sink.geoms.back());
  ASSERT_NE(cylinder, nullptr);
  EXPECT_EQ(cylinder->top, std::get<CylinderSpec>(b.sink.geoms.back()).top);
}

TEST_F(OldScene, SaysTheSameWithTheLineEndsOfAnySystem) {
  if (std::system("cpp --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "skipped: there is no cpp";
  const Reading plain = ReadText(kPlain);
  ExpectSame(ReadOld("\n"), plain);
  ExpectSame(ReadOld("\r\n"), plain);
}

TEST_F(OldScene, TakesDefinitionsFromTheCommandLine) {
  if (std::system("cpp --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "skipped: there is no cpp";
  Options options;
  options.preprocessor_arguments = {"-DSIZE=32 -DURT"};
  const Reading r = ReadOld("\n", options);
  EXPECT_EQ(r.status, 1);
  EXPECT_NE(r.messages.find("line 27: Cannot open image file board.rle."), std::string::npos)
      << r.messages;
}

TEST_F(OldScene, NamesTheIncludedFileInItsErrors) {
  if (std::system("cpp --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "skipped: there is no cpp";
  Write("lib/pieces.inc", "surface a diffuse 1 1\nsphere a 1 0 0 0\n");
  const Reading r = ReadFile(Write("old.ray", "#include \"lib/pieces.inc\"\nsphere b 1 0 0 0\n"));
  EXPECT_NE(r.messages.find("lib/pieces.inc: line 2: syntax error\n"), std::string::npos)
      << r.messages;
  EXPECT_NE(r.messages.find("old.ray, line 2: Undefined surface \"b\"."), std::string::npos)
      << r.messages;
}

}  // namespace
}  // namespace rayshade
