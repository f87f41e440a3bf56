// SPDX-License-Identifier: MIT
#include "sim/system.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <stdexcept>

namespace eyrie::sim {
namespace {

RC_GTEST_PROP(Due, ComesExactlyOncePerPeriod, ()) {
  const auto period = *rc::gen::inRange<std::uint32_t>(1, 200);
  const PlayerId id{*rc::gen::arbitrary<std::uint32_t>()};
  // around 2^32, where the division gets longer, too
  const auto start = *rc::gen::inRange<std::uint64_t>(0, 1u << 30) * *rc::gen::element(1, 8);
  int times = 0;
  for (std::uint64_t step = start; step < start + period; ++step)
    times += due(step, id, period) ? 1 : 0;
  RC_ASSERT(times == 1);
}

TEST(Due, SpreadsPlayersOverThePeriod) {
  for (std::uint64_t step = 0; step < 10; ++step) {
    int work = 0;
    for (std::uint32_t id = 1; id <= 100; ++id)
      work += due(step, PlayerId{id}, 5) ? 1 : 0;
    EXPECT_EQ(work, 20) << "step " << step;
  }
}

TEST(PeriodSteps, CountsTheStepsBetweenTwoHappenings) {
  EXPECT_EQ(period_steps(50, 1.0 / 50).steps, 1u);
  EXPECT_EQ(period_steps(25, 1.0 / 50).steps, 2u);
  EXPECT_EQ(period_steps(10, 1.0 / 50).steps, 5u);
  EXPECT_EQ(period_steps(0.1, 1.0 / 50).steps, 500u);
  EXPECT_EQ(period_steps(20, 0.01).steps, 5u);
  EXPECT_EQ(period_steps(1.0 / 3600, 1.0 / 50).steps, 180000u);
}

RC_GTEST_PROP(PeriodSteps, AcceptsEveryRateThatDividesTheBaseRate, ()) {
  const auto base = *rc::gen::inRange(1, 1000);
  const auto steps = *rc::gen::inRange<std::uint32_t>(1, 3600);
  const double dt = 1.0 / base;
  const Period period = period_steps(base / static_cast<double>(steps), dt);
  RC_ASSERT(period.error.empty());
  RC_ASSERT(period.steps == steps);
}

TEST(PeriodSteps, NamesTheNearestRatesThatFit) {
  const Period period = period_steps(20, 1.0 / 50);
  EXPECT_FALSE(period);
  EXPECT_EQ(period.steps, 0u);
  EXPECT_EQ(period.error,
            "20 Hz does not divide the base rate of 50 Hz; near it are 16.6667 Hz and 25 Hz");
}

TEST(PeriodSteps, RefusesWhatIsNoRate) {
  EXPECT_EQ(period_steps(0, 0.02).error, "a rate must be above 0 Hz, got 0 Hz");
  EXPECT_EQ(period_steps(-5, 0.02).error, "a rate must be above 0 Hz, got -5 Hz");
  EXPECT_FALSE(period_steps(std::numeric_limits<double>::quiet_NaN(), 0.02));
  EXPECT_FALSE(period_steps(std::numeric_limits<double>::infinity(), 0.02));
  EXPECT_EQ(period_steps(100, 0.02).error, "100 Hz is faster than the step, which runs at 50 Hz");
  EXPECT_EQ(period_steps(1e-4, 0.02).error, "0.0001 Hz is slower than once per hour");
  EXPECT_FALSE(period_steps(1.0 / 3600, 1e-7)) << "more steps than a period can hold";
}

TEST(PeriodSteps, ThrowsIfTheStepHasNoLength) {
  EXPECT_THROW((void)period_steps(1, 0), std::logic_error);
}

}  // namespace
}  // namespace eyrie::sim
