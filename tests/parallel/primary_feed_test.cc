// Which pyramid answers a request, and how primary rays leave a data-parallel host.
#include "parallel/primary_feed.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "parallel/message.h"

namespace rayshade::parallel {
namespace {

class Sent : public Outbox {
 public:
  void Send(ProcessId to, std::vector<uint8_t> bytes) override {
    to_.push_back(to);
    tokens_.push_back(Decode<PrimaryRays>(bytes).samples.tokens());
  }
  std::vector<ProcessId> to_;
  std::vector<std::vector<uint64_t>> tokens_;
};

// A picture of 8 x 8 pixels: on the left process 1 is expected to own what is hit, on the right
// process 2, in the middle nothing is hit.
class Pyramids : public testing::Test {
 protected:
  Pyramids() {
    settings_.width = settings_.height = 8;
    settings_.samples = 1;
    settings_.jitter = false;
    camera_ = std::make_unique<Camera>(settings_, 0);
    sampling_ = std::make_unique<PixelSampling>(settings_, *camera_, true);
    tree_.Cut(0, 0, .5);
    tree_.cell(0).owner = 1;
    tree_.cell(1).owner = 2;
    hits_.across = 4;
    for (int row = 0; row < 4; ++row) {
      for (CellId c : {CellId{0}, kNoCell, kNoCell, CellId{1}}) hits_.cells.push_back(c);
    }
  }

  // Answers one request after the other of the same process.
  void Ask(PyramidFeed* feed, ProcessId process, int requests) {
    for (int i = 0; i < requests; ++i) {
      feed->OnRequest(process);
      feed->HandOut(1000, sampling_.get(), &sent_);
    }
  }
  int ColumnOf(size_t message) const { return SampleOf(sent_.tokens_.at(message).at(0)).x / 2; }

