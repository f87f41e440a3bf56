// SPDX-License-Identifier: MIT
#include "net/pacing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <rapidcheck/gtest.h>

#include "support/no_allocation.hpp"

namespace eyrie::net {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

RC_GTEST_PROP(Histogram, IsTooLargeByA32ndAtMost, (std::vector<std::uint32_t> times)) {
  RC_PRE(!times.empty());
  Histogram histogram;
  for (const std::uint32_t ns : times)
    histogram.add(nanoseconds(ns));
  std::sort(times.begin(), times.end());
  for (const double part : {0.0, 0.5, 0.99, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(part * double(times.size())));
    const double exact = 1e-9 * times[std::max<std::size_t>(rank, 1) - 1];
    const double got = histogram.percentile(part);
    RC_ASSERT(got >= exact * (1 - 1e-12));
    RC_ASSERT(got <= exact * (1 + 1.0 / 32) + 1e-12);
  }
  RC_ASSERT(histogram.max() == 1e-9 * times.back());
}

TEST(Histogram, HoldsAnyDuration) {
  Histogram histogram;
  EXPECT_EQ(histogram.percentile(0.5), 0) << "of none";
  for (const auto ns : {nanoseconds::min(), nanoseconds(0), nanoseconds::max()})
    histogram.add(ns);
  EXPECT_EQ(histogram.percentile(0.5), 0);
  EXPECT_EQ(histogram.percentile(1), histogram.max());
  EXPECT_NEAR(histogram.max(), 9.2e9, 1e8);
}

/// A machine on which each frame takes `work`, and which sleeps exactly as long as it is told.
struct Machine {
  Clock::time_point now{};
  Pacing pacing{0.02, now};

  void frame(Clock::duration work) {
    const Clock::time_point begun = now = std::max(now, pacing.due());
    now += work;
    pacing.made(begun, now);
  }
  void frames(int n, Clock::duration work) {
    for (int i = 0; i < n; ++i)
      frame(work);
  }
  [[nodiscard]] double time() const {
    return std::chrono::duration<double>(now.time_since_epoch()).count();
  }
};

TEST(Pacing, KeepsDeadlinesThatDoNotDrift) {
  Machine machine;
  // which no number of nanoseconds is
  machine.pacing = Pacing(0.02 / 3, machine.now);
  machine.frames(540'000, milliseconds(1));  // an hour
  EXPECT_NEAR(std::chrono::duration<double>(machine.pacing.due().time_since_epoch()).count(), 3600,
              1e-6);
  EXPECT_EQ(machine.pacing.missed(), 0u);
  EXPECT_EQ(machine.pacing.late().max(), 0);
  EXPECT_NEAR(machine.pacing.work().mean(), 0.001, 1e-9);
}

TEST(Pacing, CountsALateFrameAndCatchesUp) {
  Machine machine;
  machine.frames(10, milliseconds(1));
  machine.frame(milliseconds(50));  // begins at 0.2 s, done at 0.25 s: the next two begin late
  EXPECT_TRUE(machine.pacing.is_kept(machine.now)) << "0.03 s of at most 0.1";
  machine.frames(10, milliseconds(1));
  EXPECT_EQ(machine.pacing.missed(), 2u) << "the frame itself, and the one due while it ran";
  EXPECT_NEAR(machine.pacing.late().max(), 0.03, 1e-9);
  EXPECT_EQ(machine.pacing.stalls(), 0u);
  EXPECT_DOUBLE_EQ(machine.time(), 0.401) << "as if nothing had been";
}

TEST(Pacing, GivesUpWhatIsBehindByTooMuch) {
  Machine machine;
  machine.frames(50, milliseconds(1));
  machine.now += milliseconds(10'000);  // a machine that swaps
  const double awake = machine.time();
  int hurried = 0;
  while (machine.pacing.due() <= machine.now && hurried < 1000) {
    machine.frame(milliseconds(1));
    ++hurried;
  }
  EXPECT_LE(machine.time() - awake, 0.02);
  EXPECT_NEAR(hurried, 0.2 / 0.02, 1) << "frames in a burst";
  EXPECT_EQ(machine.pacing.stalls(), 1u);
  EXPECT_NEAR(machine.pacing.given_up(), 10 - 0.019 - 0.2, 1e-9);
  EXPECT_NEAR(double(machine.pacing.missed()), hurried, 1);
  const std::uint64_t missed = machine.pacing.missed();
  machine.frames(100, milliseconds(1));
  EXPECT_EQ(machine.pacing.missed(), missed) << "back in time";
}

TEST(Pacing, SaysOfAMachineThatIsTooSlowThatItIs) {
  Machine machine;
  machine.frames(1000, milliseconds(30));
  EXPECT_EQ(machine.pacing.missed(), 1000u);
  EXPECT_FALSE(machine.pacing.is_kept(machine.now));
  EXPECT_NEAR(machine.pacing.given_up(), 1000 * 0.01 - 0.2, 0.05) << "30 s instead of 20";
  EXPECT_NEAR(machine.pacing.work().mean() / machine.pacing.frame(), 1.5, 1e-9);
}

TEST(Pacing, GoesOnAtAnotherRateAfterAPause) {
  Machine machine;
  machine.frames(50, milliseconds(1));
  machine.now += milliseconds(60'000);
  machine.pacing.go_on(0.005, machine.now);
  EXPECT_EQ(machine.pacing.due(), machine.now);
  const double begun = machine.time();
  machine.frames(200, milliseconds(1));
  EXPECT_NEAR(machine.time() - begun, 199 * 0.005 + 0.001, 1e-9);
  EXPECT_EQ(machine.pacing.frames(), 250u) << "all of them";
  EXPECT_EQ(machine.pacing.stalls(), 0u);
  EXPECT_EQ(machine.pacing.missed(), 0u);
  EXPECT_NEAR(machine.pacing.load(), 0.25 / (50 * 0.02 + 200 * 0.005), 1e-9);
  EXPECT_NEAR(machine.pacing.greatest_load(), 0.001 / 0.005, 1e-9);
  EXPECT_FALSE(machine.pacing.is_of_one_frame());
  machine.pacing.go_on(0.02, machine.now);
  machine.frames(1, milliseconds(2));
  EXPECT_NEAR(machine.pacing.greatest_load(), 0.001 / 0.005, 1e-9) << "2 of 20 ms are less";
}

TEST(Pacing, AllocatesNothing) {
  Machine machine;
  NoAllocation guard;
  machine.frames(100, microseconds(30'000));
}

}  // namespace
}  // namespace eyrie::net
