// The comparison with a sequential run: what is asked of the other program, and the table.
#include "parallel/pvm/compare.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace rayshade::parallel {
namespace {

using Words = std::vector<std::string>;

TEST(SequentialArguments, WhatOnlyPrayshadeKnowsIsLeftOut) {
  EXPECT_EQ(SequentialArguments({"prayshade", "--processes", "4", "-R", "10", "20",
                                 "--schedule=hybrid", "--memory", "2M", "--compare", "--seed", "7",
                                 "--stats", "s.json", "-D", "3", "scene.ray"}),
            (Words{"-R", "10", "20", "--seed", "7", "-D", "3", "scene.ray"}));
  EXPECT_EQ(SequentialArguments({"prayshade", "--compare=other", "scene.ray"}),
            (Words{"scene.ray"}));
}

TEST(CheckComparable, StandardInputAndOutputCannotBeReadTwice) {
  Options options;
  EXPECT_THROW(CheckComparable(options), std::invalid_argument);
  options.input = "scene.ray";
  EXPECT_NO_THROW(CheckComparable(options));
  options.output = "-";
  EXPECT_THROW(CheckComparable(options), std::invalid_argument);
}

// Of the line that begins so; "" where there is none.
std::string LastWord(const std::string& table, const std::string& beginning) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(beginning)) return line.substr(line.find_last_of(' ') + 1);
  return "";
}

RunStats Traced(double seconds) {
  RunStats stats;
  stats.trace_seconds = seconds;
  stats.operations.primary_rays = 100;
  return stats;
}

TEST(ComparisonTable, SpeedUpAndEfficiencyAreThoseOfTracing) {
  RunStats parallel = Traced(2);
  parallel.read_seconds = 100;
  parallel.processes.resize(4);
  const std::string table =
      ComparisonTable({.wall_seconds = 6.5, .stats = Traced(6)}, parallel, "identical");
  EXPECT_EQ(LastWord(table, "speed-up (trace)"), "3.00");
  EXPECT_EQ(LastWord(table, "efficiency"), "0.75");
  EXPECT_EQ(LastWord(table, "pictures:"), "identical");
}

TEST(ComparisonTable, AProgramThatTellsNoPhasesIsComparedAsAWhole) {
  RunStats parallel = Traced(3);
  parallel.read_seconds = 1;
  parallel.processes.resize(2);
  const std::string table =
      ComparisonTable({.wall_seconds = 8, .stats = std::nullopt}, parallel, "not identical");
  EXPECT_EQ(LastWord(table, "speed-up (all)"), "2.00");
  EXPECT_EQ(LastWord(table, "pictures: not"), "identical");
  EXPECT_EQ(LastWord(table, "all, s"), "4.000");
}

}  // namespace
}  // namespace rayshade::parallel
