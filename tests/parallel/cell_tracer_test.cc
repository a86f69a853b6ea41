// Tracing against a part of the scene, cell after cell, finds what the whole scene has.
#include "parallel/cell_tracer.h"

#include <gtest/gtest.h>

#include "rayshade/common/keyed_random.h"

namespace rayshade::parallel {
namespace {

// Spheres in a cube that two processes share; process 1 traces, and cells of process 2 come one by
// one.
class CellTracerTest : public testing::Test {
 protected:
  CellTracerTest() : tree_({{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}}), scene_(OnePlacement(), 0) {
    scene_.spec.surfaces.resize(1);
    for (int axis = 0; axis < 3; ++axis) {
      for (CellId c = 0, n = static_cast<CellId>(tree_.size()); c < n; ++c) tree_.Cut(c, axis, .1);
    }
    for (CellId c = 0; c < tree_.size(); ++c) tree_.cell(c).owner = c % 3 == 0 ? 1 : 2;
    for (int i = 0; i < 120; ++i)
      spheres_.push_back({Number(.03, .12), {Number(-1, 1), Number(-1, 1), Number(-1, 1)}});
    for (const SphereSpec& s : spheres_)
      tree_.ForEachOver(BoundsOf(s), [this](CellId c) { ++tree_.cell(c).objects; });
    all_ = Set([](CellId) { return true; });
    own_ = Set([this](CellId c) { return tree_.cell(c).owner == 1; });
  }

  static SceneSpec OnePlacement() {
    SceneSpec spec;
    Placement placement;
    placement.levels.resize(1);
    placement.Finish();
    spec.placements = {placement};
    return spec;
  }
  static Bounds BoundsOf(const SphereSpec& s) {
    Bounds bounds{s.center, s.center};
    bounds.Grow(s.radius);
    return bounds;
  }
  double Number(double low, double high) {
    return low + (high - low) * KeyedRandom(7, RandomUse::kTime, drawn_++);
  }

  // The objects of the cells that are wanted.
  template <class Wanted>
  std::unique_ptr<ObjectSet> Set(Wanted wanted) {
    auto set = std::make_unique<ObjectSet>(&scene_);
    for (size_t i = 0; i < spheres_.size(); ++i) {
      bool in = false;
      tree_.ForEachOver(BoundsOf(spheres_[i]), [&](CellId c) { in = in || wanted(c); });
      if (in) set->Add(spheres_[i], 0, static_cast<Rank>(i + 1));
    }
    set->Build();
    return set;
  }

  std::vector<Ray> Rays(size_t n, double spread) {
    const Vector eye{Number(-3, 3), Number(-3, 3), Number(-3, 3)};
    std::vector<Ray> rays(n);
    for (Ray& ray : rays) {
      ray.origin = eye;
      const Vector aim{Number(-1, 1), Number(-1, 1), Number(-1, 1)};
      ray.direction = Normalized(spread * aim - eye);
    }
    return rays;
  }

  // Fetches what the rays halt at until all are conclusive.
  std::vector<Hit> TraceToTheEnd(CellTracer* tracer, ObjectCache* cache,
                                 std::span<const Ray> rays) {
    const size_t n = rays.size();
    std::vector<Travel> travel(n);
    std::vector<Hit> hits(n);
    std::vector<Halt> halts(n);
    for (int round = 0; round < 50; ++round) {
      tracer->Nearest(rays, travel, hits, halts, &counts_);
      CellId next = kNoCell;
      for (size_t i = 0; i < n; ++i) {
        travel[i].best_distance = hits[i].distance;
        travel[i].best_rank = hits[i].rank;
        travel[i].own_done = true;
        if (halts[i].cell != kNoCell) next = travel[i].resume = halts[i].cell;
      }
      if (next == kNoCell) return hits;
      EXPECT_FALSE(tracer->holds(next));
      cache->Put(next, Set([next](CellId c) { return c == next; }));
    }
    ADD_FAILURE() << "no end";
    return hits;
  }

