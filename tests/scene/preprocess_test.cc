// The C preprocessor, and where the text of a scene comes from [rayshade4/1 s.2].
#include "rayshade/scene/preprocess.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "rayshade/scene/parse.h"
#include "tests/support/recording_sink.h"

namespace rayshade {
namespace {

using Calls = std::vector<std::string>;

// A folder of scene files that is gone after the test.
class InputText : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = (std::filesystem::temp_directory_path() / "rayshade-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder_.data()), nullptr);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ + "/" + name, std::ios::binary) << text;
    return folder_ + "/" + name;
  }
  static bool HaveCpp() { return std::system("cpp --version >/dev/null 2>&1") == 0; }

  std::string folder_;
};

TEST(Preprocessor, MattersOnlyWhereItCouldChangeSomething) {
  for (const char* text :
       {"sphere 1 0 0 0\n", "/* a / b * c % */", "box_x.y -1 2 3", "max x ax nux"}) {
    EXPECT_FALSE(PreprocessorMatters(text)) << text;
  }
  for (const char* text : {"#define A", "sphere\r\n", "a\fb", "a // b", "unix", "object linux",
                           "a__b", "\\", "%:define", "\xef\xbb\xbfsphere"}) {
    EXPECT_TRUE(PreprocessorMatters(text)) << text;
  }
}

TEST_F(InputText, IsNotPreprocessedWithoutNeed) {
  const std::string file = Write("plain.ray", "/* only\n balls */\nsphere 1 0 0 0\n");
  const char* path = std::getenv("PATH");
  const std::string saved = path ? path : "";
  setenv("PATH", "/nonexistent", 1);  // no cpp
  const Reading plain = ReadFile(file);
  const Reading needy = ReadFile(Write("needy.ray", "#define R 1\nsphere R 0 0 0\n"));
  setenv("PATH", saved.c_str(), 1);
  EXPECT_EQ(plain.sink.calls, (Calls{"sphere"})) << plain.messages;
  EXPECT_EQ(needy.status, 2);
  EXPECT_NE(needy.messages.find("no program cpp was found"), std::string::npos) << needy.messages;
}

TEST_F(InputText, GoesThroughMacrosAndIncludes) {
  if (!HaveCpp()) GTEST_SKIP() << "skipped: no cpp";
  Write("balls.inc", "#define BALL(x) sphere 1 x 0 0\n");
  const std::string file = Write(
      "main.ray",
      "#include \"balls.inc\"\nBALL(1) // one\nBALL(2)\r\n#ifdef MORE\nBALL(COUNT)\n#endif\n");
  EXPECT_EQ(ReadFile(file).sink.calls, (Calls{"sphere", "sphere"}));
  Options options;
  options.preprocessor_arguments = {"-DMORE -DCOUNT=7"};
  const Reading more = ReadFile(file, options);
  ASSERT_EQ(more.sink.geoms.size(), 3u) << more.messages;
  EXPECT_EQ(std::get<SphereSpec>(more.sink.geoms[2]).center.x, 7);
}

TEST_F(InputText, MistakesInIncludedFilesAreReportedThere) {
  if (!HaveCpp()) GTEST_SKIP() << "skipped: no cpp";
  Write("bad.inc", "sphere 1 0 0 0\nsphere 1 0 0\n\n");
  const Reading r = ReadFile(Write("main.ray", "#include \"bad.inc\"\nbox 1\nbox 0 0 0 1 1 1\n"));
  EXPECT_NE(r.messages.find("main.ray: line 2: syntax error"), std::string::npos) << r.messages;
  EXPECT_NE(r.messages.find("main.ray: line 3: syntax error"), std::string::npos) << r.messages;
  Write("worse.inc", "sphere 1 0 0 0\nsphere nosuch 1 0 0 0\n");
  const Reading s = ReadFile(Write("main.ray", "\n#include \"worse.inc\"\n"));
  EXPECT_NE(s.messages.find("worse.inc, line 2: Undefined surface"), std::string::npos)
      << s.messages;
}

TEST_F(InputText, AFailedIncludeLeavesWhatCameBefore) {
  if (!HaveCpp()) GTEST_SKIP() << "skipped: no cpp";
  testing::internal::CaptureStderr();  // cpp's own words
  const Reading r =
      ReadFile(Write("main.ray", "sphere 1 0 0 0\n#include \"nosuch.inc\"\nbox 0 0 0 1 1 1\n"));
  EXPECT_NE(testing::internal::GetCapturedStderr().find("nosuch.inc"), std::string::npos);
  EXPECT_TRUE(r.good);
  EXPECT_EQ(r.sink.calls, (Calls{"sphere"}));
  EXPECT_NE(r.messages.find("rs: Warning: The preprocessor complained about"), std::string::npos)
      << r.messages;
}

TEST_F(InputText, AMissingOrUnreadableSceneIsOneClearLine) {
  const Reading r = ReadFile(folder_ + "/nosuch.ray");
  EXPECT_EQ(r.messages, "rs: Fatal error: Cannot open " + folder_ + "/nosuch.ray.\n");
  EXPECT_EQ(r.status, 2);
  EXPECT_EQ(ReadFile(folder_).messages, "rs: Fatal error: Cannot open " + folder_ + ".\n");
}

TEST_F(InputText, ShellCharactersInNamesAreHarmless) {
  if (!HaveCpp()) GTEST_SKIP() << "skipped: no cpp";
  const Reading r = ReadFile(Write("a; touch b $(c) 'd'.ray", "#define R 1\nsphere R 0 0 0\n"));
  EXPECT_EQ(r.sink.calls, (Calls{"sphere"})) << r.messages;
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/b"));
}

TEST_F(InputText, RawTextKnowsHashLinesOnly) {
  Options raw;
  raw.raw_input = true;
  const Reading r = ReadFile(
      Write("a.ray",
            "# 7 \"x y.h\"\nsphere A 1 0 0 0\n#line 3\n# 20 \"\"\nsphere B 1 0 0 0\n#define R 2\n"),
      raw);
  EXPECT_EQ(r.messages,
            "rs: Fatal error: x y.h, line 7: Undefined surface \"A\".\n"
            "rs: Fatal error: stdin, line 20: Undefined surface \"B\".\n"
            "rs: Fatal error: stdin, line 21: Unknown '#' control (define R 2).\n");
}

TEST_F(InputText, AHashCountsInTheFirstColumnOnly) {
  EXPECT_EQ(ReadText("# 5 \"f\"\nsphere 1 0 0 0\n").messages, "");
  EXPECT_EQ(ReadText(" # 5\nsphere 1 0 0 0\n").messages,
            "rs: Error: stdin: line 1: syntax error\n");
  EXPECT_EQ(ReadText("sphere 1 0 0 0 # 5\n").messages, "rs: Error: stdin: line 1: syntax error\n");
}

TEST(Memory, DoesNotGrowWithTheLengthOfTheInput) {
  // 12 MB of spheres from a generator, and never more than a few of them in memory.
  class Counting : public RecordingSink {
   public:
    void AddPrimitive(GeomSpec&&, Attributes&&) override { ++count; }
    void OnSettings(const Settings&) override {}
    int count = 0;
  };
  struct rusage before, after;
  const std::string line = "sphere diffuse .5 .5 .5 0.0185185 0.470715 0.470715 0.598245\n";
  std::string text;
  for (int i = 0; i < 500; ++i) text += line;
  const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                     ("rayshade-long-" + std::to_string(getpid()) + ".ray");
  {
    std::ofstream out(file);
    for (int i = 0; i < 400; ++i) out << text;
  }
  Counting sink;
  Diagnostics diagnostics("rs");
  Options options;
  options.input = file;
  getrusage(RUSAGE_SELF, &before);
  EXPECT_TRUE(ParseScene(options, &diagnostics, &sink));
  getrusage(RUSAGE_SELF, &after);
  std::filesystem::remove(file);
  EXPECT_EQ(sink.count, 200000);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 4096) << "kB";
}

