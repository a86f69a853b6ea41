// The command line, and who wins against the file [rayshade4/1 s.6, 14.6].
#include "rayshade/scene/options.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rayshade/scene/merge_settings.h"
#include "tests/support/recording_sink.h"

namespace rayshade {
namespace {

struct Said {
  OptionsResult result;
  std::string out, err;
  const Options& options() const { return *result.options; }
};

Said Say(const std::vector<std::string>& words, const std::vector<LongOption>& own = {}) {
  std::vector<const char*> argv{"rs"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Said said{ParseOptions(static_cast<int>(argv.size()), argv.data(), own), "", ""};
  std::fflush(stdout);
  said.out = testing::internal::GetCapturedStdout();
  said.err = testing::internal::GetCapturedStderr();
  return said;
}

// Settings of a scene with a ball and `text`, rendered with these options.
Settings Merged(const std::vector<std::string>& words, const std::string& text) {
  const Reading r = ReadText(text + " sphere 1 0 0 0", Say(words).options());
  EXPECT_EQ(r.sink.settings.size(), 1u) << r.messages;
  return r.sink.settings.empty() ? Settings() : r.sink.settings[0];
}

TEST(Options, AreAsInTheOriginalWhereNothingIsSaid) {
  const Settings s = Merged({}, "");
  EXPECT_EQ(s.eye, (Vector{0, -10, 0}));
  EXPECT_EQ(s.up, (Vector{0, 0, 1}));
  EXPECT_EQ(s.hfov, 45);
  EXPECT_EQ(s.width, 512);
  EXPECT_EQ(s.samples, 3);
  EXPECT_TRUE(s.jitter);
  EXPECT_EQ(s.contrast, (Color{.2, .15, .3}));
  EXPECT_EQ(s.cutoff, (Color{.002, .002, .002}));
  EXPECT_EQ(s.max_depth, 5);
  EXPECT_EQ(s.report_frequency, 10);
  EXPECT_TRUE(s.shadows);
  EXPECT_FALSE(s.focal_distance);
}

TEST(Options, WinAgainstTheFile) {
  const Settings s =
      Merged({"-R",  "60", "40", "-D", "2",  "-S",  "4",  "-C", "1",   "2",      "3",  "-T", ".1",
              ".2",  ".3", "-E", "7",  "-N", "2.9", "-A", "-1", "-F",  "0",      "-X", "0",  ".5",
              ".25", "1",  "-W", "1",  "2",  "3",   "4",  "-G", "2.2", "--seed", "99"},
             "screen 1 2 maxdepth 9 sample 7 cutoff 5 contrast 1 1 1 eyesep 3 frames 8 "
             "report 7 crop 0 1 0 1 window 0 9 0 9");
  EXPECT_EQ(s.width, 60);
  EXPECT_EQ(s.height, 40);
  EXPECT_EQ(s.max_depth, 2);
  EXPECT_EQ(s.samples, 4);
  EXPECT_EQ(s.cutoff, (Color{1, 2, 3}));
  EXPECT_EQ(s.contrast, (Color{.1, .2, .3}));
  EXPECT_EQ(s.eye_separation, 7);
  EXPECT_EQ(s.frames, 2);
  EXPECT_EQ(s.first_frame, -1);
  EXPECT_EQ(s.report_frequency, 1);
  EXPECT_EQ(s.crop.right, .5);
  EXPECT_EQ(s.crop.low, .25);
  EXPECT_EQ(s.window->ymax, 4);
  EXPECT_EQ(s.gamma, 2.2);
  EXPECT_EQ(s.seed, 99u);
}

TEST(Options, GaussianFilterGivesWayToTheFile) {
  EXPECT_EQ(Merged({"-g"}, "").filter, FilterKind::kGauss);
  EXPECT_EQ(Merged({"-g"}, "").filter_width_used(), 1.8);
  EXPECT_EQ(Merged({"-g"}, "filter box").filter, FilterKind::kBox);
  EXPECT_EQ(Merged({"-g", "-g"}, "").filter, FilterKind::kBox);
  EXPECT_EQ(Merged({}, "filter gauss 1.5 filter box").filter_width_used(), 1.5);
}

TEST(Options, ShadowTransparencyIsToggledByBothSides) {
  EXPECT_TRUE(Merged({}, "").shadow_transparency);
  EXPECT_FALSE(Merged({"-o"}, "").shadow_transparency);
  EXPECT_FALSE(Merged({}, "shadowtransp").shadow_transparency);
  EXPECT_TRUE(Merged({"-o"}, "shadowtransp").shadow_transparency);
}

TEST(Options, QualityStandsBetweenTheFileAndTheSingleOptions) {
  const std::string file = "sample 2 nojitter contrast .9 .9 .9 maxdepth 9 cutoff .1";
  const Settings as_written = Merged({}, file);
  EXPECT_EQ(as_written.pattern, SamplePattern::kRayshade);
  EXPECT_EQ(as_written.area_cells, 0);
  EXPECT_EQ(as_written.light_cutoff, 0);
  EXPECT_FALSE(as_written.every_pixel_full);
  const Settings rayshade = Merged({"--quality", "rayshade"}, file);
  EXPECT_EQ(rayshade.samples, 2);
  EXPECT_FALSE(rayshade.jitter);
  EXPECT_EQ(rayshade.pattern, SamplePattern::kRayshade);

  const Settings draft = Merged({"--quality", "draft"}, file);
  EXPECT_EQ(draft.samples, 1);
  EXPECT_LT(draft.max_depth, 9);
  EXPECT_GE(draft.cutoff.r, as_written.cutoff.r);
  EXPECT_EQ(Merged({"--quality", "draft"}, "maxdepth 1").max_depth, 1);
  const Settings fine = Merged({"--quality=fine"}, file);
  EXPECT_EQ(fine.samples, 4);
  EXPECT_TRUE(fine.jitter);
  EXPECT_EQ(fine.pattern, SamplePattern::kLowDiscrepancy);
  EXPECT_EQ(fine.max_depth, 9);
  const Settings reference = Merged({"--quality", "reference"}, file);
  EXPECT_EQ(reference.samples, 8);
  EXPECT_TRUE(reference.every_pixel_full);
  EXPECT_EQ(reference.cutoff, Color{});
  EXPECT_EQ(reference.area_cells, 0);

  const Settings single = Merged(
      {"-S", "3", "--quality", "fine", "-T", ".5", ".5", ".5", "-D", "2", "-C", "0", "0", "0"},
      file);
  EXPECT_EQ(single.samples, 3);
  EXPECT_EQ(single.contrast, (Color{.5, .5, .5}));
  EXPECT_EQ(single.max_depth, 2);
  EXPECT_EQ(single.cutoff, Color{});
  EXPECT_EQ(single.pattern, SamplePattern::kLowDiscrepancy);
}

TEST(Options, QualityOfAnotherNameIsSaid) {
  const Said said = Say({"--quality", "best"});
  EXPECT_EQ(said.result.status, 2);
  EXPECT_NE(said.err.find("draft, rayshade, fine or reference, not \"best\""), std::string::npos);
}

TEST(Options, ActFromLeftToRight) {
  EXPECT_TRUE(Merged({"-p"}, "sample 4 nojitter maxdepth 7").jitter);
  EXPECT_EQ(Merged({"-p"}, "sample 4 nojitter maxdepth 7").max_depth, 0);
  EXPECT_EQ(Merged({"-p"}, "sample 4 nojitter maxdepth 7").samples, 1);
  EXPECT_FALSE(Merged({"-p"}, "").shadows);
  EXPECT_FALSE(Merged({"-p", "-j"}, "sample 2 jitter").jitter);
  EXPECT_TRUE(Merged({"-j", "-j"}, "sample 2 nojitter").jitter);
  EXPECT_FALSE(Merged({"-S", "2"}, "sample 4 nojitter").jitter);
  EXPECT_EQ(Merged({"-j"}, "sample 4 jitter").samples, 4);
  EXPECT_EQ(Merged({"-l", "-r"}, "").stereo, StereoEye::kRight);
  EXPECT_TRUE(Merged({"-n", "-n"}, "").shadows);
}

TEST(Options, OutputFileOfTheCommandLineWinsWithAWarning) {
  const Reading r = ReadText("outfile other.ppm sphere 1 0 0 0", Say({"-O", "mine.png"}).options());
  EXPECT_EQ(r.messages, "rs: Warning: stdin, line 1: Ignoring output file name \"other.ppm\".\n");
  EXPECT_EQ(r.sink.settings.at(0).output, "mine.png");
}

TEST(Options, MinusOneInTheFileCountsAsNothingSaid) {
  const Settings s = Merged({}, "sample -1 contrast -1 0 0 cutoff -1 eyesep -1 focaldist -1");
  EXPECT_EQ(s.samples, 3);
  EXPECT_EQ(s.contrast, (Color{.2, .15, .3}));
  EXPECT_EQ(s.cutoff, (Color{.002, .002, .002}));
  EXPECT_FALSE(s.eye_separation);
  EXPECT_FALSE(s.focal_distance);
  EXPECT_EQ(Merged({}, "maxdepth -4").max_depth, 0);
}

TEST(Options, OnlyTheLetterAfterTheDashCounts) {
  EXPECT_TRUE(Say({"-verbose"}).options().verbose);
  EXPECT_FALSE(Say({"-vq"}).options().quiet);
}

TEST(Options, ThoseOfTheRleBuildAreKnown) {
  const Options o = Say({"-a", "-c", "-e", "-m", "-s"}).options();
  EXPECT_TRUE(o.alpha);
  EXPECT_TRUE(o.continue_picture);
  EXPECT_TRUE(o.sample_map);
}

TEST(Options, UnknownOnesAreBadArguments) {
  const Said said = Say({"-O", "x.png", "-Z", "scene.ray"});
  EXPECT_FALSE(said.result.options);
  EXPECT_EQ(said.result.status, 2);
  EXPECT_EQ(said.err, "rs: Fatal error: Bad argument: -Z\n");
  EXPECT_EQ(Say({"-"}).result.status, 2);
  EXPECT_EQ(Say({"--nosuch"}).err, "rs: Fatal error: Bad argument: --nosuch\n");
}

TEST(Options, MissingAndSenselessArgumentsAreSaid) {
  EXPECT_EQ(Say({"-R", "60"}).result.status, 2);
  EXPECT_NE(Say({"-R", "60"}).err.find("Option -R needs an argument"), std::string::npos);
  EXPECT_NE(Say({"-R", "60x40", "scene"}).err.find("not \"60x40\""), std::string::npos);
  EXPECT_EQ(Say({"--seed", "-1"}).result.status, 2);
  EXPECT_EQ(Say({"-V", "-q"}).result.status, 2);
}

TEST(Options, TwoInputFilesPrintTheUsage) {
  const Said said = Say({"a.ray", "b.ray"});
  EXPECT_EQ(said.result.status, 1);
  EXPECT_NE(said.err.find("usage: rs [options] [filename]"), std::string::npos);
}

TEST(Options, HelpNamesEveryOption) {
  for (const char* word : {"-h", "--help"}) {
    const Said said = Say({word}, {{"processes", "N", "number of trace processes"}});
    EXPECT_EQ(said.result.status, 0);
    EXPECT_FALSE(said.result.options);
    for (const char letter : std::string("ACDEFGNOPRSTVWXacefghjlmnopqrsuv")) {
      EXPECT_NE(said.out.find(std::string("-") + letter), std::string::npos) << letter;
    }
    EXPECT_NE(said.out.find("--processes N"), std::string::npos);
    EXPECT_NE(said.out.find("--seed N"), std::string::npos);
    EXPECT_NE(said.out.find("--quality NAME"), std::string::npos);
    EXPECT_NE(said.out.find("--stats FILE"), std::string::npos);
  }
}

TEST(Options, AProgramsOwnLongOnesAreLeftToIt) {
  const std::vector<LongOption> own{
      {"processes", "N", ""}, {"compare", "PROGRAM?", ""}, {"fast", "", ""}};
  const Options o =
      Say({"--processes", "4", "--compare", "--compare=rs", "--fast", "in.ray"}, own).options();
  const std::vector<std::pair<std::string, std::string>> expected{
      {"processes", "4"}, {"compare", ""}, {"compare", "rs"}, {"fast", ""}};
  EXPECT_EQ(o.extra, expected);
  EXPECT_EQ(o.input, "in.ray");
  EXPECT_EQ(Say({"--fast=1"}, own).result.status, 2);
  EXPECT_EQ(Say({"--processes"}, own).result.status, 2);
}

}  // namespace
}  // namespace rayshade
