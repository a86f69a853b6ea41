// What [RJ s.1] says of the demand driven approach, which is a schedule of its own here.
#include <gtest/gtest.h>

#include <map>

#include "tests/paper/ray_trail.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

// "The most common way to parallelise ray tracing is the demand driven approach where each
// processor is assigned a part of the image"
TEST(PaperSection1, DemandDrivenEachProcessFinishesItsPartOfTheImageItself) {
  const RecordedRun run = RecordRun(Balls(3, 32), ManyCells(Schedule::kDemandDriven, 5), 1);
  for (Tag tag : {Tag::kRayTask, Tag::kIntersectionTask, Tag::kRayResults})
    EXPECT_EQ(run.Count(tag), 0u) << NameOf(tag);
  std::map<uint64_t, ProcessId> given;
  size_t pixels = 0;
  for (const SentMessage& s : run.sent) {
    if (s.tag == Tag::kPrimaryRays) {
      for (uint64_t token : Decode<PrimaryRays>(s.bytes).samples.tokens()) given[token] = s.to;
    }
    for (const Pixel& item : RecordedRun::Pixels(s)) {
      EXPECT_EQ(given.at(item.token), s.from);
      ++pixels;
    }
  }
  EXPECT_EQ(pixels, 32u * 33u);
}

// "it requires either the data to be duplicated with each processor, thereby limiting the model
// size, or objects have to be communicated on request". Here: on request, from their owners.
TEST(PaperSection1, DemandDrivenObjectsAreCommunicatedOnRequest) {
  const RecordedRun run = RecordRun(Balls(3, 32), ManyCells(Schedule::kDemandDriven, 5), 1);
  std::map<std::pair<ProcessId, CellId>, int> open;
  size_t replies = 0;
  for (const SentMessage& s : run.sent) {
    if (s.tag == Tag::kCellRequest) {
      const CellId cell = Decode<CellRequest>(s.bytes).cell;
      EXPECT_EQ(run.tree.cell(cell).owner, s.to);
      ++open[{s.from, cell}];
    } else if (s.tag == Tag::kCellReply) {
      const CellReply reply = Decode<CellReply>(s.bytes);
      EXPECT_EQ((open[{s.to, reply.cell}]--), 1) << "a cell that was not asked for";
      EXPECT_GE(reply.parcel.objects.size(), run.tree.cell(reply.cell).objects);
      ++replies;
    }
  }
  EXPECT_GT(replies, 20u);
}

}  // namespace
}  // namespace rayshade::parallel