TEST_F(InputText, VerboseTellsOfNamedObjectsWhileItIsRead) {
  Options options;
  options.verbose = true;
  options.report_file = Write("report.txt", "what was there before");
  const std::string file =
      Write("named.ray",
            "name a list sphere 1 0 0 0 box 0 0 0 1 1 1 end\nname b object a\n"
            "name c union object b torus 2 1 0 0 0 0 0 1 end\nname d sphere 0 "
            "0 0 0\nname e heightfield " +
                Write("hf", std::string("\2\0\0\0", 4) + std::string(16, '\0')) + "\nobject c\n");
  EXPECT_TRUE(ReadFile(file, options).good);
  std::ifstream report(options.report_file);
  const std::string text{std::istreambuf_iterator<char>(report), {}};
  EXPECT_EQ(text,
            "Reading input file...\nlist \"a\":\n\t2 primitives\ninstance \"b\":\n\t2 primitives\n"
            "csg \"c\":\n\t3 primitives\nheighfield \"e\":\n\t1 primitive \n");
  options.report_file = "/nonexistent/report.txt";
  const Reading refused = ReadFile(file, options);
  EXPECT_EQ(refused.messages, "rs: Fatal error: Cannot open stats file /nonexistent/report.txt.\n");
  EXPECT_EQ(refused.status, 2);
}

}  // namespace
}  // namespace rayshade
