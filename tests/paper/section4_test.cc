// The claims of [RJ s.4], "Hybrid system", one test for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "parallel/object_spool.h"
#include "parallel/voxel_distribution.h"
#include "rayshade/scene/scene_builder.h"
#include "tests/paper/ray_trail.h"
#include "tests/support/hand_driven_run.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

constexpr int kProcesses = 6;
constexpr uint64_t kResident = 20000;

RunOptions HybridOptions(uint64_t resident = kResident) {
  RunOptions options = ManyCells(Schedule::kHybrid, kProcesses);
  options.resident = resident;
  return options;
}

const RecordedRun& Hybrid() {
  static const RecordedRun run = RecordRun(Balls(3, 48), HybridOptions(), 1);
  return run;
}

// Which process was given each primary ray.
std::map<uint64_t, ProcessId> Givens(const RecordedRun& run) {
  std::map<uint64_t, ProcessId> given;
  run.ForEach<PrimaryRays>([&](const SentMessage& s, const PrimaryRays& message) {
    for (uint64_t token : message.samples.tokens()) given[token] = s.to;
  });
  return given;
}

// "this would require a complete copy of the data base to be stored at the host, which puts a
// significant constraint on the size of the data base." The host sends on what it reads, and reads
// no further while the receivers are behind.
TEST(PaperSection4, TheHostReadsNoFurtherThanTheReceiversTake) {
  std::string text = "screen 8 8\neyep 0 -9 0\nlookp 0 0 0\nlight 1 point 0 -9 9\n";
  for (int i = 0; i < 30000; ++i)
    text += "sphere .01 " + std::to_string(i % 100) + " " + std::to_string(i / 100) + " 0\n";
  RunOptions options;
  options.processes = 1;
  HandDrivenRun run(text, options);
  const auto parcels = [](const std::vector<SentMessage>& sent) {
    return std::count_if(sent.begin(), sent.end(),
                         [](const SentMessage& s) { return s.tag == Tag::kObjects; });
  };
  const auto first = parcels(run.Work(kHost));
  EXPECT_GT(first, 10);
  EXPECT_EQ(parcels(run.Work(kHost)), 0) << "it goes on without having heard";
  for (int i = 0; i < 10; ++i) run.Tell(1, kHost, ObjectsTaken{});
  const auto second = parcels(run.Work(kHost));
  EXPECT_GT(second, 5);
  EXPECT_LT(second, first);
  EXPECT_EQ(run.host->phase(), HostProcess::Phase::kDistribute) << "there are more objects";
}

// "there is a host process that issues bundles of rays on request to the (distributed) trace
// processes."
TEST(PaperSection4, TheHostIssuesBundlesOnRequestOnly) {
  const RecordedRun& run = Hybrid();
  std::map<ProcessId, int> requests;
  size_t bundles = 0;
  for (const SentMessage& s : run.sent) {
    if (s.tag == Tag::kWorkRequest) ++requests[s.from];
    if (s.tag != Tag::kPrimaryRays) continue;
    ++bundles;
    EXPECT_GE(--requests[s.to], 0) << "a bundle that process " << s.to << " did not ask for";
  }
  EXPECT_GT(bundles, 30u);
  for (const SentMessage& s : run.sent)
    EXPECT_FALSE(s.from == kHost && s.tag == Tag::kRayTask) << "a primary ray out of a bundle";
}

// "To avoid that all trace processes should have access to the whole data base for the PyraClip
// preprocessing, only the spatial subdivision structure is duplicated with each process."
TEST(PaperSection4, OnlyTheSubdivisionIsDuplicated) {
  const RecordedRun& run = Hybrid();
  ByteWriter tree;
  tree.Put(run.tree);
  size_t trees = 0;
  run.ForEach<parallel::SetUp>([&](const SentMessage&, const parallel::SetUp& message) {
    ByteWriter sent;
    sent.Put(message.tree);
    EXPECT_TRUE(std::ranges::equal(sent.bytes(), tree.bytes()));
    EXPECT_TRUE(message.scene.placements.empty());
    ++trees;
  });
  EXPECT_EQ(trees, size_t{kProcesses});

  std::set<std::pair<ProcessId, Rank>> sent, expected;
  run.ForEach<Objects>([&](const SentMessage& s, const Objects& message) {
    for (const WireObject& object : message.parcel.objects) sent.emplace(s.to, object.rank);
  });
  ObjectSpool spool;
  ParseText(Balls(3, 48), &spool);
  spool.Place(0);
  SpooledObject object;
  size_t everywhere = 0, all = 0;
  while (spool.Next(true, &object)) {
    bool resident = false;
    run.tree.ForEachOver(object.bounds, [&](CellId c) {
      resident = resident || run.tree.cell(c).resident;
      expected.emplace(run.tree.cell(c).owner, object.object.rank);
    });
    for (ProcessId p = 1; resident && p <= kProcesses; ++p) expected.emplace(p, object.object.rank);
    everywhere += resident;
    ++all;
  }
  EXPECT_EQ(sent, expected) << "own voxel and resident set";
  EXPECT_GT(everywhere, 10u);
  EXPECT_LT(everywhere, all / 2);
}

