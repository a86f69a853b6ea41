// The statistics file.
#include "rayshade/render/stats.h"

#include <gtest/gtest.h>

namespace rayshade {
namespace {

TEST(Stats, AreOneJsonObjectWithPhasesRaysAndProcesses) {
  RunStats stats;
  stats.trace_seconds = 1.5;
  stats.operations.primary_rays = 10;
  stats.operations.shadow_rays = 5;
  stats.operations.rays_saved = 2;
  stats.objects = 4;
  stats.object_bytes = 200;
  stats.extra.emplace_back("schedule", JsonString("hybrid"));
  ProcessStats process;
  process.id = 3;
  process.host = "a\"b\n";
  process.sent_by_kind["RayTask"] = {2, 80};
  stats.processes = {process, {}};
  const std::string json = StatsJson(stats);
  for (const char* part :
       {"\"trace_seconds\":1.500000", "\"rays\":{\"primary\":10,\"shadow\":5,", "\"total\":15}",
        "\"rays_saved\":2", "\"bytes_per_object\":50.000000", "\"schedule\":\"hybrid\"",
        "\"id\":3,\"host\":\"a\\\"b\\u000a\"",
        "\"sent_by_kind\":{\"RayTask\":{\"messages\":2,\"bytes\":80}}", "\"sent_by_kind\":{}}]}"}) {
    EXPECT_NE(json.find(part), std::string::npos) << part << "\n" << json;
  }
}

TEST(Stats, KnowThePeakOfMemory) { EXPECT_GT(PeakBytes(), 100000u); }

}  // namespace
}  // namespace rayshade
