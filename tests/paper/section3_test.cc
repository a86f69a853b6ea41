// The claims of [RJ s.3], "Demand driven pyramid tracing", one test for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "parallel/object_spool.h"
#include "parallel/pyraclip.h"
#include "parallel/voxel_distribution.h"
#include "tests/paper/ray_trail.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

bool SkipNone(uint32_t) { return false; }

// The bundles that a run hands out, as rays.
std::vector<std::vector<Ray>> Bundles(const RecordedRun& run) {
  std::vector<std::vector<Ray>> bundles;
  run.ForEach<PrimaryRays>([&](const SentMessage&, const PrimaryRays& message) {
    std::vector<Ray>& rays = bundles.emplace_back();
    for (uint64_t token : message.samples.tokens())
      rays.push_back(run.camera->PrimaryRay(SampleOf(token)));
  });
  return bundles;
}

const RecordedRun& HybridBalls() {
  static const RecordedRun run = RecordRun(Balls(3, 48), ManyCells(Schedule::kHybrid, 6), 1);
  return run;
}

// "primary rays all originate from the eye point and travel in similar directions." And in section
// 1: "A pyramid of primary rays has the viewpoint as top of the pyramid and its cross section will
// be square."
TEST(PaperSection3, APyramidHasTheEyeAsItsTopAndASquareCrossSection) {
  const RecordedRun& run = HybridBalls();
  size_t full = 0;
  run.ForEach<PrimaryRays>([&](const SentMessage&, const PrimaryRays& message) {
    EXPECT_LE(message.samples.size(), 64u);
    int low[] = {1 << 20, 1 << 20}, high[] = {-1, -1};
    std::vector<Ray> rays;
    for (uint64_t token : message.samples.tokens()) {
      const Sample s = SampleOf(token);
      low[0] = std::min(low[0], s.x);
      low[1] = std::min(low[1], s.y);
      high[0] = std::max(high[0], s.x);
      high[1] = std::max(high[1], s.y);
      rays.push_back(run.camera->PrimaryRay(s));
    }
    const Pyramid pyramid = Pyramid::Around(rays);
    EXPECT_EQ(pyramid.origins, (Bounds{run.camera->eye(), run.camera->eye()}));
    if (message.samples.size() < 64) return;  // at the picture's edge
    ++full;
    EXPECT_TRUE(pyramid.narrow());
    EXPECT_LE(high[0] - low[0], 15);
    EXPECT_LE(high[1] - low[1], 15);
  });
  EXPECT_GT(full, 10u);
}

// "PyraClip … was implemented by us to retrieve a list of cells in depth order from a bintree
// structure."
TEST(PaperSection3, ClipListsAreInDepthOrderAndMissNoCellThatARayMeets) {
  const RecordedRun& run = HybridBalls();
  size_t listed = 0, met = 0;
  for (const std::vector<Ray>& rays : Bundles(run)) {
    const auto list = PyraClip(run.tree, Pyramid::Around(rays), kFar, SkipNone);
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end(),
                               [](const auto& a, const auto& b) { return a.entry < b.entry; }));
    std::set<CellId> cells;
    for (const ClippedCell& clipped : list) cells.insert(clipped.cell);
    EXPECT_EQ(cells.size(), list.size()) << "a cell stands in the list twice";
    listed += cells.size();
    for (const Ray& ray : rays) {
      for (CellId cell : CellsAlong(run.tree, ray)) {
        ++met;
        EXPECT_TRUE(cells.contains(cell));
      }
    }
  }
  EXPECT_GT(met, 5000u);
  EXPECT_LT(listed, Bundles(run).size() * run.tree.size() / 2) << "lists of nearly everything";
}

// "the tracing of the individual rays within the pyramid only requires a relatively small number of
// objects, namely the objects that lie within the cells traversed."
TEST(PaperSection3, ADemandDrivenTaskFetchesOnlyCellsOfItsClipList) {
  std::string text = Balls(3, 32);
  text.insert(text.find("grid"), "maxdepth 0\n");
  text.replace(text.find("point 4 3 2"), 11, "point 4 3 2 noshadow");
  const RecordedRun run = RecordRun(text, ManyCells(Schedule::kDemandDriven, 4), 1);
  std::set<std::pair<ProcessId, CellId>> clipped;
  run.ForEach<PrimaryRays>([&](const SentMessage& s, const PrimaryRays& message) {
    std::vector<Ray> rays;
    for (uint64_t token : message.samples.tokens())
      rays.push_back(run.camera->PrimaryRay(SampleOf(token)));
    for (const ClippedCell& c : PyraClip(run.tree, Pyramid::Around(rays), kFar, SkipNone))
      clipped.emplace(s.to, c.cell);
  });
  size_t requests = 0;
  run.ForEach<CellRequest>([&](const SentMessage& s, const CellRequest& request) {
    ++requests;
    EXPECT_TRUE(clipped.contains({s.from, request.cell}));
    EXPECT_EQ(run.tree.cell(request.cell).owner, s.to) << "the owner is asked";
    EXPECT_GT(run.tree.cell(request.cell).objects, 0u) << "an empty cell is asked for";
  });
  EXPECT_GT(requests, 10u);
  EXPECT_EQ(run.Count(Tag::kRayTask), 0u) << "nothing is traced data parallel";
}