  Settings settings_;
  std::unique_ptr<Camera> camera_;
  std::unique_ptr<PixelSampling> sampling_;
  CellTree tree_{Bounds{{0, 0, 0}, {1, 1, 1}}};
  PredictedHits hits_;
  Sent sent_;
};

TEST_F(Pyramids, ComeInThePicturesOrderWhereNothingIsExpected) {
  PyramidFeed feed(4, 2, ExpectedOwners());
  Ask(&feed, 2, 4);
  for (size_t m = 0; m < 4; ++m) EXPECT_EQ(ColumnOf(m), int(m));
}

TEST_F(Pyramids, OfTheAskingProcessComeFirstThenVoidsThenThoseOfOthers) {
  PyramidFeed feed(4, 2, ExpectedOwners(hits_, tree_, camera_->window()));
  Ask(&feed, 2, 100);
  std::set<uint64_t> seen;
  std::vector<Sample> samples;  // of the picture
  for (size_t m = 0; m < sent_.tokens_.size(); ++m) {
    EXPECT_EQ(sent_.to_[m], 2);
    for (const uint64_t token : sent_.tokens_[m]) {
      seen.insert(token);
      if (SampleOf(token).y < 8) samples.push_back(SampleOf(token));
    }
  }
  EXPECT_EQ(seen.size(), 8u * 9) << "every sample once, the row below the picture as well";
  ASSERT_EQ(samples.size(), 8u * 8);
  const auto column = [&](size_t i) { return samples[i].x / 2; };
  for (size_t i = 0; i < 16; ++i) EXPECT_EQ(column(i), 3) << i;
  for (size_t i = 16; i < 48; ++i) EXPECT_TRUE(column(i) == 1 || column(i) == 2) << i;
  for (size_t i = 48; i < 64; ++i) EXPECT_EQ(column(i), 0) << i;
}

TEST_F(Pyramids, ComeFourAtOnceWhileMuchWorkIsLeft) {
  PyramidFeed feed(2, 1, ExpectedOwners());
  Ask(&feed, 1, 100);
  EXPECT_EQ(sent_.tokens_.front().size(), 4u * 2);
  EXPECT_LE(sent_.tokens_.back().size(), 2u);
  size_t samples = 0;
  for (const auto& tokens : sent_.tokens_) samples += tokens.size();
  EXPECT_EQ(samples, 8u * 9);
}

TEST_F(Pyramids, SixteenThatHitNothingCountAsOneAndThirtyTwoAreMost) {
  hits_.cells.assign(hits_.cells.size(), kNoCell);
  settings_.width = 64;
  camera_ = std::make_unique<Camera>(settings_, 0);
  sampling_ = std::make_unique<PixelSampling>(settings_, *camera_, true);
  PyramidFeed voids(1, 1, ExpectedOwners(hits_, tree_, camera_->window()));
  Ask(&voids, 1, 100);
  EXPECT_EQ(sent_.tokens_.at(0).size(), 32u);
  for (size_t m = 0; m + 1 < sent_.tokens_.size(); ++m) {
    EXPECT_GE(sent_.tokens_[m].size(), 16u) << "at the end as well: they are traced in no time";
  }
  EXPECT_EQ(sent_.tokens_.at(sent_.tokens_.size() - 2).size(), 16u);
}

TEST_F(Pyramids, AtOnceAreNoMoreThanThereIsRoomFor) {
  PyramidFeed feed(2, 1, ExpectedOwners());
  feed.OnRequest(1);
  EXPECT_EQ(feed.HandOut(5, sampling_.get(), &sent_), 4u);
  EXPECT_EQ(sent_.tokens_.at(0).size(), 4u);
}

TEST_F(Pyramids, AreNotLostWhenTwoProcessesAskInTurn) {
  PyramidFeed feed(4, 2, ExpectedOwners(hits_, tree_, camera_->window()));
  for (int i = 0; i < 50; ++i) {
    Ask(&feed, 1, 1);
    Ask(&feed, 2, 1);
  }
  size_t samples = 0;
  for (const auto& tokens : sent_.tokens_) samples += tokens.size();
  EXPECT_EQ(samples, 8u * 9);
  EXPECT_EQ(ColumnOf(0), 0);
  EXPECT_EQ(ColumnOf(1), 3);
}

struct CountRayTasks : Outbox {
  void Send(ProcessId to, std::vector<uint8_t> bytes) override {
    by_process[to] += Decode<RayTask>(bytes).primary.size();
    ++messages;
  }
  std::map<ProcessId, size_t> by_process;
  size_t messages = 0;
};

// A step is bounded, however much room there is; a pack that is not full waits for the next step.
TEST(DataParallelFeed, HandsOutAThousandRaysAStepAndKeepsPacksThatAreNotFull) {
  Settings settings;
  settings.width = 64;
  settings.height = 40;
  settings.samples = 1;
  settings.jitter = false;
  const Camera camera(settings, 0);
  PixelSampling sampling(settings, camera, true);
  CellTree tree(Bounds{{0, 0, 0}, {1, 1, 1}});
  DataParallelFeed feed(&camera, &tree, 2);  // nothing is there: the rays go in turn
  CountRayTasks sent;
  size_t handed_out = 0;
  while (const size_t more = feed.HandOut(100000, &sampling, &sent)) {
    EXPECT_LE(more, 1024u);
    handed_out += more;
    EXPECT_EQ(handed_out, sent.by_process[1] + sent.by_process[2] + feed.unsent());
  }
  EXPECT_EQ(handed_out, 64u * 41) << "the row below the picture as well";
  EXPECT_EQ(sent.messages, 2u) << "each holds what is sent when a pack is full";
  EXPECT_GT(feed.unsent(), 0u);
  feed.Flush(&sent);
  EXPECT_EQ(feed.unsent(), 0u);
  EXPECT_EQ(sent.by_process[1] + sent.by_process[2], handed_out);
  EXPECT_LE(sent.by_process[1] - sent.by_process[2], 1u);
}

}  // namespace
}  // namespace rayshade::parallel
