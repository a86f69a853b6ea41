// Samples in messages as runs.
#include "parallel/sample_runs.h"

#include <gtest/gtest.h>

namespace rayshade::parallel {
namespace {

// A picture of 300 x 2 pixels, up to 2 x 2 samples for each.
class Runs : public testing::Test {
 protected:
  Runs() {
    settings_.width = 300;
    settings_.height = 2;
    camera_ = std::make_unique<Camera>(settings_, 0);
  }
  void ExpectRefused(const SampleRuns& runs) { EXPECT_THROW(runs.Check(*camera_, 2), WireError); }
  Settings settings_;
  std::unique_ptr<Camera> camera_;
};

std::vector<uint64_t> Row(int x, int y, int count, int sub_cell = 0) {
  std::vector<uint64_t> tokens;
  for (int i = 0; i < count; ++i)
    tokens.push_back(TokenOf({x + i, y, static_cast<uint16_t>(sub_cell), true}));
  return tokens;
}

SampleRuns RunsOf(const std::vector<uint64_t>& tokens) {
  SampleRuns runs;
  for (const uint64_t token : tokens) runs.Add(token);
  return runs;
}

TEST_F(Runs, KeepOrderAndNumberOfWhatTheyAreGiven) {
  std::vector<uint64_t> tokens = Row(7, 0, 290);
  for (const auto& more : {Row(9, 1, 3), Row(12, 1, 3, 1), Row(3, 1, 2), Row(3, 1, 2)})
    tokens.insert(tokens.end(), more.begin(), more.end());
  const SampleRuns runs = RunsOf(tokens);
  EXPECT_EQ(runs.size(), tokens.size());
  EXPECT_EQ(runs.tokens(), tokens);
  EXPECT_EQ(runs.runs().size(), 3u + 4) << "three for the first row: at most 128 in one";
  runs.Check(*camera_, 2);
}

TEST_F(Runs, TakeAWordOnTheWireWhateverIsInThem) {
  ByteWriter w;
  w.Put(RunsOf(Row(0, 0, 128)));
  EXPECT_EQ(w.size(), 4u + 8);
  SampleRuns read;
  ByteReader(w.bytes()).Get(read);
  EXPECT_EQ(read.size(), 128u);
  EXPECT_EQ(read.tokens(), Row(0, 0, 128));
}

TEST_F(Runs, AreShortenedFromTheBeginning) {
  SampleRun run = RunsOf(Row(5, 1, 100)).runs().front();
  run.Shorten(40);
  EXPECT_EQ(run.count(), 60u);
  EXPECT_EQ(run.first(), TokenOf({45, 1, 0, true}));
}

TEST_F(Runs, BeyondThePictureAreRefused) {
  ExpectRefused(RunsOf(Row(299, 0, 2)));
  ExpectRefused(RunsOf(Row(0, 3, 1)));
  ExpectRefused(RunsOf(Row(0, 0, 1, 4)));
}

TEST_F(Runs, EndAtTheLastColumnThatATokenTells) {
  EXPECT_EQ(RunsOf({TokenOf({0xffffff, 0, 0, true}), TokenOf({0, 1, 0, true})}).runs().size(), 2u);
}

}  // namespace
}  // namespace rayshade::parallel
