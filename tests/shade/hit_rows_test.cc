// Lights added up in rows against AddLight, hit by hit and to the bit: also highlights so faint
// that the rows leave them out.
#include "rayshade/shade/hit_rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "tests/shade/text_scene.h"
#include "tests/support/kernels.h"
#include "tests/support/random.h"

namespace rayshade {
namespace {

using test::Random;
using test::RandomDirection;
using test::Uniform;

Color RandomColor(Random* random, double most) {
  const double r = Uniform(random, 0, most), g = Uniform(random, 0, most);
  return {r, g, Uniform(random, 0, most)};
}

constexpr size_t kCount = 500;
struct Hits {
  std::vector<Ray> rays{kCount};
  std::vector<Surface> materials{kCount};
  std::vector<SurfaceHit> surfaces{kCount};
  std::vector<uint32_t> owners;
};

// The mirror directions are near the edge of what a highlight leaves, or anywhere.
Hits MakeHits(Random* random, const Vector& light) {
  const double powers[] = {1e-3, 1, 8, 44, 46, 60, 200, 1e4, 1e6, 1e9, 1e18, 1e300};
  Hits hits;
  for (size_t i = 0; i < kCount; ++i) {
    Surface& material = hits.materials[i];
    material.specpow = powers[i % std::size(powers)];
    material.diffuse = RandomColor(random, i % 5 == 0 ? 1e-9 : 1);
    material.diffuse.r += 1e-12;
    if (i % 4 != 0) material.specular = RandomColor(random, i % 3 == 0 ? 1e6 : 1);
    SurfaceHit& hit = hits.surfaces[i];
    hit = {};
    hit.point = 3 * RandomDirection(random);
    hit.normal = hit.face = RandomDirection(random);
    hit.bound = &material;
    const Vector toward = Normalized(light - hit.point), across = Cross(toward, hit.normal);
    const double angle = std::sqrt(2 * std::min(1.0, Uniform(random, 0, 90) / material.specpow));
    const double cosine = i % 7 == 0 ? 1 : std::cos(i % 2 == 0 ? angle : 2 * angle);
    hit.mirror = cosine * toward + std::sqrt(1 - cosine * cosine) * Normalized(across);
    hits.owners.push_back(static_cast<uint32_t>(i));
  }
  return hits;
}

// Lights up random hits with the kernels of one name.
void Compare(const char* simd, Random* random) {
  const Vector at{0, 0, 8};
  setenv("RAYSHADE_SIMD", simd, 1);
  const test::TextScene text("light 0.7 0.9 1 point 0 0 8\nsphere 0.1 0 0 -90\n");
  unsetenv("RAYSHADE_SIMD");
  const Scene& scene = text.scene();
  const Hits hits = MakeHits(random, at);
  OpCounts counts;
  std::vector<Color> sums;
  for (size_t i = 0; i < kCount; ++i) sums.push_back(RandomColor(random, i % 11 == 0 ? 0 : 0.3));
  const std::vector<Color> before = sums;
  const auto rows = std::make_unique<HitRows>();
  rows->Set(scene, hits.rays, hits.surfaces, hits.owners, sums);
  rows->Trace(scene, text.objects(), *scene.lights[0], &counts);
  rows->AddUp(text.objects(), *scene.lights[0]);
  rows->Finish();
  size_t lit = 0;
  for (size_t i = 0; i < kCount; ++i) {
    ASSERT_TRUE(rows->done(i));
    LightSample sample;
    Ray shadow;
    Color expected = before[i];
    if (SampleLight(scene, 0, hits.rays[i], hits.surfaces[i], &sample, &shadow, &counts)) {
      AddLight(hits.surfaces[i], sample, sample.color, &expected);
      ++lit;
    }
    for (int c = 0; c < 3; ++c) EXPECT_EQ(sums[i][c], expected[c]) << simd << " hit " << i;
  }
  EXPECT_GT(lit, kCount / 4);
}

TEST(HitRows, AddUpAsAddLightDoes) {
  for (const char* simd : test::kAllKernels) {
    Random random(7);
    for (int round = 0; round < 20; ++round) Compare(simd, &random);
  }
}

}  // namespace
}  // namespace rayshade
