// SPDX-License-Identifier: MIT
#include "stats/sample.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/draw.hpp"

namespace eyrie::stats {
namespace {

// Reference values are of SciPy 1.17, NumPy and statsmodels 0.15, by the calls beside them.
const std::vector<double> kX{2, 4, 4, 5, 7, 9.5}, kY{1.5, 4.5, 3, 2, 6, 7};

Moments of(const std::vector<double>& values) {
  Moments moments;
  for (const double value : values)
    moments.add(value);
  return moments;
}
Moments differences() {
  Moments moments;
  for (std::size_t i = 0; i < kX.size(); ++i)
    moments.add(kX[i] - kY[i]);
  return moments;
}
Ratio ratio(const std::vector<double>& over, const std::vector<double>& under) {
  Ratio r;
  for (std::size_t i = 0; i < over.size(); ++i)
    r.add(over[i], under[i]);
  return r;
}

void expect_near(const std::optional<Interval>& interval, double low, double high) {
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, low, 1e-12);
  EXPECT_NEAR(interval->high, high, 1e-12);
}

// the figures of SciPy 1.16: ttest_ind(equal_var=False), fisher_exact
TEST(Independent, MeansAreComparedByWelch) {
  Moments a, b, same, other;
  for (const double x :
       {27.5, 21.0, 19.0, 23.6, 17.0, 17.9, 16.9, 20.1, 21.9, 22.6, 23.1, 19.6, 19.0, 21.7, 21.4})
    a.add(x);
  for (const double x : {27.1, 22.0, 20.8, 23.4, 23.4, 23.5, 25.8, 22.0, 24.8})
    b.add(x);
  EXPECT_NEAR(welch_test(a, b), 0.008929836466237332, 1e-12);
  const Interval interval = welch_interval(a, b).value();
  EXPECT_NEAR(interval.low, -4.8637308353930155, 1e-9);
  EXPECT_NEAR(interval.high, -0.7851580534958824, 1e-9);
  for (int i = 0; i < 4; ++i) {
    same.add(2);
    other.add(3);
  }
  EXPECT_FALSE(welch_interval(same, other));
  EXPECT_NEAR(welch_test(same, other), 2.0 / 70, 1e-12) << "one way of 70, and its mirror image";
  EXPECT_EQ(welch_test(same, same), 1);
  EXPECT_TRUE(welch_interval(a, same));
  EXPECT_EQ(welch_test(a, Moments()), 1);
}
TEST(Independent, ADifferenceOfRoundingIsNone) {
  Moments forth, back, pairs, other;
  for (int i = 1; i <= 14; ++i) {
    forth.add(1.0 / i);
    back.add(1.0 / (15 - i));
    pairs.add(1.0 / i - 1.0 / (15 - i));
    other.add(1.0 / i + 1e-9);
  }
  ASSERT_NE(forth.mean(), back.mean()) << "so there is something to leave out";
  ASSERT_NE(pairs.mean(), 0);
  EXPECT_EQ(mean_difference(forth, back), 0);
  EXPECT_EQ(mean_difference(pairs), 0);
  EXPECT_NEAR(mean_difference(other, back), 1e-9, 1e-15);
}
TEST(Independent, SharesAreComparedByFisher) {
  EXPECT_NEAR(fisher({8, 10}, {1, 6}), 0.034965034965034975, 1e-12);
  EXPECT_NEAR(fisher({30, 100}, {12, 70}), 0.07076310792036458, 1e-12);
  EXPECT_NEAR(fisher({0, 20}, {20, 20}), 1.4508889103849688e-11, 1e-22);
  EXPECT_EQ(fisher({0, 20}, {0, 30}), 1);
  EXPECT_EQ(fisher({20, 20}, {30, 30}), 1);
  EXPECT_NEAR(fisher({1500, 3000}, {1500, 3000}), 1, 1e-12);
  EXPECT_LT(fisher({0, 100'000}, {100'000, 100'000}), 1e-300);
}

TEST(Moments, AreThoseOfNumPy) {
  const Moments m = of(kX);
  EXPECT_EQ(m.n(), 6U);
  EXPECT_NEAR(m.mean(), 5.25, 1e-15);                 // np.mean(x)
  EXPECT_NEAR(m.variance(), 6.975, 1e-14);            // np.var(x, ddof=1)
  EXPECT_NEAR(m.error(), 1.0781929326423914, 1e-15);  // stats.sem(x)
  EXPECT_EQ(of({3}).variance(), 0);
}

TEST(Moments, KeepTheSpreadOfNumbersFarFromZero) {
  EXPECT_NEAR(of({1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}).variance(), 30, 1e-6);
}

TEST(StudentsInterval, IsSciPys) {
  // stats.t.interval(0.95, 5, np.mean(x), stats.sem(x)), and with 0.9
  expect_near(t_interval(of(kX)), 2.4784168320380204, 8.02158316796198);
  expect_near(t_interval(of(kX), 0.9), 3.077389084939786, 7.422610915060213);
  EXPECT_FALSE(t_interval(of({1})));
  EXPECT_FALSE(t_interval(of({0, 0, 0, 0, 0}))) << "the next one may be any number";
  EXPECT_FALSE(t_interval(of({0.3 - 0.1, 0.2, 0.4 - 0.2}))) << "but for rounding";
}

TEST(StudentsTest, OfPairsIsSciPys) {
  // stats.ttest_rel(x, y), and its confidence_interval(0.95)
  EXPECT_NEAR(t_test(differences()), 0.0642865968901419, 1e-12);
  expect_near(t_interval(differences()), -0.10819840112758294, 2.608198401127583);
}

TEST(StudentsTest, OfNumbersThatAreAllTheSame) {
  EXPECT_EQ(t_test(of({2, 2})), 0.5) << "no more than that both have one sign";
  EXPECT_EQ(t_test(of(std::vector(11, -2.0))), 1.0 / 1024);
  EXPECT_EQ(t_test(of({0, 0, 0})), 1);
  EXPECT_EQ(t_test(of({2})), 1);
}

TEST(Fieller, HoldsEveryRatioThatStudentsTestDoesNotReject) {
  // brentq(lambda r: stats.ttest_1samp(x - r * y, 0).pvalue - 0.05, ...)
  const Ratio r = ratio(kX, kY);
  EXPECT_NEAR(*r.value(), 1.3125, 1e-14);
  expect_near(r.fieller(), 0.9713873444625857, 1.9301474049376588);
  Moments parts;  // of x - r * y, over the mean of y
  for (std::size_t i = 0; i < kX.size(); ++i)
    parts.add((kX[i] - 1.3125 * kY[i]) / r.under().mean());
  EXPECT_NEAR(r.error(), parts.error(), 1e-14);
}

TEST(Fieller, SaysWhenItHasNoBounds) {
  EXPECT_FALSE(ratio({3, 4, 2, 5}, {0, 0, 1, 0}).fieller()) << "the losses may as well be 0";
  EXPECT_FALSE(ratio({3, 4}, {0, 0}).value());
  EXPECT_FALSE(ratio({3}, {1}).fieller());
  EXPECT_FALSE(ratio({0, 0, 0, 0}, {1, 2, 1, 3}).fieller()) << "no kill yet is not none ever";
  EXPECT_FALSE(ratio({0.4, 0.5, 0.7, 0.5}, {4, 5, 7, 5}).fieller()) << "one multiple of all";
}

TEST(Holm, IsThatOfStatsmodels) {
  // multipletests([0.01, 0.04, 0.03, 0.005, 0.9], method='holm')
  const std::vector<double> p{0.01, 0.04, 0.03, 0.005, 0.9}, expected{0.04, 0.09, 0.09, 0.025, 0.9};
  const auto corrected = holm(p);
  for (std::size_t i = 0; i < p.size(); ++i)
    EXPECT_NEAR(corrected[i], expected[i], 1e-15);
  EXPECT_EQ(holm(std::vector{0.8, 0.9}), (std::vector{1.0, 1.0}));
}

// of 4,000 samples the share whose interval holds the truth; its own error is 0.0034
constexpr int kSamples = 4000;
template <class Sample>
double coverage(Sample holds_truth) {
  int held = 0;
  for (int i = 0; i < kSamples; ++i) {
    Draw draw(1, PlayerId{1}, Stream::test, static_cast<std::uint64_t>(i));
    held += holds_truth(draw);
  }
  return static_cast<double>(held) / kSamples;
}

TEST(Coverage, OfStudentsIntervalIsWhatItSays) {
  EXPECT_NEAR(coverage([](Draw& draw) {
                Moments m;
                for (int k = 0; k < 8; ++k)
                  m.add(3 + 2 * draw.normal());
                const auto i = t_interval(m);
                return i && i->low <= 3 && 3 <= i->high;
              }),
              0.95, 0.01);
}

TEST(Coverage, OfFiellersIntervalIsWhatItSays) {
  EXPECT_NEAR(coverage([](Draw& draw) {
                Ratio r;
                for (int k = 0; k < 20; ++k) {
                  const double common = draw.normal();
                  r.add(6 + common + draw.normal(), 3 + common);
                }
                const auto i = r.fieller();
                return i && i->low <= 2 && 2 <= i->high;
              }),
              0.95, 0.01);
}

}  // namespace
}  // namespace eyrie::stats