// Unbounded objects have no voxel: they are held by all.
TEST(PaperSection4, UnboundedObjectsAreHeldByAll) {
  const RecordedRun run =
      RecordRun(Balls(1, 16) + "plane dull 0 0 -.5 0 0 1\n", HybridOptions(0), 1);
  std::set<ProcessId> holders;
  run.ForEach<Objects>([&](const SentMessage& s, const Objects& message) {
    for (const WireObject& object : message.parcel.objects)
      if (std::holds_alternative<PlaneSpec>(object.geom)) holders.insert(s.to);
  });
  EXPECT_EQ(holders.size(), size_t{kProcesses});
}

// "the cache is pre-filled with a resident set consisting of objects closest to the viewpoint"
TEST(PaperSection4, TheResidentSetIsWhatIsClosestToTheViewpoint) {
  const RecordedRun& run = Hybrid();
  const std::vector<Bounds> boxes = run.tree.Boxes();
  const auto distance = [&](CellId c) {
    Vector nearest = run.camera->eye();
    for (int axis = 0; axis < 3; ++axis)
      nearest[axis] = std::clamp(nearest[axis], boxes[c].low[axis], boxes[c].high[axis]);
    return Length(nearest - run.camera->eye());
  };
  double farthest_in = 0, nearest_out = kFar;
  uint64_t bytes = 0, all = 0;
  for (CellId c = 0; c < run.tree.size(); ++c) {
    const Cell& cell = run.tree.cell(c);
    all += cell.bytes;
    if (cell.resident) {
      farthest_in = std::max(farthest_in, distance(c));
      bytes += cell.bytes;
    } else {
      nearest_out = std::min(nearest_out, distance(c));
    }
  }
  EXPECT_GT(bytes, kResident / 2);
  EXPECT_LE(bytes, kResident);
  EXPECT_GT(all, 2 * kResident);
  EXPECT_LE(farthest_in, nearest_out);
}

// "Rays that survive these objects are further processed in a data parallel manner."
TEST(PaperSection4, RaysThatSurviveTheResidentSetGoOnDataParallel) {
  const RecordedRun& run = Hybrid();
  const std::map<uint64_t, ProcessId> given = Givens(run);
  size_t survivors = 0;
  for (const std::vector<RayStep>& trail : RayTrails(run)) {
    const RayStep& first = trail[0];
    if (first.ray.kind != RayKind::kPrimary) continue;
    ++survivors;
    EXPECT_EQ(first.from, given.at(first.travel.back.token));
    for (const RayStep& step : trail) {
      const Cell& cell = run.tree.cell(step.travel.resume);
      EXPECT_EQ(cell.owner, step.to);
      EXPECT_FALSE(cell.resident) << "everyone holds that cell";
      EXPECT_GT(cell.objects, 0u);
    }
  }
  EXPECT_GT(survivors, 50u);
  EXPECT_LT(survivors, given.size() / 2) << "empty cells and the resident set end many rays";

  // A resident set of everything is survived by none.
  const RecordedRun all = RecordRun(Balls(3, 48), HybridOptions(10000000), 1);
  EXPECT_EQ(all.Count(Tag::kRayTask), 0u);
  EXPECT_EQ(all.Count(Tag::kCellRequest), 0u);
}

// "When during demand-driven tracing of primary rays an intersection is found then further
// processing is transferred to the process that keeps the intersected object (in the data parallel
// scheme)."
TEST(PaperSection4, HitsAreTransferredToTheProcessThatKeepsTheObject) {
  const RecordedRun& run = Hybrid();
  size_t transferred = 0;
  for (const SentMessage& s : run.sent) {
    if (s.tag != Tag::kIntersectionTask) continue;
    for (const Traveller& t : run.Travellers(s)) {
      ++transferred;
      EXPECT_NE(s.from, s.to);
      EXPECT_NE(t.travel.best_rank, kNoRank);
      EXPECT_EQ(run.OwnerAt(t.ray, t.travel.best_distance), s.to);
    }
  }
  EXPECT_GT(transferred, 100u);
}

