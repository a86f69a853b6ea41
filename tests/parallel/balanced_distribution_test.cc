// Cells shared out by predicted work.
#include "parallel/balanced_distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "parallel/host_process.h"
#include "parallel/voxel_distribution.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

RunOptions SmallCells(int processes) {
  RunOptions options;
  options.processes = static_cast<uint16_t>(processes);
  options.cell_bytes = 2000;
  return options;
}

class Balanced : public testing::Test {
 protected:
  Balanced() {
    ParseText(Balls(3, 64), &spool_);
    spool_.Place(0);
    camera_ = std::make_unique<Camera>(spool_.scene().settings, 0);
  }
  ObjectSpool spool_;
  std::unique_ptr<Camera> camera_;
};

TEST_F(Balanced, WhatIsInFrontIsPredictedToBeHit) {
  const CellTree tree = BuildTree(SmallCells(1), &spool_);
  const std::vector<double> hits = PredictHits(*camera_, tree, &spool_).by_cell;
  EXPECT_LE(std::accumulate(hits.begin(), hits.end(), 0.0), 1);
  const std::vector<Bounds> boxes = tree.Boxes();
  double near = 0, far = 0;
  for (CellId c = 0; c < tree.size(); ++c) {
    EXPECT_TRUE(tree.cell(c).objects > 0 || hits[c] == 0);
    const Vector middle = 0.5 * (boxes[c].low + boxes[c].high);
    (Dot(middle, camera_->eye()) > 0 ? near : far) += hits[c];
  }
  EXPECT_GT(near, 5 * far) << "the ball in the middle hides the far side";
}

TEST_F(Balanced, OwnersAreExpectedWhereTheyAre) {
  const CellTree tree = BuildTree(SmallCells(1), &spool_);
  const PredictedHits hits = PredictHits(*camera_, tree, &spool_);
  const TestPicture picture = RenderSequentially(Balls(3, 64));
  int wrong = 0;
  for (int i = 0; i < hits.across * hits.across; ++i) {
    const int x = i % hits.across * 64 / hits.across, y = i / hits.across * 64 / hits.across;
    wrong += (hits.cells[i] != kNoCell) != (picture.picture.at(x, y).alpha > 0);
  }
  EXPECT_LT(wrong, hits.across * hits.across / 1000) << "balls are the ellipsoids in their boxes";
}

TEST_F(Balanced, EachProcessGetsItsPartOfTheWeight) {
  for (int processes : {1, 2, 3, 7, 24}) {
    CellTree tree = BuildTree(SmallCells(processes), &spool_);
    const auto work = WorkByCell(PredictHits(*camera_, tree, &spool_).by_cell, tree);
    ShareOut(work, processes, &tree);
    std::vector<double> shares(processes);
    for (CellId c = 0; c < tree.size(); ++c) shares.at(tree.cell(c).owner - 1u) += work[c];
    const double most = *std::max_element(work.begin(), work.end());
    for (double share : shares) EXPECT_NEAR(share, 1.0 / processes, most + 1e-9) << processes;
  }
}

TEST_F(Balanced, WithoutAnyWeightTheFirstProcessOwnsAll) {
  CellTree tree(Bounds{{0, 0, 0}, {1, 1, 1}});
  tree.Cut(0, 0, .5);
  ShareOut(BytesByCell(tree), 5, &tree);
  EXPECT_EQ(tree.cell(0).owner, 1);
  EXPECT_EQ(tree.cell(1).owner, 1);
}

TEST_F(Balanced, WhereWorkDoesNotFitBytesAreSharedOut) {
  RunOptions options = SmallCells(8);
  options.distribution = Distribution::kBalanced;
  options.memory = 0;
  const HostProcess by_work(options, &spool_, 0);
  const auto bytes = BytesHeld(options, by_work.tree(), &spool_);
  const uint64_t fullest = *std::max_element(bytes.begin(), bytes.end());
  options.memory = fullest;  // and no room for two cells of others
  const HostProcess by_bytes(options, &spool_, 0);
  const auto even = BytesHeld(options, by_bytes.tree(), &spool_);
  EXPECT_LT(*std::max_element(even.begin(), even.end()), fullest);
}

TEST(BalancedPictures, AreTheSequentialOnes) {
  for (const std::string& text : {Balls(3, 32), GlassScene()}) {
    const TestPicture sequential = RenderSequentially(text);
    for (Schedule schedule :
         {Schedule::kDataParallel, Schedule::kDemandDriven, Schedule::kHybrid}) {
      for (int processes : {1, 4, 7}) {
        RunOptions options = SmallCells(processes);
        options.schedule = schedule;
        options.distribution = Distribution::kBalanced;
        EXPECT_TRUE(Identical(RenderInParallel(text, options, 1).picture, sequential.picture))
            << Name(schedule) << " " << processes;
      }
    }
  }
}

}  // namespace
}  // namespace rayshade::parallel
