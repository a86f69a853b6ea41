// Report lines [rayshade4/1 s.11] and the progress bar.
#include "rayshade/render/report.h"

#include <gtest/gtest.h>

#include <functional>

#include "rayshade/geom/spec.h"
#include "rayshade/render/progress.h"

namespace rayshade {
namespace {

std::string Written(const std::function<void(std::FILE*)>& write) {
  char* text = nullptr;
  size_t size = 0;
  std::FILE* stream = open_memstream(&text, &size);
  write(stream);
  std::fclose(stream);
  const std::string result(text, size);
  free(text);
  return result;
}

TEST(Report, FinishesOnlyRowsOfTheFrequencyAndNeverTheLast) {
  Settings settings;
  settings.width = settings.height = 40;
  settings.window = Window{0, 9, 12, 25};
  const PictureWindow window{0, 12, 9, 25};
  EXPECT_EQ(Written([&](std::FILE* f) {
              LineReport lines(settings, window, f);
              lines.Update(5, 100, {});
              lines.Update(14, 200, {});
            }),
            "Finished line 20 (200 rays)\n");
  settings.verbose = true;
  settings.report_frequency = 13;
  EXPECT_EQ(Written([&](std::FILE* f) {
              LineReport(settings, window, f).Update(14, 7, {1, .5});
            }),
            "Finished line 13 (7 rays, 1.50 sec, 1.50 split)\n");
}

TEST(Report, ListsOptionsAsTheOriginalDid) {
  Settings settings;
  const std::string text = Written([&](std::FILE* f) {
    ReportOptions(settings, PictureWindow{0, 0, 511, 511}, f);
  });
  EXPECT_EQ(text,
            "Rendering frame 0.\n"
            "Screen resolution: 512 x 512\n"
            "Image window: (0 - 511), (0 - 511).\n"
            "Using jittered sampling, Max sampling rate 9 samples/pixel.\n"
            "Maximum contrast: 0.2 red, 0.15 green, 0.3 blue.\n"
            "Maximum ray depth: 5.  Cutoff thresh: 0.002 0.002 0.002.\n"
            "Object opacity affects depth of shadowing.\n");
}

TEST(Report, CountsRaysAndHits) {
  OpCounts counts;
  counts.primary_rays = 3;
  counts.shadow_rays = 1;
  counts.hits = 1;
  counts.shadow_hits = 1;
  const std::string text = Written([&](std::FILE* f) {
    ReportStatistics(counts, {}, {.25, .25}, 1000, f);
  });
  EXPECT_NE(text.find("Eye rays:\t\t\t3\n"), std::string::npos);
  EXPECT_EQ(text.find("not traced"), std::string::npos);
  counts.rays_saved = 1;
  const std::string saving = Written([&](std::FILE* f) {
    ReportStatistics(counts, {}, {.25, .25}, 1000, f);
  });
  EXPECT_NE(saving.find("Total rays:\t\t\t4\nRays not traced:\t\t1\n"), std::string::npos);
  EXPECT_NE(text.find("Intersecting rays:\t\t2 (50.000%)\n"), std::string::npos);
  EXPECT_NE(text.find("Total CPU time (sec):\t\t0.50 (0.25u + 0.25s)\n"), std::string::npos);
  EXPECT_NE(text.find("Total memory allocated:\t\t1000 bytes\n"), std::string::npos);
}

TEST(Report, HasALineForEachKindThatWasTestedTheLastToAppearFirst) {
  const size_t sphere = GeomSpec(SphereSpec{}).index(), triangle = GeomSpec(TriangleSpec{}).index();
  const size_t smooth = GeomSpec(PhongTriangleSpec{}).index();
  const size_t field = GeomSpec(HeightfieldSpec{}).index(), box = GeomSpec(BoxSpec{}).index();
  OpCounts counts;
  counts.kinds[sphere] = {400, 100};
  counts.kinds[triangle] = {10, 2};
  counts.kinds[smooth] = {30, 3};
  counts.kinds[field] = {60, 15};
  const auto lines = [](const OpCounts& c, const std::vector<size_t>& kinds) {
    const std::string text = Written([&](std::FILE* f) { ReportStatistics(c, kinds, {}, 0, f); });
    const size_t begin = text.find("B.V. intersection tests:");
    return text.substr(begin, text.find("Total CPU") - begin);
  };
  EXPECT_EQ(lines(counts, {triangle, box, sphere, field}),
            "B.V. intersection tests:\t0\n"
            "Heighfield intersection tests:\t60 (15 hit, 25.000000%)\n"
            "Sphere intersection tests:\t400 (100 hit, 25.000000%)\n"
            "Triangle intersection tests:\t40 (5 hit, 12.500000%)\n"
            "Total prim. intersection tests:\t500 (120 hit, 24.000000%)\n");
  EXPECT_EQ(lines({}, {sphere}),
            "B.V. intersection tests:\t0\nTotal prim. intersection tests:\t0\n");
}

TEST(Progress, ShowsRateAndTimeLeft) {
  EXPECT_EQ(Progress::Line(12, .25, 14400000),
            "[#######                       ]  25%    1.20 M rays/s  0:36 left");
  EXPECT_NE(Progress::Line(0, 0, 0).find("-:-- left"), std::string::npos);
}

}  // namespace
}  // namespace rayshade