// "This process then spawns the secondary rays that are traced data parallel. This process also
// spawns the shadow rays. … When the results of the secondary rays are gathered, the shading is
// performed and the result is returned to the host." In data-parallel and hybrid nobody but the
// owner of the place shades a hit.
TEST(PaperSection4, NobodyButTheOwnerShadesAHit) {
  SceneBuilder builder;
  ParseText(Balls(3, 48), &builder);
  const SceneBuilder::Built scene = builder.Build(0);
  for (Schedule schedule : {Schedule::kDataParallel, Schedule::kHybrid}) {
    RunOptions options = HybridOptions();
    options.schedule = schedule;
    const RecordedRun run = RecordRun(Balls(3, 48), options, 4);
    std::map<std::pair<ProcessId, uint64_t>, Ray> away;  // secondary rays, by return address
    size_t primary = 0, secondary = 0;
    for (const SentMessage& s : run.sent) {
      for (const Traveller& t : run.Travellers(s))
        away[{t.travel.back.process, t.travel.back.token}] = t.ray;
      for (const Pixel& item : RecordedRun::Pixels(s)) {
        if (!item.hit) continue;
        ++primary;
        const Ray ray = run.camera->PrimaryRay(SampleOf(item.token));
        Hit hit;
        OpCounts counts;
        scene.objects->Nearest({&ray, 1}, {&hit, 1}, &counts);
        EXPECT_EQ(run.OwnerAt(ray, hit.distance), s.from);
      }
      if (s.tag != Tag::kRayResults) continue;
      for (const ResultItem& item : Decode<RayResults>(s.bytes).results) {
        if (item.distance == kFar) continue;
        ++secondary;
        EXPECT_EQ(run.OwnerAt(away.at({s.to, item.token}), item.distance), s.from);
      }
    }
    EXPECT_GT(primary, 500u) << Name(schedule);
    EXPECT_GT(secondary, 10u) << Name(schedule);
  }
}

// Section 2: "When all results for an intersection are completed, shading is performed and a colour
// value is returned."
TEST(PaperSection4, AnIntersectionIsShadedWhenAllItsResultsAreIn) {
  RunOptions options = ManyCells(Schedule::kDataParallel, 2);
  options.cell_bytes = 1 << 20;
  HandDrivenRun run(
      "screen 8 8\nsample 1 nojitter\ncontrast 1 1 1\nup 0 0 1\nfov 10 10\neyep -4 .1 .2\n"
      "lookp 5 0 0\nmaxdepth 3\nlight 1 point 3 0 .5\n"
      "surface mirror diffuse .1 .1 .1 specular .9 .9 .9 reflect 1\n"
      "box mirror -5.1 -1 -1 -5 1 1\nbox mirror 5 -1 -1 5.1 1 1\n",
      options);
  run.SetUpAll();
  const ProcessId near = 1, far = 2;
  // Primary rays enter where the eye is, and go on to the mirror at the far side.
  RayTask arrived;
  for (const SentMessage& s : run.Work(kHost)) {
    if (s.to == near) run.Tell(s);
  }
  for (const SentMessage& s : run.Work(near)) {
    if (s.to == far && s.tag == Tag::kRayTask) arrived = Decode<RayTask>(s.bytes);
  }
  ASSERT_GT(arrived.primary.size(), 1u);
  run.Tell(near, far, arrived);

  std::vector<SentMessage> said = run.Work(far);
  for (const SentMessage& s : said) {  // cells for shadow rays
    if (s.tag != Tag::kCellRequest) continue;
    for (const SentMessage& reply : run.Tell(s)) run.Tell(reply);
  }
  for (SentMessage& s : run.Work(far)) said.push_back(std::move(s));
  std::set<uint64_t> completed;
  const auto count = [&](const std::vector<SentMessage>& sent, bool red) {
    size_t n = 0;
    for (const SentMessage& s : sent) {
      for (const Pixel& item : RecordedRun::Pixels(s)) {
        EXPECT_TRUE(completed.insert(item.token).second) << "shaded twice";
        EXPECT_TRUE(!red || item.color.r > item.color.g) << "the red of the reflection";
        ++n;
      }
    }
    return n;
  };
  const size_t waiting = arrived.primary.size() - count(said, false);
  RayResults results;
  for (const SentMessage& s : said) {
    if (s.tag != Tag::kRayTask) continue;
    for (const Travel& travel : Decode<RayTask>(s.bytes).travel) {
      EXPECT_EQ(travel.back.process, far);
      results.results.push_back({travel.back.token, {1, 0, 0}, 1});
    }
  }
  ASSERT_GT(waiting, 1u);
  ASSERT_EQ(results.results.size(), waiting) << "each has one reflected ray out";

  // The last result is kept back: all others are shaded.
  const ResultItem last = results.results.back();
  results.results.pop_back();
  run.Tell(near, far, results);
  EXPECT_EQ(count(run.Work(far), true), waiting - 1);
  run.Tell(near, far, RayResults{{last}});
  EXPECT_EQ(count(run.Work(far), true), 1u);
}

