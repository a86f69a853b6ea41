// The claims of [RJ s.2], "Data parallel ray tracing", one test for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "parallel/object_spool.h"
#include "parallel/voxel_distribution.h"
#include "tests/paper/ray_trail.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

const RecordedRun& DataParallelBalls() {
  static const RecordedRun run = RecordRun(Balls(3, 48), ManyCells(Schedule::kDataParallel, 8), 1);
  return run;
}

// "A suitable data distribution is to split the object space into (equal sized) voxels exploiting
// local object coherence."
TEST(PaperSection2, TheObjectSpaceIsSplitIntoVoxelsOfEqualSize) {
  ObjectSpool spool;
  ParseText(Balls(2, 8), &spool);
  spool.Place(0);
  for (int n : {1, 2, 3, 7, 8, 24, 32}) {
    const CellTree tree = BuildTree(ManyCells(Schedule::kDataParallel, n), &spool);
    const Vector all = tree.bounds().high - tree.bounds().low;
    const double share = all.x * all.y * all.z / n;
    const std::vector<Bounds> voxels = Voxels(tree, n);
    for (int p = 1; p <= n; ++p) {
      const Vector d = voxels[p].high - voxels[p].low;
      EXPECT_NEAR(d.x * d.y * d.z, share, 1e-9 * share) << "process " << p << " of " << n;
    }
    // The boxes have the volume of the whole, and their cells fill them: none overlaps another.
    double filled = 0;
    for (const Bounds& cell : tree.Boxes()) {
      const Vector d = cell.high - cell.low;
      filled += d.x * d.y * d.z;
    }
    EXPECT_NEAR(filled, share * n, 1e-9 * share * n);
  }
}

TEST(PaperSection2, TwentyFourVoxelsAreFourByThreeByTwo) {
  EXPECT_EQ(GridCounts(24, {3, 2, 1}), (std::array<int, 3>{4, 3, 2}));
  EXPECT_EQ(GridCounts(24, {1, 3, 2}), (std::array<int, 3>{2, 4, 3}));
}

// "Each processor is assigned a process and a voxel with its objects."
TEST(PaperSection2, EveryProcessGetsTheObjectsOfItsVoxelAndNoOthers) {
  const RecordedRun& run = DataParallelBalls();
  std::set<std::pair<ProcessId, Rank>> sent, expected;
  run.ForEach<Objects>([&](const SentMessage& s, const Objects& message) {
    for (const WireObject& object : message.parcel.objects) {
      EXPECT_TRUE(sent.emplace(s.to, object.rank).second) << "an object is sent twice";
    }
  });
  const std::vector<Bounds> voxels = Voxels(run.tree, 8);
  ObjectSpool spool;
  ParseText(Balls(3, 48), &spool);
  spool.Place(0);
  SpooledObject object;
  while (spool.Next(true, &object)) {
    for (ProcessId p = 1; p <= 8; ++p) {
      if (voxels[p].Overlaps(object.bounds)) expected.emplace(p, object.object.rank);
    }
  }
  EXPECT_EQ(sent, expected);
}

// "After initialisation, for each primary ray the host determines which voxel it originates in (or
// enters) and sends this ray as a task to the associated trace process."
TEST(PaperSection2, TheHostSendsEachPrimaryRayToTheVoxelItEnters) {
  const RecordedRun& run = DataParallelBalls();
  size_t ready = 0, rays = 0, elsewhere = 0;
  for (const SentMessage& s : run.sent) {
    ready += s.tag == Tag::kReady;
    if (s.tag != Tag::kRayTask || s.from != kHost) continue;
    EXPECT_EQ(ready, 8u) << "a ray before initialisation is over";
    for (const auto& [ray, travel] : run.Travellers(s)) {
      EXPECT_EQ(ray.kind, RayKind::kPrimary);
      ++rays;
      const std::vector<CellId> cells = CellsAlong(run.tree, ray);
      const auto entered = std::find_if(cells.begin(), cells.end(),
                                        [&](CellId c) { return run.tree.cell(c).objects > 0; });
      if (entered == cells.end()) {
        ++elsewhere;  // no voxel with objects: any process may find that out
      } else {
        EXPECT_EQ(run.tree.cell(*entered).owner, s.to);
      }
    }
  }
  EXPECT_EQ(rays, 48u * 49u);  // a row more than the picture has
  EXPECT_LT(elsewhere, rays / 2);
}

