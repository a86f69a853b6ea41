// What of the PVM layer can be known without PVM: shares of hosts, leases, texts of errors.
#include "parallel/pvm/virtual_machine.h"

#include <gtest/gtest.h>
#include <pvm3.h>

#include <numeric>

#include "parallel/pvm/lease.h"
#include "parallel/pvm/pvm_call.h"

namespace rayshade::parallel {
namespace {

std::vector<PvmHost> WithSpeeds(const std::vector<int>& speeds) {
  std::vector<PvmHost> hosts;
  for (const int speed : speeds) hosts.push_back({0, "host", speed});
  return hosts;
}

TEST(Shares, EqualHostsGetEqualShares) {
  EXPECT_EQ(Shares(WithSpeeds({1000, 1000, 1000, 1000}), 8), (std::vector<int>{2, 2, 2, 2}));
  EXPECT_EQ(Shares(WithSpeeds({1000, 1000, 1000}), 4), (std::vector<int>{2, 1, 1}));
  EXPECT_EQ(Shares(WithSpeeds({1000}), 7), (std::vector<int>{7}));
}

TEST(Shares, AHostOfTwiceTheSpeedGetsTwiceTheProcesses) {
  EXPECT_EQ(Shares(WithSpeeds({1000, 2000}), 6), (std::vector<int>{2, 4}));
  EXPECT_EQ(Shares(WithSpeeds({1, 1000000}), 5), (std::vector<int>{0, 5}));
}

TEST(Shares, EveryProcessIsPlaced) {
  for (int processes = 1; processes < 60; ++processes) {
    const std::vector<int> shares = Shares(WithSpeeds({700, 1000, 1300}), processes);
    EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), 0), processes);
  }
}

TEST(Lease, OnlyProcessesOnOtherMachinesAreWatched) {
  Lease lease;
  lease.Begin({false, true}, 10);
  EXPECT_EQ(lease.Silent(10 + Lease::kSeconds - 1), kHost);
  EXPECT_EQ(lease.Silent(10 + Lease::kSeconds + 1), 2);
  lease.Heard(2, 20);
  EXPECT_EQ(lease.Silent(20 + Lease::kSeconds - 1), kHost);
  EXPECT_EQ(lease.Silent(20 + Lease::kSeconds + 1), 2);
}

TEST(Lease, WordFromNobodyChangesNothing) {
  Lease lease;
  lease.Begin({true}, 0);
  lease.Heard(kHost, 100);
  lease.Heard(2, 100);
  EXPECT_EQ(lease.Silent(100), 1);
}

TEST(PvmCheck, AFailureNamesTheAttemptAndTheReason) {
  EXPECT_EQ(PvmCheck(3, "pvm_spawn"), 3);
  try {
    PvmCheck(PvmNoFile, "pvm_spawn(prayshade-trace)");
    FAIL() << "nothing was thrown";
  } catch (const PvmError& e) {
    EXPECT_STREQ(e.what(), "pvm_spawn(prayshade-trace): no such file");
    EXPECT_EQ(e.code(), PvmNoFile);
  }
}

TEST(PvmCheck, AnUnknownCodeIsGivenAsANumber) { EXPECT_EQ(PvmErrorText(-99), "PVM error -99"); }

}  // namespace
}  // namespace rayshade::parallel
