// Cells and who owns them.
#include "parallel/voxel_distribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

class VoxelDistribution : public testing::Test {
 protected:
  VoxelDistribution() {
    ParseText(Balls(3, 8), &spool_);
    spool_.Place(0);
  }
  ObjectSpool spool_;
};

TEST_F(VoxelDistribution, TheLargestCountOfTheGridLiesAlongTheLongestSide) {
  EXPECT_EQ(GridCounts(1, {1, 1, 1}), (std::array<int, 3>{1, 1, 1}));
  EXPECT_EQ(GridCounts(7, {1, 5, 2}), (std::array<int, 3>{1, 7, 1}));
  EXPECT_EQ(GridCounts(8, {1, 5, 2}), (std::array<int, 3>{2, 2, 2}));
  EXPECT_EQ(GridCounts(12, {1, 2, 3}), (std::array<int, 3>{2, 2, 3}));
  EXPECT_EQ(GridCounts(32, {3, 2, 1}), (std::array<int, 3>{4, 4, 2}));
  for (int n = 1; n < 200; ++n) {
    const auto counts = GridCounts(n, {2, 3, 1});
    EXPECT_EQ(counts[0] * counts[1] * counts[2], n);
  }
}

TEST_F(VoxelDistribution, CellsAreCutUntilTheyHoldNoMoreThanTheirLimit) {
  RunOptions options;
  options.cell_bytes = 3000;
  const CellTree tree = BuildTree(options, &spool_);
  std::vector<uint32_t> objects(tree.size());
  std::vector<uint64_t> bytes(tree.size());
  SpooledObject object;
  uint64_t one = 0;
  for (spool_.Rewind(); spool_.Next(false, &object);) {
    one = std::max(one, object.bytes);
    tree.ForEachOver(object.bounds, [&](CellId c) {
      ++objects[c];
      bytes[c] += object.bytes;
    });
  }
  size_t full = 0;
  for (CellId c = 0; c < tree.size(); ++c) {
    EXPECT_EQ(tree.cell(c).objects, objects[c]);
    EXPECT_EQ(tree.cell(c).bytes, bytes[c]);
    full += bytes[c] > options.cell_bytes + one;
  }
  EXPECT_GT(tree.size(), 20u);
  EXPECT_LE(full, tree.size() / 20) << "but where objects crowd in a point";
}

TEST_F(VoxelDistribution, BytesHeldCountsAnObjectOnceForEachHolder) {
  RunOptions options;
  options.processes = 3;
  CellTree tree = BuildTree(options, &spool_);
  uint64_t all = 0;
  SpooledObject object;
  for (spool_.Rewind(); spool_.Next(false, &object);) all += object.bytes;
  const std::vector<uint64_t> held = BytesHeld(options, tree, &spool_);
  ASSERT_EQ(held.size(), 3u);
  EXPECT_GE(held[0] + held[1] + held[2], all);
  for (uint64_t h : held) EXPECT_LT(h, all);
  for (CellId c = 0; c < tree.size(); ++c) tree.cell(c).resident = true;
  for (uint64_t h : BytesHeld(options, tree, &spool_)) EXPECT_EQ(h, all);
}

TEST_F(VoxelDistribution, TheResidentSetKeepsItsBudget) {
  RunOptions options;
  options.cell_bytes = 2000;
  const CellTree tree = BuildTree(options, &spool_);
  size_t before = 0;
  for (uint64_t budget : {0u, 5000u, 20000u, 10000000u}) {
    CellTree marked = tree;
    ChooseResidentSet({2, 1, 1}, budget, &marked);
    uint64_t bytes = 0;
    size_t cells = 0;
    for (CellId c = 0; c < marked.size(); ++c) {
      bytes += marked.cell(c).resident ? marked.cell(c).bytes : 0;
      cells += marked.cell(c).resident;
    }
    EXPECT_LE(bytes, budget);
    EXPECT_GE(cells, before);
    before = cells;
  }
  EXPECT_EQ(before, tree.size()) << "a budget for everything";
}

TEST_F(VoxelDistribution, ProcessesThatWouldDoReallyDo) {
  RunOptions options;
  options.processes = 2;
  options.cell_bytes = ~uint32_t{0};
  const auto two = BytesHeld(options, BuildTree(options, &spool_), &spool_);
  const uint64_t memory = *std::max_element(two.begin(), two.end()) / 3;
  const int enough = ProcessesThatWouldDo(memory, 100, &spool_);
  ASSERT_GT(enough, 2);
  options.processes = static_cast<uint16_t>(enough);
  for (uint64_t held : BytesHeld(options, BuildTree(options, &spool_), &spool_))
    EXPECT_LE(held + 100, memory);
  EXPECT_EQ(ProcessesThatWouldDo(50, 100, &spool_), 0) << "not even the spare fits";
}

}  // namespace
}  // namespace rayshade::parallel
