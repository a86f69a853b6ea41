// The long options of prayshade-sim.
#include "parallel/sim/sim_options.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace rayshade::parallel {
namespace {

SimOptions Parse(std::vector<std::pair<std::string, std::string>> extra) {
  Options options;
  options.extra = std::move(extra);
  return ParseSimOptions(options);
}

TEST(SimOptions, DefaultsAreThePapersMachineAndTheFirstSeed) {
  const SimOptions options = Parse({});
  EXPECT_EQ(options.machine, "powerxplorer");
  EXPECT_EQ(options.schedule_seed, 1u);
  EXPECT_FALSE(options.fault_seed);
  EXPECT_EQ(options.transcript_file, "");
}

TEST(SimOptions, SeedsAndTranscriptAreReadBesideThoseOfPrayshade) {
  const SimOptions options = Parse({{"schedule-seed", "18446744073709551615"},
                                    {"fault-seed", "0"},
                                    {"transcript", "-"},
                                    {"processes", "1024"}});
  EXPECT_EQ(options.schedule_seed, ~uint64_t{0});
  EXPECT_EQ(options.fault_seed, 0u);
  EXPECT_EQ(options.transcript_file, "-");
  EXPECT_EQ(options.parallel.processes, 1024);
}

TEST(SimOptions, ASeedThatIsNoNumberIsRefusedByName) {
  for (const std::string name : {"schedule-seed", "fault-seed"}) {
    for (const std::string value : {"", "x", "1x", "-1", "1.5"}) {
      try {
        Parse({{name, value}});
        ADD_FAILURE() << name << " " << value;
      } catch (const std::invalid_argument& e) {
        EXPECT_EQ(std::string(e.what()).rfind("--" + name + " " + value + ": ", 0), 0u);
      }
    }
  }
}

}  // namespace
}  // namespace rayshade::parallel
