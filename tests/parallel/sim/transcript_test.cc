// Transcripts: the paper's flow in text (tests/transcripts/), and the same bytes for the same seed.
#include "parallel/sim/transcript.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "parallel/object_spool.h"
#include "parallel/sim/fault_run.h"
#include "parallel/sim/sim_run.h"
#include "tests/support/parallel_run.h"
#include "tests/support/scenes.h"

namespace rayshade::parallel {
namespace {

// A machine on which only messages take time, so that transcripts change only with the flow.
Machine MachineOfMessages() {
  Machine machine;
  machine.nodes = 4;
  machine.processors = 1;
  machine.memory = 1e9;
  machine.host_apart = 1;
  machine.step = 1e-6;
  machine.send = machine.receive = 1e-5;
  machine.latency = 1e-4;
  machine.jitter = 0.05;
  return machine;
}

std::string TranscriptOf(ObjectSpool* spool, const RunOptions& options, uint64_t seed) {
  std::ostringstream out;
  Transcript transcript(&out);
  SimulatedFrame frame(MachineOfMessages(), options, seed, spool, 0);
  frame.AddListener(&transcript);
  frame.Run();
  return out.str();
}

std::string WholeFile(const std::string& name) {
  std::ifstream file(name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class TranscriptOfSchedule : public testing::TestWithParam<Schedule> {};

TEST_P(TranscriptOfSchedule, IsTheOneThatIsWrittenDown) {
  Options scene;
  scene.input = "tests/transcripts/ball.ray";
  scene.raw_input = true;
  ObjectSpool spool;
  ParseInto(scene, &spool);
  spool.Place(0);
  RunOptions options;
  options.schedule = GetParam();
  options.processes = 2;
  options.pyramid = 4;
  options.resident = 60;  // one of the balls
  const std::string transcript = TranscriptOf(&spool, options, 1);
  const std::string name = std::string("tests/transcripts/") + Name(GetParam()) + ".txt";
  const char* write = std::getenv("TRANSCRIPTS");
  if (write != nullptr && std::string(write) == "write") std::ofstream(name) << transcript;
  EXPECT_EQ(WholeFile(name), transcript);
}

INSTANTIATE_TEST_SUITE_P(Transcript, TranscriptOfSchedule,
                         testing::Values(Schedule::kDataParallel, Schedule::kDemandDriven,
                                         Schedule::kHybrid),
                         [](const auto& info) {
                           std::string name = Name(info.param);
                           std::erase(name, '-');
                           return name;
                         });

TEST(Transcript, IsTheSameForOneSeedAndAnotherForAnother) {
  ObjectSpool spool;
  ParseText(Balls(2, 24), &spool);
  spool.Place(0);
  RunOptions options;
  options.processes = 7;
  options.pyramid = 32;
  options.cell_bytes = 2000;
  options.cache = 5000;
  const std::string first = TranscriptOf(&spool, options, 1);
  EXPECT_GT(first.size(), 10000u);
  EXPECT_EQ(first, TranscriptOf(&spool, options, 1));
  EXPECT_NE(first, TranscriptOf(&spool, options, 2));
}

TEST(Transcript, OfARunUnderFaultsIsTheSameForOneSeed) {
  ObjectSpool spool;
  ParseText(FacingMirrors(), &spool);
  spool.Place(0);
  std::string transcripts[2];
  for (std::string& text : transcripts) {
    std::ostringstream out;
    Transcript transcript(&out);
    FaultRun(PlanFaults(3), &spool, 0, &transcript).Run();
    text = out.str();
  }
  EXPECT_EQ(transcripts[0], transcripts[1]);
  EXPECT_EQ(transcripts[0].rfind("# seed 3: ", 0), 0u);
}

}  // namespace
}  // namespace rayshade::parallel
