// The long options of the parallel programs: sizes, names, defaults, and what is said about
// mistakes.
#include "parallel/parallel_options.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rayshade::parallel {
namespace {

Options With(const std::string& name, const std::string& value) {
  Options options;
  options.extra.emplace_back(name, value);
  return options;
}

std::string ComplaintAbout(const std::string& name, const std::string& value) {
  try {
    ParseParallelOptions(With(name, value));
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(ParallelOptions, ShadowRaysTravelWhereRaysTravel) {
  EXPECT_EQ(ParseParallelOptions({}).shadows, Shadows::kLocal);
  EXPECT_EQ(ParseParallelOptions(With("shadows", "travel")).shadows, Shadows::kTravel);
  EXPECT_EQ(ComplaintAbout("shadows", "here"), "--shadows here: must be local or travel");
  Options options = With("shadows", "travel");
  options.extra.emplace_back("schedule", "demand-driven");
  EXPECT_THROW(ParseParallelOptions(options), std::invalid_argument);
}

TEST(ParallelOptions, SizesAreBytesOrHaveALetterForPowersOf1024) {
  EXPECT_EQ(ParseSize("4096"), 4096u);
  EXPECT_EQ(ParseSize("64K"), 65536u);
  EXPECT_EQ(ParseSize("12M"), 12u << 20);
  EXPECT_EQ(ParseSize("2G"), uint64_t{2} << 30);
  EXPECT_EQ(ParseSize("3g"), uint64_t{3} << 30);
  EXPECT_EQ(ParseSize("0"), 0u);
}

TEST(ParallelOptions, WhatIsNoSizeIsRefused) {
  for (const char* text :
       {"", "K", "-1", "1.5M", "12MB", " 1", "1 ", "0x10", "17179869184G", "99999999999999999999"})
    EXPECT_FALSE(ParseSize(text)) << text;
}

TEST(ParallelOptions, EveryOptionIsRead) {
  Options options;
  options.extra = {{"processes", "7"},       {"schedule", "demand-driven"},
                   {"distribution", "grid"}, {"memory", "2M"},
                   {"resident", "0"},        {"cache", "64K"},
                   {"pyramid", "64"},        {"compare", "other"},
                   {"machine", "cluster"}};
  const ParallelOptions parsed = ParseParallelOptions(options);
  EXPECT_EQ(parsed.processes, 7);
  EXPECT_EQ(parsed.schedule, Schedule::kDemandDriven);
  EXPECT_EQ(parsed.distribution, Distribution::kGrid);
  EXPECT_EQ(parsed.memory, 2u << 20);
  EXPECT_EQ(parsed.resident, 0u);
  EXPECT_EQ(parsed.cache, 65536u);
  EXPECT_EQ(parsed.pyramid, 64u);
  EXPECT_TRUE(parsed.compare);
  EXPECT_EQ(parsed.compare_program, "other");
}

TEST(ParallelOptions, AMistakeNamesOptionAndValue) {
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, std::string>>{{"schedule", "bogus"},
                                                        {"distribution", "bogus"},
                                                        {"processes", "0"},
                                                        {"processes", "4097"},
                                                        {"processes", "two"},
                                                        {"processes", "-1"},
                                                        {"memory", "much"},
                                                        {"resident", "1T"},
                                                        {"cache", ""},
                                                        {"pyramid", "0"},
                                                        {"pyramid", "1025"}}) {
    const std::string complaint = ComplaintAbout(name, value);
    EXPECT_NE(complaint.find("--" + name), std::string::npos) << name << " " << value;
    EXPECT_NE(complaint.find(value), std::string::npos) << complaint;
  }
}

TEST(ParallelOptions, ThereIsOneProcessForEachProcessorAndHalfTheMemoryIsShared) {
  const RunOptions run =
      DefaultsFor(ParallelOptions{}, {.count = 3, .processors = 2, .memory_bytes = 8 << 20});
  EXPECT_EQ(run.processes, 6);
  EXPECT_EQ(run.memory, 2u << 20);
  EXPECT_EQ(run.resident, run.memory / 4);
  EXPECT_EQ(run.cache, run.memory / 4);
  EXPECT_EQ(run.pyramid, 1024u);
}

TEST(ParallelOptions, WhatWasSaidIsKept) {
  ParallelOptions said;
  said.processes = 5;
  said.memory = 4096;
  said.resident = 0;
  const RunOptions run = DefaultsFor(said, {.count = 2, .processors = 2, .memory_bytes = 1 << 30});
  EXPECT_EQ(run.processes, 5);
  EXPECT_EQ(run.memory, 4096u);
  EXPECT_EQ(run.resident, 0u);
  EXPECT_EQ(run.cache, 1024u);
}

}  // namespace
}  // namespace rayshade::parallel