// "Light pyramids are then preferably processed by the process that initiated them to avoid
// contention at the processes that contain the light sources."
TEST(PaperSection3, ShadowRaysNeverLeaveTheProcessThatSpawnedThem) {
  const std::string text = Balls(3, 32);
  const OpCounts sequential = RenderSequentially(text).counts;
  for (Schedule schedule : {Schedule::kDataParallel, Schedule::kDemandDriven, Schedule::kHybrid}) {
    const RecordedRun run = RecordRun(text, ManyCells(schedule, 6), 3);
    for (const SentMessage& s : run.sent) {
      for (const Traveller& t : run.Travellers(s)) EXPECT_NE(t.ray.kind, RayKind::kShadow);
    }
    EXPECT_EQ(run.Count(Tag::kShadowTask), 0u);
    uint64_t shadow_rays = 0;
    for (const Statistics& s : run.processes) shadow_rays += s.counts.shadow_rays;
    EXPECT_EQ(shadow_rays, sequential.shadow_rays) << Name(schedule);
  }
}

// Figure 3: a floor in the left voxel, an object before the light in the right one.
const char kFigure3[] =
    "screen 24 24\nsample 1 nojitter\ncontrast 1 1 1\nup 0 0 1\nfov 60 60\neyep -5 -6 5\n"
    "lookp -5 0 0\nsurface dull diffuse .7 .7 .7\nlight 1 point 9 0 6\n"
    "box dull -10 -4 -.1 -1 4 0\nsphere dull .5 4 0 3\nsphere dull .1 10 0 6\n";

// "It may then be necessary to fetch objects from remote processes, as figure 3 illustrates. In
// this figure, the object in the right voxel, which is in front of the area light source, is needed
// by all light pyramids depicted."
TEST(PaperSection3, ObjectsInFrontOfTheLightAreFetchedAsInFigure3) {
  RunOptions options = ManyCells(Schedule::kHybrid, 2);
  options.cell_bytes = 1 << 20;
  const RecordedRun run = RecordRun(kFigure3, options, 1);
  const ProcessId left = run.tree.cell(run.tree.At({-5, 0, 0})).owner;
  const ProcessId right = run.tree.cell(run.tree.At({4, 0, 3})).owner;
  ASSERT_NE(left, right);
  int requests = 0, replies = 0;
  run.ForEach<CellRequest>([&](const SentMessage& s, const CellRequest&) {
    requests += s.from == left && s.to == right;
  });
  run.ForEach<CellReply>([&](const SentMessage& s, const CellReply& reply) {
    if (s.to != left) return;
    ++replies;
    EXPECT_EQ(s.from, right);
    EXPECT_EQ(reply.parcel.objects.size(), 2u) << "both spheres of the right voxel";
  });
  EXPECT_EQ(requests, 1);
  EXPECT_EQ(replies, 1);
}

// "Each process that may spawn light pyramids should be equipped with a cache, which reduces data
// communication. The effectiveness of such a cache is estimated to be high, because many pyramids
// generated from within a voxel, will intersect with the same objects."
TEST(PaperSection3, TheCacheReducesDataCommunication) {
  const std::string text = Balls(3, 64);
  RunOptions options = ManyCells(Schedule::kHybrid, 6);
  options.cell_bytes = 1000;
  const RecordedRun large = RecordRun(text, options, 2);
  options.cache = 1;  // the least that is allowed: two of the largest cells
  const RecordedRun small = RecordRun(text, options, 2);
  std::set<std::pair<ProcessId, CellId>> asked;
  large.ForEach<CellRequest>([&](const SentMessage& s, const CellRequest& request) {
    EXPECT_TRUE(asked.emplace(s.from, request.cell).second) << "a cell is fetched again";
  });
  EXPECT_GT(asked.size(), 20u);
  EXPECT_GT(small.Count(Tag::kCellRequest), 3 * large.Count(Tag::kCellRequest) / 2);
}

}  // namespace
}  // namespace rayshade::parallel