// "First, the ray may leave the voxel without intersecting any object. If this happens, the ray is
// transferred to a neighbouring voxel." Between them may lie only cells that the sender knows:
// empty ones, and those that it has fetched for its shadow rays.
TEST(PaperSection2, ARayThatLeavesAVoxelGoesToTheNextOneOnItsWay) {
  const RecordedRun& run = DataParallelBalls();
  const std::vector<Bounds> boxes = run.tree.Boxes();
  std::map<std::pair<ProcessId, CellId>, size_t> fetched;  // number of the message
  run.ForEach<CellReply>([&](const SentMessage& s, const CellReply& reply) {
    fetched.try_emplace({s.to, reply.cell}, &s - run.sent.data());
  });
  size_t steps = 0, without_fetched = 0;
  for (const std::vector<RayStep>& trail : RayTrails(run)) {
    const std::vector<CellId> cells = CellsAlong(run.tree, trail[0].ray);
    auto from = cells.begin();
    for (const RayStep& step : trail) {
      if (step.travel.resume == kNoCell) continue;  // a primary ray that enters no voxel
      const auto next = std::find(cells.begin(), cells.end(), step.travel.resume);
      ASSERT_NE(next, cells.end()) << "a cell that is not on the ray's way";
      ASSERT_LE(from, next) << "a ray went back";
      EXPECT_EQ(run.tree.cell(*next).owner, step.to);
      if (step.from != kHost) {
        ++steps;
        EXPECT_NE(step.from, step.to);
        EXPECT_LT(from, next);
        const auto known = [&](CellId c) {
          return run.tree.cell(c).owner == step.from || run.tree.cell(c).objects == 0;
        };
        without_fetched += std::all_of(from, next, known);
        EXPECT_TRUE(std::all_of(from, next, [&](CellId c) {
          const auto reply = fetched.find({step.from, c});
          return known(c) || (reply != fetched.end() && reply->second < step.at);
        })) << "a voxel on the way was left out";
        EXPECT_TRUE(std::any_of(from, next, [&](CellId c) {
          return Touch(boxes[c], boxes[*next]);
        })) << "the next cell is no neighbour of one behind";
      }
      from = next;
    }
  }
  EXPECT_GT(steps, 300u);
  EXPECT_GT(without_fetched, steps / 2);
}

// "Else, an intersection with some locally stored object is found and secondary rays are spawned.
// These rays are traced and if necessary communicated to neighbouring voxels."
TEST(PaperSection2, SecondaryRaysStartInTheVoxelOfTheirSpawner) {
  const RecordedRun& run = DataParallelBalls();
  const std::vector<Bounds> voxels = Voxels(run.tree, 8);
  size_t secondary = 0;
  for (const std::vector<RayStep>& trail : RayTrails(run)) {
    const RayStep& first = trail[0];
    if (first.ray.kind == RayKind::kPrimary) continue;
    ++secondary;
    EXPECT_EQ(first.travel.back.process, first.from) << "not sent out by its spawner";
    EXPECT_TRUE(Touch(voxels[first.from], {first.ray.origin, first.ray.origin}));
  }
  EXPECT_GT(secondary, 50u);
}

