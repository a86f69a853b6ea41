// Runs that seeds make difficult: other delays, slow processes, small credits, caches, resident
// sets and pyramids each time. Every one gives the sequential picture, keeps every invariant
// (parallel/sim/invariants.h), and ends. `make seeds` runs ten thousand: SEEDS_COUNT of them, from
// SEEDS_FROM on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "parallel/object_spool.h"
#include "parallel/sim/fault_run.h"
#include "parallel/sim/sequential_base.h"
#include "tests/support/parallel_run.h"

namespace rayshade::parallel {
namespace {

constexpr int kFailuresMax = 10;

uint64_t FromEnvironment(const char* name, uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

struct SeedScene {
  explicit SeedScene(const std::string& name) : file(name) {
    Options options;
    options.input = file;
    options.raw_input = true;
    ParseInto(options, &spool);
    spool.Place(0);
    SequentialWork(&spool, 0, &sequential);
  }

  std::string file;
  ObjectSpool spool;
  Picture sequential{0, 0};
};

std::vector<std::unique_ptr<SeedScene>> SeedScenes() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator("tests/parallel/sim/seeds"))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  std::vector<std::unique_ptr<SeedScene>> scenes;
  for (const std::string& file : files) scenes.push_back(std::make_unique<SeedScene>(file));
  return scenes;
}

// "" where all is well.
std::string WrongWith(uint64_t seed, SeedScene* scene) {
  FaultRun run(PlanFaults(seed), &scene->spool, 0);
  try {
    run.Run();
  } catch (const std::exception& e) {
    return e.what();
  }
  return DifferenceOf(scene->sequential, run.picture()).value_or("");
}

TEST(Seeds, GiveTheSequentialPictureKeepEveryInvariantAndEnd) {
  const uint64_t from = FromEnvironment("SEEDS_FROM", 0);
  const uint64_t count = FromEnvironment("SEEDS_COUNT", 300);
  const auto scenes = SeedScenes();
  ASSERT_GE(scenes.size(), 5u);
  int failures = 0;
  for (uint64_t seed = from; seed < from + count && failures < kFailuresMax; ++seed) {
    SeedScene& scene = *scenes[seed % scenes.size()];
    const std::string what = WrongWith(seed, &scene);
    if (count >= 5000 && (seed - from + 1) % 1000 == 0)
      std::printf("%llu seeds\n", static_cast<unsigned long long>(seed - from + 1));
    if (what.empty()) continue;
    ++failures;
    ADD_FAILURE() << what << "\nreplayed by: build/prayshade-sim --fault-seed " << seed
                  << " --transcript - -u -O build/seed.png " << scene.file;
  }
}

TEST(Seeds, PlansArePureFunctionsOfTheirSeeds) {
  for (uint64_t seed = 0; seed < 50; ++seed)
    EXPECT_EQ(PlanFaults(seed).Text(), PlanFaults(seed).Text());
  EXPECT_NE(PlanFaults(1).Text(), PlanFaults(2).Text());
}

}  // namespace
}  // namespace rayshade::parallel
