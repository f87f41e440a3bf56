// SPDX-License-Identifier: MIT
#include "core/angle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

namespace eyrie {
namespace {

TEST(Angle, ConvertsDegrees) {
  EXPECT_DOUBLE_EQ(radians(180), kPi);
  EXPECT_DOUBLE_EQ(degrees(kPi / 6), 30);
  EXPECT_DOUBLE_EQ(degrees(radians(-123.25)), -123.25);
}

TEST(Angle, WrapsIntoAHalfOpenTurn) {
  EXPECT_EQ(wrap_pi(kPi), kPi);
  EXPECT_EQ(wrap_pi(-kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_pi(1.5 * kPi), -0.5 * kPi);
  EXPECT_DOUBLE_EQ(wrap_pi(-1.5 * kPi), 0.5 * kPi);
  EXPECT_EQ(wrap_tau(0), 0);
  EXPECT_EQ(wrap_tau(kTau), 0);
  EXPECT_DOUBLE_EQ(wrap_tau(-0.5 * kPi), 1.5 * kPi);
  EXPECT_DOUBLE_EQ(wrap_tau(5 * kPi), kPi);
}

TEST(Angle, NeverReachesTheOpenEnd) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_LT(wrap_tau(-tiny), kTau);
  EXPECT_LT(wrap_tau(-1e-17), kTau);
  EXPECT_GE(wrap_tau(-1e-17), 0);
  EXPECT_GT(wrap_pi(std::nextafter(-kPi, -10)), -kPi);
  EXPECT_LE(wrap_pi(std::nextafter(kPi, 10)), kPi);
}

TEST(Angle, SaysThatAnAngleIsNoNumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(std::isnan(wrap_pi(x)));
    EXPECT_TRUE(std::isnan(wrap_tau(x)));
  }
}

TEST(Angle, TurnsTheShortWayRound) {
  EXPECT_NEAR(angle_between(radians(350), radians(10)), radians(20), 1e-15);
  EXPECT_NEAR(angle_between(radians(10), radians(350)), radians(-20), 1e-15);
  EXPECT_EQ(angle_between(0, kPi), kPi);
}

RC_GTEST_PROP(Angle, WrapsByWholeTurns, (std::int32_t millionths, std::int16_t turns)) {
  const double x = millionths * 1e-6 + turns * kTau;
  const double near_zero = wrap_pi(x), positive = wrap_tau(x);
  RC_ASSERT(near_zero > -kPi && near_zero <= kPi);
  RC_ASSERT(positive >= 0 && positive < kTau);
  const double whole = (x - near_zero) / kTau;
  RC_ASSERT(std::fabs(whole - std::nearbyint(whole)) < 1e-9);
  const double gap = std::fabs(positive - near_zero);
  RC_ASSERT(gap < 1e-9 || std::fabs(gap - kTau) < 1e-9);
}

RC_GTEST_PROP(Angle, LeavesAnAngleInRangeAsItIs, (std::int32_t millionths)) {
  const double x = millionths * 1e-9;
  RC_ASSERT(std::bit_cast<std::uint64_t>(wrap_pi(x)) == std::bit_cast<std::uint64_t>(x));
}

}  // namespace
}  // namespace eyrie
