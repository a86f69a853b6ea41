// PixelSampling against the rule written down plainly, and the plain rule against the counts of the
// original [rayshade4/1 s.14.1].
#include "rayshade/render/pixel_sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <set>

#include "rayshade/common/keyed_random.h"
#include "tests/render/plain_sampler.h"

namespace rayshade {
namespace {

// The original's stream: drand48 of seed 1, after the noise table took its share [rayshade4/1 s.9].
class OriginalStream {
 public:
  OriginalStream() {
    for (int i = 0; i < 4095; ++i) Draw();
  }
  double Draw() {
    state_ = (state_ * 0x5DEECE66Du + 0xB) & ((uint64_t{1} << 48) - 1);
    return static_cast<double>(state_) * 0x1.0p-48;
  }

 private:
  uint64_t state_ = 0x00000001330E;
};

PlainSampler Original(const Settings& settings) {
  OriginalStream stream;
  return PlainSampler(
      settings, [&](int, int, int, RandomUse) { return stream.Draw(); }, TraceTwoSpheres);
}

PlainSampler Keyed(const Settings& s) {
  return PlainSampler(
      s,
      [&](int x, int y, int sub_cell, RandomUse use) {
        return KeyedRandom(SampleKey(s.seed, 0, x, y, sub_cell), use);
      },
      TraceTwoSpheres);
}

struct Outcome {
  Picture picture;
  int eye_rays = 0;
  uint64_t supersampled = 0, speculative = 0;
  int waits = 0;  // times that nothing could be asked for before the results were in
};

// The results of up to `late` batches of samples come in any order.
Outcome Sampled(const Settings& settings, size_t most, bool ahead = false, size_t late = 1) {
  const Camera camera(settings, 0);
  PixelSampling sampling(settings, camera, ahead);
  Outcome run{sampling.picture(), 0, 0, 0, 0};
  std::vector<std::vector<Sample>> flying;
  std::mt19937 order(7);
  while (!sampling.done()) {
    std::vector<Sample> samples = sampling.Next(most);
    EXPECT_LE(samples.size(), most);
    run.eye_rays += static_cast<int>(samples.size());
    const bool more = !samples.empty();
    if (more) flying.push_back(std::move(samples));
    if (!more) ++run.waits;
    if (more && flying.size() < late) continue;
    if (flying.empty()) {
      ADD_FAILURE() << "nothing to do";
      break;
    }
    std::swap(flying[order() % flying.size()], flying.back());
    std::vector<Sample> back = std::move(flying.back());
    flying.pop_back();
    std::shuffle(back.begin(), back.end(), order);
    for (const Sample& s : back) sampling.Put(s, TraceTwoSpheres(camera.PrimaryRay(s)));
  }
  run.picture = sampling.picture();
  run.supersampled = sampling.supersampled_pixels();
  run.speculative = sampling.speculative_samples();
  return run;
}

bool Same(const Picture& picture, const PlainSampler& plain) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      if (!(picture.at(x, y).color == plain.at(x, y))) return false;
    }
  }
  return true;
}

Settings Base(int samples, bool jitter) {
  Settings settings = TwoSpheresSettings(64, 48);
  settings.samples = samples;
  settings.jitter = jitter;
  return settings;
}

TEST(PlainSampler, CountsAsTheOriginalDid) {
  struct Case {
    Settings settings;
    int eye_rays, supersampled;
  };
  Settings gauss = Base(3, true), narrow = Base(4, true), wide = Base(3, true),
           none = Base(3, true), all = Base(3, true), green = Base(3, true);
  gauss.filter = narrow.filter = FilterKind::kGauss;
  narrow.filter_width = 2.5;
  wide.filter_width = 2;
  none.contrast = {1, 1, 1};
  all.contrast = {0, 0, 0};
  green.contrast = {.9, .9, .1};
  const Case cases[] = {
      {Base(1, false), 3136, 222}, {Base(1, true), 3136, 222}, {Base(3, true), 9048, 739},
      {gauss, 9384, 781},          {narrow, 15451, 821},       {wide, 9560, 803},
      {none, 4912, 222},           {all, 14416, 1410},         {green, 8712, 697}};
  for (const Case& c : cases) {
    const PlainSampler plain = Original(c.settings);
    EXPECT_EQ(plain.eye_rays(), c.eye_rays);
    EXPECT_EQ(plain.supersampled(), c.supersampled);
  }
}

TEST(PixelSampling, TakesOneSampleForEachPixelAndTheRowBelow) {
  const Outcome run = Sampled(Base(1, false), 1024);
  EXPECT_EQ(run.eye_rays, 3136);
  EXPECT_EQ(run.supersampled, 222u);
  EXPECT_TRUE(Same(run.picture, Original(Base(1, false))));
  EXPECT_TRUE(run.picture.at(5, 0).full);
  EXPECT_FALSE(run.picture.at(5, 1).full);
}

TEST(PixelSampling, HandsOutTilesForOneSample) {
  const Settings settings = Base(1, false);
  const Camera camera(settings, 0);
  PixelSampling sampling(settings, camera, false);
  const std::vector<Sample> samples = sampling.Next(64);
  std::set<std::pair<int, int>> places;
  for (const Sample& s : samples) places.insert({s.x, s.y});
  EXPECT_EQ(places.size(), 64u);
  EXPECT_EQ(*places.rbegin(), std::make_pair(7, 7));
}

