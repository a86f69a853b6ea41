// Camera [rayshade4/1 s.7, 8.4-8.6, 14.6].
#include "rayshade/render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>
#include <set>
#include <vector>

#include "rayshade/accel/trace_view.h"
#include "rayshade/common/keyed_random.h"
#include "rayshade/common/sample_pattern.h"
#include "rayshade/render/sample_numbers.h"
#include "tests/support/kernels.h"

namespace rayshade {
namespace {

Settings Small(int width, int height) {
  Settings settings;
  settings.width = width;
  settings.height = height;
  settings.samples = 1;
  settings.jitter = false;
  return settings;
}

PictureWindow WindowOf(const Settings& settings) { return Camera(settings, 0).window(); }

TEST(Camera, CropsInsideTheWindow) {
  Settings settings = Small(10, 10);
  settings.window = Window{2, 7, 1, 8};
  settings.crop = {.8, .2, -1, 1.5};
  EXPECT_EQ(WindowOf(settings).minx, 3);
  EXPECT_EQ(WindowOf(settings).maxx, 6);
  EXPECT_EQ(WindowOf(settings).miny, 1);
  EXPECT_EQ(WindowOf(settings).maxy, 8);
}

TEST(Camera, ShootsThroughTheLowCornerOfAPixel) {
  const Camera camera(Small(8, 8), 0);
  // The optical axis meets the screen at (4, 4), the centre of pixel 4: half a pixel from its
  // corner.
  const Ray ray = camera.PrimaryRay({4, 4, 0, true});
  const double half_pixel = std::tan(22.5 * kPi / 180) / 8;
  EXPECT_NEAR(ray.direction.x / ray.direction.y, -half_pixel, 1e-12);
  EXPECT_NEAR(ray.direction.z / ray.direction.y, half_pixel, 1e-12);
  EXPECT_EQ(ray.origin, (Vector{0, -10, 0}));
}

TEST(Camera, SeesAPointWhereItsRayGoes) {
  Settings settings = Small(40, 30);
  settings.eye = {3, -8, 2};
  settings.look = {1, 0, .5};
  settings.window = Window{5, 30, 4, 28};
  const Camera camera(settings, 0);
  for (const Sample& sample : {Sample{0, 0, 0, true}, Sample{25, 3, 0, true}, {7, 24, 0, true}}) {
    const Ray ray = camera.PrimaryRay(sample);
    const double half = .5 * settings.filter_width_used();  // a ray is half a pixel off
    const Vector at = camera.Project(ray.origin + 3.5 * ray.direction);
    EXPECT_NEAR(at.x, sample.x - half, 1e-9);
    EXPECT_NEAR(at.y, sample.y - half, 1e-9);
    EXPECT_GT(at.z, 0);
    EXPECT_LT(camera.Project(ray.origin - 3.5 * ray.direction).z, 0);
  }
  EXPECT_NEAR(camera.Project(settings.look).z, 1, 1e-12);
}

TEST(Camera, CroppingDoesNotChangeTheRaysThatAreKept) {
  Settings whole = Small(20, 20), cropped = Small(20, 20);
  whole.jitter = cropped.jitter = true;
  cropped.window = Window{5, 15, 7, 18};
  EXPECT_EQ(Camera(whole, 0).PrimaryRay({9, 11, 0, true}).direction,
            Camera(cropped, 0).PrimaryRay({4, 4, 0, true}).direction);
}

TEST(Camera, LowDiscrepancySamplesStayInTheirSubCellsAndCarryTheirPixelsShift) {
  Settings settings = Small(8, 8);
  settings.samples = 4;
  settings.jitter = true;
  settings.pattern = SamplePattern::kLowDiscrepancy;
  const Camera camera(settings, 0);
  const double pixel = 2 * std::tan(22.5 * kPi / 180) / 8;
  std::set<uint32_t> shifts;
  std::set<int> columns;
  for (uint16_t i = 0; i < 16; ++i) {
    const Ray ray = camera.PrimaryRay({4, 4, i, false});
    // In pixels, from the pixel's low corner.
    const double x = .5 + ray.direction.x / ray.direction.y / pixel;
    EXPECT_EQ(static_cast<int>(x * 4), i % 4);
    columns.insert(static_cast<int>(x * 16));
    shifts.insert(ray.sample_number >> 8);
    EXPECT_EQ(NumberOf(ray.sample_number), static_cast<uint32_t>(SampleNumber(4, i)));
  }
  EXPECT_EQ(columns.size(), 16u);
  EXPECT_EQ(shifts.size(), 1u);
}

TEST(Camera, LowDiscrepancyNumbersBeginAtZeroForEveryN) {
  Settings settings = Small(8, 8);
  settings.pattern = SamplePattern::kLowDiscrepancy;
  for (settings.samples = 1; settings.samples <= 8; ++settings.samples) {
    std::set<uint32_t> numbers;
    const int cells = settings.samples * settings.samples;
    for (int i = 0; i < cells; ++i) {
      const Ray ray = Camera(settings, 0).PrimaryRay({1, 1, static_cast<uint16_t>(i), false});
      numbers.insert(NumberOf(ray.sample_number));
    }
    EXPECT_EQ(numbers.size(), size_t(cells));
    EXPECT_EQ(*numbers.rbegin(), uint32_t(cells - 1));
  }
}

TEST(Camera, AppendsTheRaysThatItGivesOneByOne) {
  Settings settings = Small(40, 30);
  settings.jitter = true;
  settings.seed = 7;
  settings.shutter = .5;
  for (double aperture : {0., .25}) {
    settings.aperture = aperture;
    for (settings.samples = 1; settings.samples <= 4; settings.samples += 3) {
      const Camera camera(settings, 2);
      std::vector<Sample> samples;
      for (int i = 0; i < 150; ++i) {
        const auto cell = static_cast<uint16_t>(i % (settings.samples * settings.samples));
        samples.push_back({i % 40, i / 5, cell, i % 2 == 0});
      }
      std::vector<Ray> rays(1);  // one is there already
      camera.AppendPrimaryRays(samples, &rays);
      ASSERT_EQ(rays.size(), samples.size() + 1);
      for (size_t i = 0; i < samples.size(); ++i) {
        const Ray one = camera.PrimaryRay(samples[i]), &ray = rays[i + 1];
        EXPECT_EQ(ray.origin, one.origin);
        EXPECT_EQ(ray.direction, one.direction);
        EXPECT_EQ(ray.time, one.time);
        EXPECT_EQ(ray.key, SampleKey(7, 2, samples[i].x, samples[i].y, samples[i].sub_cell));
        EXPECT_EQ(ray.sample_number, one.sample_number);
      }
    }
  }
}

TEST(Camera, TurnsTheEyesTowardsTheLookPoint) {
  Settings settings = Small(8, 8);
  settings.stereo = StereoEye::kLeft;
  settings.eye_separation = 2;
  EXPECT_EQ(Camera(settings, 0).eye(), (Vector{-1, -10, 0}));
  settings.stereo = StereoEye::kRight;
  EXPECT_EQ(Camera(settings, 0).eye(), (Vector{1, -10, 0}));
}

TEST(Camera, SpreadsSampleTimesOverTheShutterInterval) {
  Settings settings = Small(8, 8);
  settings.samples = 3;
  settings.shutter = .9;
  settings.start_time = 5;
  const Camera camera(settings, 2);
  // Sub-cell 2 of 3 x 3 has number 7.
  EXPECT_NEAR(camera.PrimaryRay({1, 1, 2, false}).time, 7 + 7 * .1, 1e-12);
  EXPECT_EQ(camera.PrimaryRay({1, 1, 2, false}).sample_number, 7u);
}

TEST(Camera, FreezesMotionAtTheEndOfTheShutterIntervalAsTheOriginalDid) {
  Settings settings = Small(8, 8);
  settings.shutter = 1;
  settings.frames = 2;
  const Sample sample{3, 3, 0, true};
  EXPECT_EQ(Camera(settings, 0).PrimaryRay(sample).time, 1);
  EXPECT_EQ(Camera(settings, 1).PrimaryRay(sample).time, 1);
  settings.start_time = .2;
  EXPECT_EQ(Camera(settings, 0).PrimaryRay(sample).time, .2);
}

TEST(Camera, FocusesOnASphereThroughASquareLens) {
  Settings settings = Small(64, 64);
  settings.samples = 4;
  settings.aperture = .5;
  settings.focal_distance = 6;
  const Camera lens(settings, 0);
  settings.aperture = 0;
  const Camera pinhole(settings, 0);
  for (uint16_t cell = 0; cell < 16; ++cell) {
    const Sample sample{10, 20, cell, false};
    const Ray ray = lens.PrimaryRay(sample), straight = pinhole.PrimaryRay(sample);
    const Vector moved = ray.origin - straight.origin;
    EXPECT_LE(std::fabs(moved.x), .5);
    EXPECT_LE(std::fabs(moved.z), .5);
    const Vector focus = straight.origin + 6 * straight.direction;
    const Vector to_focus = focus - ray.origin;
    EXPECT_NEAR(Length(Cross(to_focus, ray.direction)), 0, 1e-12);
  }
}

TEST(SampleNumber, UsesEachNumberOnce) {
  for (int n = 1; n <= 8; ++n) {
    const int first = n >= 6 ? 1 : 0;
    std::vector<bool> used(n * n);
    for (int i = 0; i < n * n; ++i) {
      const int number = SampleNumber(n, i) - first;
      ASSERT_GE(number, 0);
      ASSERT_LT(number, n * n);
      EXPECT_FALSE(used[number]);
      used[number] = true;
    }
  }
}

TEST(CheckView, SaysWhatIsWrongInRayshadesWords) {
  EXPECT_EQ(CheckView(Small(8, 8)), "");
  Settings settings = Small(8, 8);
  settings.samples = 9;
  EXPECT_EQ(CheckView(settings), "Sorry, 81 rays/pixel not supported.");
  settings.samples = 0;
  EXPECT_EQ(CheckView(settings), "Sorry, 0 rays/pixel not supported.");
  settings = Small(8, 8);
  settings.eye = {0, 0, 5};
  EXPECT_EQ(CheckView(settings), "The view and up directions are identical?");
  settings.eye = {0, 0, 0};
  EXPECT_EQ(CheckView(settings), "The view and up directions are identical?");
  settings = Small(4, 4);
  settings.window = Window{0, 1, 0, 5};
  EXPECT_EQ(CheckView(settings), "Invalid window specification.");
  settings = Small(8, 8);
  settings.stereo = StereoEye::kLeft;
  EXPECT_EQ(CheckView(settings), "No eye separation specified for stereo rendering.");
}

// Directions of all sizes, also those that Normalize leaves as they are and those whose length is
// no finite number.
TEST(Camera, LooksAtPlacesAsOneByOne) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto some = [&] { return Vector{number(random), number(random), number(random)}; };
  for (const double size : {1.0, 1e5, 1e-6, 1e-12, 1e-200, 1e200}) {
    for (uint32_t count = 1; count <= 64; ++count) {
      const Vector corner = size * some(), steps[2] = {1e-2 * size * some(), 1e-2 * size * some()};
      std::vector<double> x(64), y(64);
      for (uint32_t i = 1; i < count; ++i) {
        x[i] = std::floor(1000 * number(random));
        y[i] = std::floor(1000 * number(random));
      }
      std::vector<Vector> expected;
      for (uint32_t i = 0; i < count; ++i) {
        expected.push_back(corner + x[i] * steps[0] + y[i] * steps[1]);
        Normalize(&expected[i]);
      }
      for (const char* simd : test::kAllKernels) {
        setenv("RAYSHADE_SIMD", simd, 1);
        double direction[3][64];
        ChooseKernels().look(
            {{x.data(), y.data()},
             count,
             {corner.x, corner.y, corner.z},
             {{steps[0].x, steps[0].y, steps[0].z}, {steps[1].x, steps[1].y, steps[1].z}},
             {direction[0], direction[1], direction[2]}});
        for (uint32_t i = 0; i < count; ++i) {
          const Vector got = {direction[0][i], direction[1][i], direction[2][i]};
          ASSERT_EQ(std::memcmp(&got, &expected[i], sizeof got), 0)
              << simd << " " << size << " " << i;
        }
        unsetenv("RAYSHADE_SIMD");
      }
    }
  }
}

TEST(Camera, MakesTheSameRaysTogetherAndAlone) {
  std::vector<Settings> all(5, Small(40, 30));
  all[1].jitter = true;
  all[2].samples = 3;
  all[3].aperture = .1;
  all[4].pattern = SamplePattern::kLowDiscrepancy;
  for (const Settings& settings : all) {
    const Camera camera(settings, 0);
    std::vector<Sample> samples;
    for (int32_t i = 0; i < 150; ++i) {
      const auto cell = static_cast<uint16_t>(i % (settings.samples * settings.samples));
      samples.push_back({i % 40, i / 5, cell, i % 2 == 0});
    }
    std::vector<Ray> together;
    camera.AppendPrimaryRays(samples, &together);
    ASSERT_EQ(together.size(), samples.size());
    for (size_t i = 0; i < samples.size(); ++i) {
      const Ray alone = camera.PrimaryRay(samples[i]), &ray = together[i];
      EXPECT_EQ(ray.origin, alone.origin);
      EXPECT_EQ(ray.direction, alone.direction);
      EXPECT_EQ(ray.time, alone.time);
      EXPECT_EQ(ray.key, alone.key);
      EXPECT_EQ(ray.key,
                SampleKey(settings.seed, 0, samples[i].x, samples[i].y, samples[i].sub_cell));
      EXPECT_EQ(ray.sample_number, alone.sample_number);
    }
  }
}

}  // namespace
}  // namespace rayshade