// "The results of these rays are returned to the process that spawned the rays."
TEST(PaperSection2, EveryResultGoesBackToTheSpawnerOnce) {
  const RecordedRun& run = DataParallelBalls();
  std::map<std::pair<ProcessId, uint64_t>, int> open;  // secondary rays away from their spawner
  size_t results = 0;
  for (const SentMessage& s : run.sent) {
    for (const Traveller& t : run.Travellers(s)) {
      if (s.from != kHost && t.travel.back.process == s.from)
        open[{s.from, t.travel.back.token}] = 1;
    }
    if (s.tag == Tag::kRayResults) {
      for (const ResultItem& item : Decode<RayResults>(s.bytes).results) {
        ++results;
        EXPECT_NE(s.from, s.to);
        EXPECT_EQ((open[{s.to, item.token}]--), 1) << "a result for a ray that is not away";
      }
    }
  }
  EXPECT_GT(results, 50u);
}

// "The host collects all the shading information for each pixel"
TEST(PaperSection2, TheHostGetsOneResultForEachPrimaryRay) {
  const RecordedRun& run = DataParallelBalls();
  std::multiset<uint64_t> asked, answered;
  for (const SentMessage& s : run.sent) {
    for (const Traveller& t : run.Travellers(s)) {
      if (s.from == kHost) asked.insert(t.travel.back.token);
    }
    for (const Pixel& item : RecordedRun::Pixels(s)) {
      EXPECT_EQ(s.to, kHost);
      answered.insert(item.token);
    }
  }
  EXPECT_EQ(asked, answered);
  EXPECT_EQ(std::set<uint64_t>(asked.begin(), asked.end()).size(), asked.size());
}

// "the object database does not need to be duplicated with each process, but can be divided over
// the distributed memories instead."
TEST(PaperSection2, TheObjectsAreDividedOverTheProcesses) {
  const RecordedRun& run = DataParallelBalls();
  ASSERT_EQ(run.processes.size(), 8u);
  uint64_t sum = 0, most = 0;
  for (const Statistics& s : run.processes) {
    sum += s.objects;
    most = std::max(most, s.objects);
  }
  constexpr uint64_t kAll = 1 + 9 + 81 + 729;
  EXPECT_GE(sum, kAll);
  EXPECT_LT(sum, kAll + kAll / 2) << "only objects that cross a border are held twice";
  EXPECT_LT(most, kAll / 2);
}

// "as each voxel borders on at most a few other voxels, communication for ray tasks is only local."
TEST(PaperSection2, RayTasksGoToVoxelsThatTouchWhereNoneIsEmpty) {
  std::string text =
      "screen 24 24\nsample 1 nojitter\ncontrast 1 1 1\nup 0 0 1\nfov 40 40\neyep 9 7 5\n"
      "lookp 0 0 0\nlight 1 point 9 9 9 noshadow\nsurface shiny diffuse .5 .5 .5 specular .5 .5 .5 "
      "reflect "
      ".5\n";
  for (int i = 0; i < 6 * 6 * 6; ++i) {
    text += "sphere shiny .15 " + std::to_string(i % 6 - 2.5) + " " +
            std::to_string(i / 6 % 6 - 2.5) + " " + std::to_string(i / 36 - 2.5) + "\n";
  }
  RunOptions options = ManyCells(Schedule::kDataParallel, 27);
  options.cell_bytes = 1 << 20;  // the voxels are the cells
  const RecordedRun run = RecordRun(text, options, 2);
  ASSERT_EQ(run.tree.size(), 27u);
  const std::vector<Bounds> voxels = Voxels(run.tree, 27);
  std::set<std::pair<ProcessId, ProcessId>> ways;
  run.ForEach<RayTask>([&](const SentMessage& s, const RayTask&) {
    if (s.from == kHost) return;
    ways.emplace(s.from, s.to);
    EXPECT_TRUE(Touch(voxels[s.from], voxels[s.to])) << s.from << " to " << s.to;
  });
  EXPECT_GT(ways.size(), 30u);
}

}  // namespace
}  // namespace rayshade::parallel