  CellTree tree_;
  Scene scene_;
  std::vector<SphereSpec> spheres_;
  std::unique_ptr<ObjectSet> all_, own_;
  uint32_t drawn_ = 0;
  OpCounts counts_;
};

TEST_F(CellTracerTest, FindsTheNearestHitsOfTheWholeScene) {
  size_t found = 0;
  for (size_t n : {1u, 1u, 1u, 5u, 64u, 64u, 64u, 64u}) {  // by walk and by clip list
    ObjectCache cache(0);
    CellTracer tracer(&scene_, &tree_, 1, own_.get(), &cache);
    const std::vector<Ray> rays = Rays(n, n == 5 ? 3 : .4);
    std::vector<Hit> expected(n);
    all_->Nearest(rays, expected, &counts_);
    const std::vector<Hit> hits = TraceToTheEnd(&tracer, &cache, rays);
    for (size_t i = 0; i < n; ++i) {
      EXPECT_EQ(hits[i].distance, expected[i].distance);
      EXPECT_EQ(hits[i].rank, expected[i].rank);
      found += hits[i].found();
    }
    EXPECT_GT(cache.bytes(), 0u);
  }
  EXPECT_GT(found, 50u);
}

TEST_F(CellTracerTest, AnAnswerIsConclusiveUpToTheFirstCellThatIsNotHeld) {
  ObjectCache cache(0);
  CellTracer tracer(&scene_, &tree_, 1, own_.get(), &cache);
  size_t halted = 0, ended = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Ray> ray = Rays(1, 1);
    Travel travel;
    Hit hit, whole;
    Halt halt;
    tracer.Nearest(ray, {&travel, 1}, {&hit, 1}, {&halt, 1}, &counts_);
    all_->Nearest(ray, {&whole, 1}, &counts_);
    if (halt.cell == kNoCell) {
      EXPECT_EQ(hit.rank, whole.rank);
      ended += hit.found();
    } else {
      EXPECT_EQ(tree_.cell(halt.cell).owner, 2);
      EXPECT_GE(hit.distance, halt.entry) << "that hit was nearer: it ends the ray";
      EXPECT_GE(whole.distance, halt.entry) << "a hit before the cell was lost";
      ++halted;
    }
  }
  EXPECT_GT(halted, 30u);
  EXPECT_GT(ended, 10u);
}

TEST_F(CellTracerTest, ShadowRaysAreBlockedAsInTheWholeScene) {
  size_t blocked = 0, free = 0;
  for (size_t n : {1u, 1u, 1u, 1u, 64u, 64u, 64u}) {
    ObjectCache cache(0);
    CellTracer tracer(&scene_, &tree_, 1, own_.get(), &cache);
    std::vector<ShadowRay> rays(n);
    std::vector<double> limits(n, 4);
    std::vector<Ray> plain = Rays(n, .6);
    for (size_t i = 0; i < n; ++i) {
      rays[i].ray = plain[i];
      rays[i].limit = limits[i];
    }
    std::vector<uint8_t> expected(n);
    all_->Block(plain, limits, expected, &counts_);
    std::vector<CellTracer::Shadow> shadows(n);
    for (size_t i = 0; i < n; ++i) {
      shadows[i].ray = &rays[i].ray;
      shadows[i].limit = rays[i].limit;
    }
    for (CellId next = 0; next != kNoCell;) {
      tracer.Shadows(shadows, &counts_);
      next = kNoCell;
      for (CellTracer::Shadow& s : shadows) {
        s.own_done = true;
        if (s.halt.cell != kNoCell) next = s.resume = s.halt.cell;
      }
      if (next != kNoCell) cache.Put(next, Set([next](CellId c) { return c == next; }));
    }
    for (size_t i = 0; i < n; ++i) {
      EXPECT_EQ(shadows[i].blocked, expected[i] != 0);
      (expected[i] ? blocked : free) += 1;
    }
  }
  EXPECT_GT(blocked, 20u);
  EXPECT_GT(free, 20u);
}

TEST_F(CellTracerTest, AHitIsFoundAgainByDistanceAndRank) {
  ObjectCache cache(0);
  CellTracer tracer(&scene_, &tree_, 1, own_.get(), &cache);
  size_t located = 0, unheld = 0;
  for (int i = 0; i < 200; ++i) {
    const Ray ray = Rays(1, 1)[0];
    Hit hit;
    all_->Nearest({&ray, 1}, {&hit, 1}, &counts_);
    if (!hit.found()) continue;
    const CellId cell = tree_.At(ray.origin + hit.distance * ray.direction);
    const Hit again = tracer.Locate(ray, hit.distance, hit.rank, &counts_);
    EXPECT_EQ(again.distance, hit.distance);
    EXPECT_EQ(again.rank, hit.rank);
    if (tree_.cell(cell).owner == 1) {
      EXPECT_EQ(again.set, own_.get());
      ++located;
    } else {
      unheld += again.set == nullptr;
    }
  }
  EXPECT_GT(located, 10u);
  EXPECT_GT(unheld, 10u);
}

// What the cost model multiplies: by a clip list each ray is looked at for each cell that is not
// owned; rays that walk alone have no list.
TEST_F(CellTracerTest, RaysLookedAtForTheCellsOfAClipListAreCounted) {
  ObjectCache cache(0);
  CellTracer tracer(&scene_, &tree_, 1, own_.get(), &cache);
  const std::vector<Ray> rays = Rays(64, .4);
  std::vector<Travel> travel(64);
  std::vector<Hit> hits(64);
  std::vector<Halt> halts(64);
  OpCounts alone, bundle, shadow;
  tracer.Nearest({&rays[0], 1}, {&travel[0], 1}, {&hits[0], 1}, {&halts[0], 1}, &alone);
  EXPECT_GT(alone.cell_steps, 0u);
  EXPECT_EQ(alone.cell_tests, 0u);
  tracer.Nearest(rays, travel, hits, halts, &bundle);
  EXPECT_GT(bundle.cell_steps, 0u);
  EXPECT_EQ(bundle.cell_tests, 64 * bundle.cell_steps);

  std::vector<CellTracer::Shadow> shadows(64);
  size_t unblocked = 0;
  for (size_t i = 0; i < 64; ++i) {
    shadows[i].ray = &rays[i];
    shadows[i].limit = 100;
  }
  tracer.Shadows(shadows, &shadow);
  for (const CellTracer::Shadow& s : shadows) unblocked += !s.blocked;
  EXPECT_GT(unblocked, 8u);
  EXPECT_EQ(shadow.cell_tests, unblocked * shadow.cell_steps) << "no cell is there to block more";
}

// So is each hierarchy of a fetched cell, once for all rays of a bundle that are traced through it.
TEST_F(CellTracerTest, TracesThroughFetchedCellsAreCounted) {
  ObjectCache cache(0);
  CellTracer tracer(&scene_, &tree_, 1, own_.get(), &cache);
  const std::vector<Ray> rays = Rays(64, .4);
  TraceToTheEnd(&tracer, &cache, rays);
  std::vector<Travel> travel(64);
  std::vector<Hit> hits(64);
  std::vector<Halt> halts(64);
  const auto traced = [&](std::span<const Ray> some, OpCounts* counts) {
    const uint64_t before = tracer.cache_hits();
    const size_t n = some.size();
    tracer.Nearest(some, {travel.data(), n}, {hits.data(), n}, {halts.data(), n}, counts);
    return tracer.cache_hits() - before;
  };
  uint64_t alone = 0;
  OpCounts one, bundle;
  for (size_t i = 0; i < 64; ++i) alone += traced({&rays[i], 1}, &one);
  EXPECT_GT(alone, 0u);
  EXPECT_EQ(one.cell_traces, alone);
  EXPECT_GT(traced(rays, &bundle), 4 * bundle.cell_traces);
  EXPECT_GT(bundle.cell_traces, 0u);
}

// Where a shadow ray of the rows meets no cell that others own, what is owned says all about it.
TEST_F(CellTracerTest, ShadowRaysThatMeetForeignCellsAreFoundInRows) {
  ObjectCache cache(0);
  CellTracer tracer(&scene_, &tree_, 1, own_.get(), &cache);
  constexpr size_t kRays = 200;
  alignas(64) double origin[3][kRays], direction[3][kRays], limits[kRays], times[kRays] = {};
  uint8_t blocked[kRays], foreign[kRays];
  size_t decided = 0, undecided = 0, taken_for_foreign = 0;
  for (int turn = 0; turn < 30; ++turn) {
    std::vector<Ray> rays(kRays);
    const Vector light{Number(-1, 1), Number(-1, 1), 2};
    for (size_t i = 0; i < kRays; ++i) {
      Ray& ray = rays[i];
      ray.origin = {Number(-1, 1), turn % 3 == 0 ? .1 : Number(-1, 1), turn % 3 == 1 ? 2 : .5};
      const Vector way = light - ray.origin;
      limits[i] = Length(way);
      ray.direction = Normalized(way);
      if (turn % 5 == 0) ray.direction = {0, i % 2 == 0 ? 1e-300 : -1e-300, 1};
      blocked[i] = i % 7 == 0;
      for (int axis = 0; axis < 3; ++axis) {
        origin[axis][i] = ray.origin[axis];
        direction[axis][i] = ray.direction[axis];
      }
    }
    tracer.FindForeign({{origin[0], origin[1], origin[2]},
                        {direction[0], direction[1], direction[2]},
                        limits,
                        times,
                        {light.x, light.y, light.z},
                        2,
                        blocked,
                        nullptr,
                        kRays},
                       foreign, &counts_);
    for (size_t i = 0; i < kRays; ++i) {
      bool meets = false;
      for (CellId c = 0; c < tree_.size(); ++c) {
        if (tracer.owns(c)) continue;
        const RayInterval interval = Intersect(tracer.box(c), rays[i].origin, rays[i].direction);
        meets |= !interval.empty() && interval.exit >= 0 && interval.entry <= limits[i];
      }
      meets &= !blocked[i];
      EXPECT_GE(foreign[i], meets);
      taken_for_foreign += foreign[i] > meets;
      (foreign[i] ? undecided : decided) += 1;
    }
  }
  EXPECT_GT(decided, 1000u);
  EXPECT_GT(undecided, 1000u);
  EXPECT_LT(taken_for_foreign, 10u) << "rounding alone";
}

TEST_F(CellTracerTest, EmptyCellsAreHeldByEveryone) {
  tree_.cell(1).objects = 0;
  tree_.cell(2).resident = true;
  ObjectCache cache(0);
  const CellTracer tracer(&scene_, &tree_, 1, own_.get(), &cache);
  EXPECT_TRUE(tracer.owns(0));
  EXPECT_TRUE(tracer.owns(1));
  EXPECT_TRUE(tracer.owns(2));
  EXPECT_FALSE(tracer.owns(4));
  EXPECT_FALSE(tracer.holds(4));
}

}  // namespace
}  // namespace rayshade::parallel
