// SPDX-License-Identifier: MIT
#include "stats/share.hpp"

#include <gtest/gtest.h>

namespace eyrie::stats {
namespace {

void expect_near(const Interval& interval, double low, double high, double error = 5e-9) {
  EXPECT_NEAR(interval.low, low, error);
  EXPECT_NEAR(interval.high, high, error);
}

/// Of 8 of 10, Agresti & Coull, The American Statistician 52 (1998).
TEST(Wilson, IsAsPublished) {
  expect_near(wilson({8, 10}), 0.4902, 0.9433, 1e-4);
}
TEST(Wilson, StaysInItsRange) {
  EXPECT_EQ(wilson({0, 20}).low, 0);
  EXPECT_EQ(wilson({20, 20}).high, 1);
  expect_near(wilson({0, 0}), 0, 1, 0);
}

/// Newcombe's own example, 56 of 70 against 48 of 80, method 10.
TEST(Newcombe, IsAsPublished) {
  expect_near(newcombe({56, 70}, {48, 80}), 0.0524, 0.3339, 1e-4);
}

}  // namespace
}  // namespace eyrie::stats
