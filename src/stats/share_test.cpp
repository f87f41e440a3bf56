// SPDX-License-Identifier: MIT
#include "stats/sample.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace eyrie::stats {
namespace {

void expect_share(const Interval& interval, double low, double high, double error = 1e-12) {
  EXPECT_NEAR(interval.low, low, error);
  EXPECT_NEAR(interval.high, high, error);
}

// SciPy 1.17: stats.binomtest(k, n).proportion_ci(confidence, method)

TEST(Wilson, IsSciPys) {
  expect_share(wilson({8, 10}), 0.4901624715366418, 0.9433178485456248);
  expect_share(wilson({8, 10}, 0.99), 0.4008186965216716, 0.9598688474953836);
  expect_share(wilson({1, 1000}), 0.00017654637062607809, 0.0056425585979579355);
  expect_share(wilson({0, 20}), 0, 0.16112515805281935);
}
TEST(Wilson, StaysInItsRange) {
  EXPECT_EQ(wilson({0, 20}).low, 0);
  EXPECT_EQ(wilson({20, 20}).high, 1);
  expect_share(wilson({0, 0}), 0, 1, 0);
}

/// Newcombe's own example, 56 of 70 against 48 of 80, method 10.
TEST(Newcombe, IsAsPublished) {
  expect_share(newcombe({56, 70}, {48, 80}), 0.0524, 0.3339, 1e-4);
}

/// Newcombe's own example for pairs, 36 both, 12 and 2 only one of them, method 10.
TEST(NewcombePaired, IsAsPublished) {
  expect_share(newcombe_paired(36, 12, 2, 50), 0.0569, 0.3404, 1e-4);
}

TEST(NewcombePaired, StaysAmongDifferencesOfShares) {
  const Interval none = newcombe_paired(0, 0, 40, 40), all = newcombe_paired(0, 40, 0, 40);
  EXPECT_EQ(none.low, -1);
  EXPECT_EQ(all.high, 1);
  EXPECT_NEAR(none.high, -all.low, 1e-15);
  EXPECT_LT(none.high, -0.8);
  const Interval same = newcombe_paired(40, 0, 0, 40);
  EXPECT_NEAR(same.low, -same.high, 1e-15);
  EXPECT_EQ(newcombe_paired(0, 0, 0, 0).width(), 2);
}

/// statsmodels 0.15: mcnemar([[0, 3], [12, 0]], exact=True)
TEST(McNemar, IsThatOfStatsmodels) {
  EXPECT_NEAR(mcnemar(3, 12), 0.03515625, 1e-14);
  EXPECT_EQ(mcnemar(12, 3), mcnemar(3, 12));
  EXPECT_EQ(mcnemar(10, 10), 1);
  EXPECT_EQ(mcnemar(0, 0), 1);
}

/// How often the interval holds the true share `p`, summed over all that can come of n.
double exact_coverage(Interval (*interval)(const Share&, double), std::uint64_t n, double p) {
  double covered = 0, chance = std::pow(1 - p, static_cast<double>(n));
  for (std::uint64_t k = 0; k <= n; ++k) {
    const Interval i = interval({k, n}, 0.95);
    if (i.low <= p && p <= i.high)
      covered += chance;
    chance *= static_cast<double>(n - k) / static_cast<double>(k + 1) * p / (1 - p);
  }
  return covered;
}

TEST(Coverage, OfSharesIsWhatTheirIntervalsSay) {
  for (const std::uint64_t n : {10u, 40u, 100u}) {
    double wilsons = 0;
    for (int i = 1; i < 100; ++i)
      wilsons += exact_coverage(wilson, n, i / 100.0) / 99;
    EXPECT_NEAR(wilsons, 0.95, 0.006) << n;
  }
}

}  // namespace
}  // namespace eyrie::stats
