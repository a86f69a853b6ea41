// --quality is as exact in parallel as everything else: the same picture and the same rays by every
// schedule, whatever it picks.
#include "rayshade/scene/quality.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <tuple>

#include "tests/support/parallel_run.h"

namespace rayshade::parallel {
namespace {

// Everything that a pattern or a share of the light decides: an area light, an extended one, gloss,
// lens and shutter.
const char kText[] =
    "screen 24 24\neyep 1 -8 3\nlookp 0 0 .5\nfov 30\naperture .05\nshutter .5\nmaxdepth 6\n"
    "light .5 area -2 -3 4 1 -3 4 5 -2 -1 4 4\nlight .3 area 2 -3 3 3 -3 3 2 2 -3 4 2\n"
    "light .4 extended .5 3 -3 4\nlight .05 point -4 -4 2\n"
    "surface floor ambient .1 .1 .1 diffuse .6 .6 .5\n"
    "surface steel diffuse .1 .1 .1 specular .8 .8 .8 specpow 40 reflect .7\n"
    "surface paper diffuse .5 .4 .3 translucency .5 .4 .4 .4 8\n"
    "surface glass specular .6 .6 .6 specpow 60 reflect .1 transp .9 index 1.4\n"
    "plane floor 0 0 0 0 0 1\nsphere steel .7 -.9 .3 .7 texture gloss .7\n"
    "sphere glass .5 .6 -.8 .5\ndisc paper .6 0 -.6 1.6 .3 -1 .2\n"
    "sphere floor .2 0 0 0 translate (.3 * time) 0 .2\nsphere steel .2 1.5 .3 .2\n";

class SceneFile {
 public:
  SceneFile() {
    std::FILE* file = fdopen(mkstemp(name_), "w");
    std::fputs(kText, file);
    std::fclose(file);
  }
  ~SceneFile() { std::remove(name_); }
  std::string name() const { return name_; }

 private:
  char name_[30] = "/tmp/quality-test-XXXXXX";
};

Options At(Quality quality, const SceneFile& file) {
  Options options;
  options.program = "test";
  options.input = file.name();
  options.raw_input = true;
  options.quality = quality;
  return options;
}

class EveryQuality : public testing::TestWithParam<std::tuple<Quality, Schedule>> {};

TEST_P(EveryQuality, IsTheSamePictureInParallel) {
  const auto [quality, schedule] = GetParam();
  const SceneFile file;
  const Options options = At(quality, file);
  const TestPicture sequential = RenderSequentially(options);
  for (const int processes : {1, 5}) {
    ObjectSpool spool;
    ParseInto(options, &spool);
    RunOptions run;
    run.schedule = schedule;
    run.processes = static_cast<uint16_t>(processes);
    run.cell_bytes = 600;
    run.pyramid = 64;
    const TestPicture parallel = RenderInParallel(&spool, 0, run, processes);
    EXPECT_TRUE(Identical(sequential.picture, parallel.picture)) << processes << " processes";
    // Rays that the adaptive rule has traced ahead in vain are counted too.
    if (parallel.counts.primary_rays != sequential.counts.primary_rays) continue;
    EXPECT_EQ(sequential.counts.shadow_rays, parallel.counts.shadow_rays);
    EXPECT_EQ(sequential.counts.rays_saved, parallel.counts.rays_saved);
    EXPECT_EQ(sequential.counts.hits, parallel.counts.hits);
  }
}

INSTANTIATE_TEST_SUITE_P(Schedules, EveryQuality,
                         testing::Combine(testing::Values(Quality::kDraft, Quality::kRayshade,
                                                          Quality::kFine, Quality::kReference),
                                          testing::Values(Schedule::kDataParallel,
                                                          Schedule::kDemandDriven,
                                                          Schedule::kHybrid)));

TEST(Quality, EachOneIsAnotherPictureWithMoreRays) {
  const SceneFile file;
  uint64_t rays = 0;
  for (const Quality quality :
       {Quality::kDraft, Quality::kRayshade, Quality::kFine, Quality::kReference}) {
    const TestPicture picture = RenderSequentially(At(quality, file));
    EXPECT_GT(picture.counts.total_rays(), rays);
    rays = picture.counts.total_rays();
  }
}

TEST(Quality, ReferenceSamplesEveryPixelInFull) {
  const SceneFile file;
  const TestPicture picture = RenderSequentially(At(Quality::kReference, file));
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) EXPECT_TRUE(picture.picture.at(x, y).full) << x << " " << y;
  }
  // And those of the row below the picture.
  EXPECT_EQ(picture.counts.primary_rays, 24u * 25 * 64);
}

}  // namespace
}  // namespace rayshade::parallel
