// Texts of machines: what they must say, and where mistakes are.
#include "parallel/sim/machine.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "parallel/sim/timing.h"

namespace rayshade::parallel {
namespace {

std::string Text(const char* name) {
  for (const BuiltInMachine& m : BuiltInMachines())
    if (std::string(m.name) == name) return m.text;
  return "";
}

std::string ComplaintAbout(const std::string& text) {
  try {
    ParseMachine("box.machine", text);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "";
}

// The line of the text that begins with this word, replaced.
std::string With(std::string text, const std::string& word, const std::string& line) {
  const size_t at = text.find("\n" + word) + 1;
  return text.replace(at, text.find('\n', at) - at, line);
}

TEST(Machine, ThereAreThePapersAndTwoClusters) {
  for (const char* name : {"powerxplorer", "cluster-1g", "cluster-100g"})
    EXPECT_NO_THROW(FindMachine(name)) << name;
  EXPECT_EQ(FindMachine("powerxplorer").nodes, 32);
  EXPECT_EQ(FindMachine("powerxplorer").memory, 32 << 20);
}

TEST(Machine, MistakesAreToldWithFileAndLine) {
  const std::string text = Text("powerxplorer");
  EXPECT_EQ(ComplaintAbout(text), "");
  EXPECT_EQ(ComplaintAbout(With(text, "nodes", "cores 4 paper")),
            "box.machine:2: no machine has a \"cores\"");
  EXPECT_EQ(ComplaintAbout(With(text, "nodes", "nodes many paper")),
            "box.machine:2: nodes must be a number, not negative");
  EXPECT_EQ(ComplaintAbout(With(text, "nodes", "nodes -1 paper")),
            "box.machine:2: nodes must be a number, not negative");
  EXPECT_EQ(ComplaintAbout(With(text, "nodes", "nodes 32")),
            "box.machine:2: nodes must say where it is from: paper, manual, measured, fitted or "
            "assumed");
  EXPECT_EQ(ComplaintAbout(With(text, "processors", "nodes 1 paper")),
            "box.machine:3: nodes is there twice");
  EXPECT_NE(ComplaintAbout(With(text, "nodes", "")).find("nodes is missing"), std::string::npos);
  EXPECT_NE(ComplaintAbout(With(text, "slowness", "slowness 0 fitted")).find("slowness"),
            std::string::npos);
}

TEST(Machine, AFileThatIsNotThereIsNamedBesideTheMachinesThatAre) {
  try {
    FindMachine("/nowhere/box.machine");
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(),
                 "--machine /nowhere/box.machine: neither a machine (cluster-100g, cluster-1g, "
                 "powerxplorer) nor a file that can be read");
  }
}

// [RJ s.5]: the sequential times are those of an R8000; what a node takes longer is one number.
TEST(Machine, ANodeIsSlowerThanTheProcessorOfTheSequentialTimes) {
  Machine machine = FindMachine("powerxplorer");
  WorkDone work;
  work.counts.node_visits = 1000;
  work.counts.shades = 10;
  const double before = CostOf(machine, work);
  machine.node_slowness *= 2;
  EXPECT_DOUBLE_EQ(CostOf(machine, work), 2 * before);
}

// The sequential renderer hands no ray on and takes none up, a trace process none of its pyramids.
TEST(Machine, ARayCostsATraceProcessMoreThanTheSequentialRenderer) {
  Machine machine = FindMachine("cluster-1g");
  machine.slowness = 3;
  machine.step = 0;
  machine.jitter = 0;
  machine.ray = 1;
  machine.process_ray = 10;
  WorkDone work;
  work.counts.primary_rays = 7;
  work.counts.shadow_rays = 5;
  EXPECT_DOUBLE_EQ(CostOf(machine, work), 36);
  EXPECT_DOUBLE_EQ(MachineTiming(machine, 2, 1).StepSeconds(1, work), 36);
  work.rays_handled = 2;
  EXPECT_DOUBLE_EQ(CostOf(machine, work), 36);
  EXPECT_DOUBLE_EQ(MachineTiming(machine, 2, 1).StepSeconds(1, work), 96);
}

// What is fetched while tracing, at both ends, does not cost what was stored before.
TEST(Machine, StoredFetchedAndLentObjectsHaveCostsOfTheirOwn) {
  Machine machine = FindMachine("cluster-1g");
  machine.object = 1;
  machine.fetched_object = 10;
  machine.lent_object = 100;
  machine.cell_test = 1000;
  machine.cell_trace = 10000;
  WorkDone work;
  work.objects_taken = 1;
  EXPECT_DOUBLE_EQ(CostOf(machine, work), 1);
  work.objects_fetched = 2;
  EXPECT_DOUBLE_EQ(CostOf(machine, work), 21);
  work.objects_lent = 3;
  EXPECT_DOUBLE_EQ(CostOf(machine, work), 321);
  work.counts.cell_tests = 4;
  EXPECT_DOUBLE_EQ(CostOf(machine, work), 4321);
  work.counts.cell_traces = 5;
  EXPECT_DOUBLE_EQ(CostOf(machine, work), 54321);
}

TEST(MachineTiming, AMessageTakesLatencyAndTheGapOfItsBytesAndWaitsForThePortsInItsWay) {
  Machine machine = FindMachine("cluster-1g");
  machine.shared_gap = 0;
  MachineTiming timing(machine, 5, 1);
  const double alone = machine.latency + 1e6 * machine.gap;
  EXPECT_DOUBLE_EQ(timing.ArrivalTime(1, 2, 1000000, 0), alone);
  EXPECT_DOUBLE_EQ(timing.ArrivalTime(3, 4, 1000000, 0), alone) << "ports of other nodes";
  EXPECT_DOUBLE_EQ(timing.ArrivalTime(1, 4, 1000000, 0), alone + 1e6 * machine.gap)
      << "behind the first at its sender";
}

// Two processors, the host beside two trace processes: three that are busy at once share them.
TEST(MachineTiming, ProcessesOfANodeShareItsProcessors) {
  Machine machine = FindMachine("cluster-1g");
  machine.processors = 2;
  machine.host_apart = 0;
  MachineTiming timing(machine, 5, 1);
  EXPECT_DOUBLE_EQ(timing.FreeAt(1, 1, 0), 1);
  EXPECT_DOUBLE_EQ(timing.FreeAt(2, 1, 0), 1);
  EXPECT_DOUBLE_EQ(timing.FreeAt(3, 1, 0), 1) << "on another node";
  EXPECT_DOUBLE_EQ(timing.FreeAt(kHost, 1, 0.5), 2) << "the third of three on two processors";
  EXPECT_DOUBLE_EQ(timing.FreeAt(1, 1, 1), 2) << "process 2 is free again";
}

// Processors of a node share caches and memory.
TEST(MachineTiming, BusyProcessorsOfANodeSlowEachOther) {
  Machine machine = FindMachine("cluster-1g");
  machine.processors = 2;
  machine.host_apart = 0;
  machine.contention = .5;
  MachineTiming timing(machine, 5, 1);
  EXPECT_DOUBLE_EQ(timing.FreeAt(1, 1, 0), 1) << "alone on its node";
  EXPECT_DOUBLE_EQ(timing.FreeAt(3, 1, 0), 1) << "alone on another";
  EXPECT_DOUBLE_EQ(timing.FreeAt(2, 1, 0), 1.5) << "beside process 1";
  EXPECT_DOUBLE_EQ(timing.FreeAt(kHost, 1, 0), 1.5 * 1.5)
      << "three on two processors, of which two are busy";
  EXPECT_DOUBLE_EQ(timing.FreeAt(1, 1, 3), 4) << "all others are free again";
}

}  // namespace
}  // namespace rayshade::parallel