TEST(PixelSampling, SupersamplesOnlyTheBorderWhereContrastNeverFires) {
  Settings settings = Base(3, true);
  settings.contrast = {1, 1, 1};
  const Outcome run = Sampled(settings, 1024);
  EXPECT_EQ(run.eye_rays, 4912);
  EXPECT_EQ(run.supersampled, 222u);
}

TEST(PixelSampling, TreatsSmallPicturesByTheSameRule) {
  const int cases[][4] = {{1, 1, 18, 2}, {1, 5, 54, 6},   {5, 1, 66, 7},
                          {2, 2, 54, 6}, {3, 3, 108, 12}, {7, 4, 315, 35}};
  for (const auto& c : cases) {
    const Settings settings = TwoSpheresSettings(c[0], c[1]);
    for (const bool ahead : {false, true}) {
      const Outcome run = Sampled(settings, 64, ahead);
      EXPECT_EQ(run.eye_rays, c[2]) << c[0] << " x " << c[1];
      EXPECT_EQ(run.supersampled, uint64_t(c[3])) << c[0] << " x " << c[1];
      EXPECT_TRUE(Same(run.picture, Keyed(settings)));
    }
  }
}

TEST(PixelSampling, AsksForExactlyTheSamplesOfTheRule) {
  for (int n = 2; n <= 8; ++n) {
    for (const bool jitter : {false, true}) {
      const Settings settings = Base(n, jitter);
      const PlainSampler plain = Keyed(settings);
      const Outcome run = Sampled(settings, 1024);
      EXPECT_EQ(run.eye_rays, plain.eye_rays());
      EXPECT_EQ(run.supersampled, uint64_t(plain.supersampled()));
      EXPECT_EQ(run.speculative, 0u);
      EXPECT_TRUE(Same(run.picture, plain)) << n;
    }
  }
}

TEST(PixelSampling, MakesTheSamePictureAheadWithFewSamplesInVain) {
  for (const int n : {2, 3, 5}) {
    Settings settings = Base(n, true);
    settings.width = 160;
    settings.height = 120;
    const PlainSampler plain = Keyed(settings);
    for (const size_t most : {1, 64, 1024}) {
      const Outcome run = Sampled(settings, most, true, 8);
      EXPECT_TRUE(Same(run.picture, plain)) << n;
      EXPECT_EQ(run.supersampled, uint64_t(plain.supersampled()));
      EXPECT_LE(run.speculative, .1 * run.eye_rays);
      EXPECT_LE(run.eye_rays, plain.eye_rays() + int(run.speculative));
      EXPECT_LE(run.waits, 60) << "round trips in which nothing was under way but one pixel";
    }
  }
}

TEST(PixelSampling, GoesOnToTheSamePictureAfterBeingCutShort) {
  for (const int n : {1, 3}) {
    const Settings settings = Base(n, true);
    const Camera camera(settings, 0);
    const PlainSampler plain = Keyed(settings);
    for (const int cut : {0, 1, 3, 8, 40, 90}) {
      std::string saved;
      PixelSampling first(settings, camera, false);
      for (int i = 0; i < cut && !first.done(); ++i) {
        for (const Sample& s : first.Next(100)) {
          first.Put(s, TraceTwoSpheres(camera.PrimaryRay(s)));
        }
      }
      PixelSampling second(settings, camera, false);
      ASSERT_TRUE(second.Restore(first.Save()));
      while (!second.done()) {
        for (const Sample& s : second.Next(100)) {
          second.Put(s, TraceTwoSpheres(camera.PrimaryRay(s)));
        }
      }
      EXPECT_TRUE(Same(second.picture(), plain)) << n << " cut at " << cut;
      EXPECT_EQ(second.supersampled_pixels(), uint64_t(plain.supersampled()));
    }
  }
}

TEST(PixelSampling, TakesSamplesSideBySideTogether) {
  for (const int n : {1, 3}) {
    const Settings settings = Base(n, true);
    const Camera camera(settings, 0);
    PixelSampling one_by_one(settings, camera, false), by_runs(settings, camera, false);
    while (!by_runs.done()) {
      const std::vector<Sample> samples = by_runs.Next(100);
      ASSERT_EQ(one_by_one.Next(100), samples);
      for (size_t begin = 0, end; begin < samples.size(); begin = end) {
        const Sample& first = samples[begin];
        const RayResult result{{0.01 * first.x, 0.02 * first.y, 1}, 5, first.x % 3 != 0};
        Sample next = first;
        for (end = begin; end < samples.size() && samples[end] == next; ++end, ++next.x)
          one_by_one.Put(next, result);
        by_runs.PutRun(first, static_cast<int>(end - begin), result);
      }
      ASSERT_EQ(by_runs.rows_done(), one_by_one.rows_done());
    }
    EXPECT_TRUE(one_by_one.done());
    EXPECT_EQ(by_runs.Save(), one_by_one.Save());
    EXPECT_EQ(by_runs.supersampled_pixels(), one_by_one.supersampled_pixels());
  }
}

TEST(PixelSampling, RefusesASavedStateThatIsCutShortItself) {
  for (const int n : {1, 3}) {
    const Settings settings = Base(n, true);
    const Camera camera(settings, 0);
    PixelSampling sampling(settings, camera, false);
    while (!sampling.done()) {
      for (const Sample& s : sampling.Next(1024)) sampling.Put(s, {});
    }
    const std::string bytes = sampling.Save();
    PixelSampling other(settings, camera, false);
    EXPECT_FALSE(other.Restore(bytes.substr(0, bytes.size() - 1)));
    EXPECT_FALSE(other.Restore(""));
  }
}

}  // namespace
}  // namespace rayshade
