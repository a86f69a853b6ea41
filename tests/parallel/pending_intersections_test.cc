// Slots for intersections whose rays are on their way.
#include "parallel/pending_intersections.h"

#include <gtest/gtest.h>

namespace rayshade::parallel {
namespace {

TEST(PendingIntersections, ASlotStaysWhereItIsUntilItIsFreed) {
  PendingIntersections pending;
  const uint32_t first = pending.Allocate();
  PendingIntersection* at = &pending.at(first);
  at->distance = 7;
  for (int i = 0; i < 1000; ++i) pending.Allocate();
  EXPECT_EQ(&pending.at(first), at);
  EXPECT_EQ(pending.at(first).distance, 7);
  EXPECT_EQ(pending.size(), 1001u);
}

TEST(PendingIntersections, FreedSlotsAreUsedAgain) {
  PendingIntersections pending;
  pending.Allocate();
  const uint32_t slot = pending.Allocate();
  const size_t bytes = pending.bytes();
  pending.Free(slot);
  EXPECT_EQ(pending.size(), 1u);
  EXPECT_EQ(pending.Allocate(), slot);
  EXPECT_EQ(pending.bytes(), bytes);
}

TEST(PendingIntersections, AResultForNoIntersectionIsAnError) {
  PendingIntersections pending;
  EXPECT_THROW(pending.at(0), WireError);
  const uint32_t slot = pending.Allocate();
  EXPECT_NO_THROW(pending.at(slot));
  EXPECT_THROW(pending.at(slot + 1), WireError);
  EXPECT_THROW(pending.at(~uint64_t{0} >> 1), WireError);
  pending.Free(slot);
  EXPECT_THROW(pending.at(slot), WireError);
  EXPECT_THROW(pending.Free(slot), WireError);
}

}  // namespace
}  // namespace rayshade::parallel
