// The subdivision: boxes, places, what comes out of bytes.
#include "parallel/cell_tree.h"

#include <gtest/gtest.h>

#include "rayshade/common/keyed_random.h"

namespace rayshade::parallel {
namespace {

CellTree FourCells() {
  CellTree tree({{0, 0, 0}, {4, 4, 4}});
  const CellId right = tree.Cut(0, 0, 2);
  tree.cell(right).owner = 2;
  tree.Cut(right, 1, 1);
  tree.Cut(0, 2, 3);
  return tree;
}

TEST(CellTree, APointLiesInTheBoxOfItsCell) {
  const CellTree tree = FourCells();
  const std::vector<Bounds> boxes = tree.Boxes();
  for (uint32_t i = 0; i < 500; ++i) {
    const auto number = [i](uint32_t n) { return 4 * KeyedRandom(1, RandomUse::kTime, 3 * i + n); };
    const Vector point{number(0), number(1), number(2)};
    EXPECT_TRUE(boxes[tree.At(point)].Contains(point));
  }
}

TEST(CellTree, ABorderBelongsToTheUpperCellAndWhatIsOutsideToNone) {
  const CellTree tree = FourCells();
  EXPECT_EQ(tree.cell(tree.At({2, 0, 0})).owner, 2);
  EXPECT_EQ(tree.cell(tree.At({1.999, 0, 0})).owner, 1);
  EXPECT_NE(tree.At({4, 4, 4}), kNoCell);
  EXPECT_EQ(tree.At({4.001, 1, 1}), kNoCell);
}

TEST(CellTree, BothHalvesOfACutCellHaveItsOwner) {
  const CellTree tree = FourCells();
  ASSERT_EQ(tree.size(), 4u);
  int of_two = 0;
  for (CellId c = 0; c < 4; ++c) of_two += tree.cell(c).owner == 2;
  EXPECT_EQ(of_two, 2);
}

TEST(CellTree, GoesThroughBytesUnharmed) {
  CellTree tree = FourCells(), back;
  tree.cell(3) = {2, true, 17, 1234};
  ByteWriter w;
  w.Put(tree);
  ByteReader r(w.bytes());
  r.Get(back);
  r.ExpectEnd();
  EXPECT_EQ(back.Boxes(), tree.Boxes());
  EXPECT_EQ(back.cell(3).bytes, 1234u);
  EXPECT_TRUE(back.cell(3).resident);
  back.Cut(2, 0, .5);  // it can go on growing
  EXPECT_EQ(back.size(), 5u);
}

// Bytes of a tree with these nodes and so many cells.
std::vector<uint8_t> BytesOf(std::vector<CellNode> nodes, size_t cells) {
  ByteWriter w;
  Bounds bounds{{0, 0, 0}, {1, 1, 1}};
  std::vector<Cell> list(cells);
  w.Put(bounds);
  w.Put(nodes);
  w.Put(list);
  return w.Take();
}

TEST(CellTree, WhatIsNoTreeIsAnError) {
  const auto read = [](const std::vector<uint8_t>& bytes) {
    CellTree tree;
    ByteReader r(bytes);
    r.Get(tree);
  };
  const CellNode leaf0{3, 0, 0, 0}, leaf1{3, 0, 1, 0};
  EXPECT_NO_THROW(read(BytesOf({{0, .5, 1, 2}, leaf0, leaf1}, 2)));
  EXPECT_THROW(read(BytesOf({}, 0)), WireError) << "nothing";
  EXPECT_THROW(read(BytesOf({{0, .5, 0, 1}, leaf0}, 1)), WireError) << "its own child";
  EXPECT_THROW(read(BytesOf({{0, .5, 1, 7}, leaf0, leaf1}, 2)), WireError) << "no such child";
  EXPECT_THROW(read(BytesOf({{0, .5, 1, 2}, leaf0, leaf0}, 1)), WireError) << "a cell twice";
  EXPECT_THROW(read(BytesOf({{0, .5, 1, 2}, leaf0, leaf1}, 3)), WireError) << "a cell nowhere";
  EXPECT_THROW(read(BytesOf({{4, .5, 1, 2}, leaf0, leaf1}, 2)), WireError) << "a fourth axis";
  EXPECT_THROW(read(BytesOf({{3, 0, 9, 0}}, 1)), WireError) << "no such cell";
}

TEST(Intersect, IntervalsOfNeighboursOverlapAtTheirBorder) {
  for (uint32_t i = 0; i < 2000; ++i) {
    const auto number = [i](uint32_t n) {
      return 2 * KeyedRandom(2, RandomUse::kTime, 6 * i + n) - 1;
    };
    const Vector origin{number(0) - 5, number(1), number(2)};
    const Vector direction = Normalized({1, .2 * number(3), .2 * number(4)});
    const double border = number(5);
    const RayInterval near = Intersect({{-9, -9, -9}, {border, 9, 9}}, origin, direction);
    const RayInterval far = Intersect({{border, -9, -9}, {9, 9, 9}}, origin, direction);
    EXPECT_GE(near.exit, far.entry);
  }
}

TEST(Intersect, ARayAlongAFaceIsInTheBox) {
  const Bounds box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_FALSE(Intersect(box, {-1, 0, 0}, {1, 0, 0}).empty());
  EXPECT_FALSE(Intersect(box, {-1, 1, 1}, {1, 0, 0}).empty());
  EXPECT_TRUE(Intersect(box, {-1, 1.001, 1}, {1, 0, 0}).empty());
}

}  // namespace
}  // namespace rayshade::parallel
