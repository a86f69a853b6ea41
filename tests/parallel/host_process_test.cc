// The host when things go wrong: too little memory [RJ table 1, "o.m."], lost and failing
// processes, messages that make no sense.
#include "parallel/host_process.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/hand_driven_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

RunOptions Options(int processes) {
  RunOptions options;
  options.processes = static_cast<uint16_t>(processes);
  options.cell_bytes = 2000;
  return options;
}

std::string FailureOf(const std::string& text, const RunOptions& options) {
  try {
    HandDrivenRun run(text, options);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(HostProcess, SaysWhichProcessNeedsMoreMemoryAndHowManyWouldDo) {
  RunOptions options = Options(2);
  options.memory = 20000;
  const std::string text = FailureOf(Balls(3, 8), options);
  EXPECT_TRUE(Has(text, "out of memory: trace process ")) << text;
  EXPECT_TRUE(Has(text, " needs ")) << text;
  EXPECT_TRUE(Has(text, "--memory allows 20000 bytes")) << text;
  const size_t at = text.find(" processes would do");
  ASSERT_NE(at, std::string::npos) << text;
  const int enough = std::stoi(text.substr(text.rfind(' ', at - 1)));
  ASSERT_GT(enough, 2);
  options.processes = static_cast<uint16_t>(enough);
  EXPECT_EQ(FailureOf(Balls(3, 8), options), "") << "it said that they would do";
}

TEST(HostProcess, SaysThatNoNumberOfProcessesWouldDo) {
  RunOptions options = Options(2);
  options.memory = 100;
  EXPECT_TRUE(Has(FailureOf(Balls(3, 8), options), "no number of processes would do"));
}

class RunningHost : public testing::Test {
 protected:
  RunningHost() : run_(Balls(1, 8), Options(2)) { run_.SetUpAll(); }
  HandDrivenRun run_;
};

TEST_F(RunningHost, ALostProcessEndsTheRun) {
  EXPECT_EQ(run_.host->phase(), HostProcess::Phase::kTrace);
  run_.host->OnLost(2, "its machine is gone");
  EXPECT_EQ(run_.host->phase(), HostProcess::Phase::kFailed);
  EXPECT_TRUE(run_.host->finished());
  EXPECT_EQ(run_.host->failure(), "trace process 2 is lost: its machine is gone");
  run_.host->OnLost(1, "too");
  EXPECT_EQ(run_.host->failure(), "trace process 2 is lost: its machine is gone")
      << "the first reason stands";
}

TEST_F(RunningHost, AFailureEndsTheRunWithItsWords) {
  run_.Tell(1, kHost, Failure{"out of file handles"});
  EXPECT_EQ(run_.host->failure(), "trace process 1: out of file handles");
  EXPECT_TRUE(run_.Work(kHost).empty()) << "nothing more is handed out";
}

TEST_F(RunningHost, TextReachesTheUserOnce) {
  run_.Tell(2, kHost, Text{"a line"});
  EXPECT_EQ(run_.host->TakeTexts(), (std::vector<std::string>{"process 2: a line"}));
  EXPECT_TRUE(run_.host->TakeTexts().empty());
  EXPECT_EQ(run_.host->phase(), HostProcess::Phase::kTrace);
}

TEST(HostProcess, RefusesProcessesWhoseMathematicsDiffer) {
  HandDrivenRun run(Balls(1, 8), Options(2));
  run.Work(kHost);
  run.Tell(1, kHost, Ready{1, 1, 42, "here"});
  run.Tell(2, kHost, Ready{1, 1, 43, "there"});
  EXPECT_EQ(run.host->phase(), HostProcess::Phase::kFailed);
  EXPECT_TRUE(Has(run.host->failure(), "trace process 2 (there)")) << run.host->failure();
}

TEST_F(RunningHost, RefusesMessagesThatMakeNoSense) {
  EXPECT_THROW(run_.Tell(0, kHost, WorkRequest{}), WireError) << "from itself";
  EXPECT_THROW(run_.Tell(3, kHost, WorkRequest{}), WireError) << "from nobody";
  EXPECT_THROW(run_.Tell(1, kHost, Stop{}), WireError) << "not for the host";
  EXPECT_THROW(run_.Tell(1, kHost, PixelResults{{TokenOf({1, 1, 0, true})}, {}, {}}), WireError)
      << "a result without a ray";
  EXPECT_THROW(run_.Tell(1, kHost, ObjectsTaken{}), WireError) << "none were sent";
  EXPECT_THROW(run_.Tell(1, kHost, std::span<const uint8_t>()), WireError);
  EXPECT_EQ(run_.host->phase(), HostProcess::Phase::kTrace) << "and is unharmed";

  run_.Tell(1, kHost, WorkRequest{});
  EXPECT_EQ(run_.Work(kHost).size(), 1u);
  EXPECT_THROW(run_.Tell(1, kHost, PixelResults{{TokenOf({99, 1, 0, true})}, {}, {}}), WireError)
      << "not in the picture";
  EXPECT_EQ(run_.host->samples_done(), 0u);
}

}  // namespace
}  // namespace rayshade::parallel