// "When no intersection is found during demand-driven tracing of primary rays, this result is
// returned directly to the host process."
TEST(PaperSection4, AVoidGoesStraightToTheHost) {
  const RecordedRun& run = Hybrid();
  std::map<uint64_t, ProcessId> at = Givens(run);  // where each primary ray is
  std::set<uint64_t> hits;
  size_t voids = 0, direct = 0;
  const std::map<uint64_t, ProcessId> given = at;
  for (const SentMessage& s : run.sent) {
    for (const Traveller& t : run.Travellers(s)) {
      if (t.ray.kind != RayKind::kPrimary) continue;
      at[t.travel.back.token] = s.to;
      if (s.tag == Tag::kIntersectionTask) hits.insert(t.travel.back.token);
    }
    for (const Pixel& item : RecordedRun::Pixels(s)) {
      if (item.hit) continue;
      ++voids;
      EXPECT_EQ(s.from, at.at(item.token)) << "a void went round";
      direct += s.from == given.at(item.token);
      EXPECT_FALSE(hits.contains(item.token));
    }
  }
  EXPECT_GT(voids, 500u);
  EXPECT_GT(direct, voids / 2) << "most meet nothing but empty cells and the resident set";
}

// Figure 5: "the resulting setup of host, data parallel trace and demand driven PyraClip tasks".
// Every arrow of the run is one of the catalogue.
TEST(PaperSection4, MessagesFlowAlongTheArrowsOfFigure5) {
  std::set<Tag> seen;
  std::vector<RunOptions> runs(4, HybridOptions());
  runs[0].schedule = Schedule::kDataParallel;
  runs[1].schedule = Schedule::kDemandDriven;
  runs[2].schedule = Schedule::kDataParallel;
  runs[2].shadows = Shadows::kTravel;
  for (const RunOptions& options : runs) {
    for (const SentMessage& s : RecordRun(Balls(3, 32), options, 1).sent) {
      ForEachMessage([&]<class Message>() {
        if (Message::kTag != s.tag) return;
        seen.insert(s.tag);
        const std::string from = s.from == kHost ? "host" : "trace";
        const std::string to = s.to == kHost ? "host" : "trace";
        EXPECT_NE(std::string(Message::kFrom).find(from), std::string::npos) << Message::kName;
        EXPECT_NE(std::string(Message::kTo).find(to), std::string::npos) << Message::kName;
      });
    }
  }
  EXPECT_EQ(seen.size(), static_cast<size_t>(kTags - 1 - 2)) << "all but Text and Failure";
}

// "There are further a large number of difficult control issues involved which deal with memory
// usage (buffer and cache sizes, etc.), communication (buffer overflow, message packing, saturation
// and deadlock)". No more primary rays are out than the limit allows; messages hold many rays.
TEST(PaperSection4, NoMoreRaysAreOutThanTheLimitAndTheyTravelPacked) {
  RunOptions options = HybridOptions();
  options.rays_in_flight = 100;
  const RecordedRun run = RecordRun(Balls(3, 48), options, 5);
  EXPECT_EQ(run.in_flight_limit, 100u);
  int64_t out = 0;
  for (const SentMessage& s : run.sent) {
    if (s.tag == Tag::kPrimaryRays)
      out += static_cast<int64_t>(Decode<PrimaryRays>(s.bytes).samples.size());
    out -= static_cast<int64_t>(RecordedRun::Pixels(s).size());
    EXPECT_LE(out, 100);
  }
  EXPECT_EQ(out, 0);

  size_t rays = 0, tasks = 0;
  for (const SentMessage& s : Hybrid().sent) {
    rays += Hybrid().Travellers(s).size();
    tasks += s.tag == Tag::kRayTask || s.tag == Tag::kIntersectionTask;
    EXPECT_TRUE(s.tag == Tag::kSetUp || s.bytes.size() <= 20000) << NameOf(s.tag);
  }
  EXPECT_GT(rays, 3 * tasks);
}

}  // namespace
}  // namespace rayshade::parallel
