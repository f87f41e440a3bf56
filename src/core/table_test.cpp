// SPDX-License-Identifier: MIT
#include "core/table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "support/no_allocation.hpp"

namespace eyrie {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

TEST(Table1, IsExactAtBreakpointsLinearBetweenAndConstantBeyond) {
  const Table1 thrust({0, 0.3, 0.9, 1.0}, {10, 0.1, 70, -5});
  EXPECT_EQ(thrust(0), 10);
  EXPECT_EQ(thrust(0.3), 0.1);
  EXPECT_EQ(thrust(0.9), 70);
  EXPECT_EQ(thrust(1.0), -5);
  EXPECT_DOUBLE_EQ(thrust(0.6), 35.05);
  EXPECT_NEAR(thrust(0.975), 13.75, 1e-12);
  EXPECT_EQ(thrust(-7), 10);
  EXPECT_EQ(thrust(1.5), -5);
  EXPECT_EQ(thrust(kNoLimit), -5);
  EXPECT_EQ(thrust(-kNoLimit), 10);
}

TEST(Table1, ShowsThatItsArgumentIsNoNumber) {
  EXPECT_TRUE(std::isnan(Table1({0, 1}, {2, 3})(kNaN)));
  EXPECT_TRUE(std::isnan(Table1::constant(4)(kNaN)));
}

TEST(Table1, MayBeConstant) {
  EXPECT_EQ(Table1{}(123), 0);
  EXPECT_EQ(Table1::constant(4)(-1e9), 4);
  EXPECT_EQ(Table1::constant(4)(1e9), 4);
}

TEST(Axis, FindsTheSameCellsSideBySide) {
  for (const Axis& axis : {Axis({0, 0.3, 0.9, 1.0}), Axis({-1, -0.999, 4, 5, 1e4}), Axis({2, 3})})
    for (double x : {-kNoLimit, -1.0, -0.9995, 0.0, 0.3, 0.31, 0.9, 1.0, 2.0, 4.5, 1e4, kNoLimit}) {
      const auto both = axis.cell(math::Lanes<2>(math::Lanes<2>::Vector{x, kNaN}));
      EXPECT_EQ(both.index[0], axis.cell(x).index) << x;
      EXPECT_EQ(math::lane(both.fraction, 0), axis.cell(x).fraction) << x;
      EXPECT_EQ(both.index[1], 0U);
      EXPECT_TRUE(std::isnan(math::lane(both.fraction, 1)));
    }
}

TEST(Table1, NamesWhatIsWrong) {
  using Numbers = std::vector<double>;
  const auto problem = [](const Numbers& x, const Numbers& y) {
    return Table1::problem(x, y).value_or("none");
  };
  EXPECT_EQ(problem({1, 2}, {3, 4}), "none");
  EXPECT_EQ(problem({}, {}), "there is no breakpoint");
  EXPECT_EQ(problem({0, 0.9, 0.8}, {1, 2, 3}),
            "breakpoints must increase: number 3 (0.8) is not above number 2 (0.9)");
  EXPECT_EQ(problem({0, 0}, {1, 2}),
            "breakpoints must increase: number 2 (0) is not above number 1 (0)");
  EXPECT_EQ(problem({0, kNaN}, {1, 2}), "breakpoint 2 is nan");
  EXPECT_EQ(problem({0, 1}, {1, kNoLimit}), "value 2 is inf");
  EXPECT_EQ(problem({0, 1}, {1, 2, 3}), "2 breakpoints need as many values, not 3");
  EXPECT_EQ(problem({-1e300, 1e300}, {1, 2}),
            "the breakpoints are too close together or too far apart");
  EXPECT_THROW(Table1({1, 0}, {1, 2}), std::logic_error);
  EXPECT_THROW(Table2({0}, {0, 1}, {1}), std::logic_error);
}

TEST(Table2, TakesItsValuesRowByRow) {
  const Table2 thrust({0, 10}, {0.2, 0.4, 1.0}, {1, 2, 3, 11, 12, 13});
  EXPECT_EQ(thrust.values().size(), 6u);
  EXPECT_EQ(thrust(0, 0.2), 1);
  EXPECT_EQ(thrust(0, 1.0), 3);
  EXPECT_EQ(thrust(10, 0.2), 11);
  EXPECT_EQ(thrust(10, 0.4), 12);
  EXPECT_EQ(thrust(10, 1.0), 13);
  EXPECT_EQ(thrust(99, 99), 13);
  EXPECT_EQ(thrust(-99, -99), 1);
  EXPECT_DOUBLE_EQ(thrust(5, 0.3), 6.5);
  EXPECT_TRUE(std::isnan(thrust(kNaN, 0.3)));
  EXPECT_TRUE(std::isnan(thrust(5, kNaN)));
}

TEST(Table2, MayHaveASingleRowOrColumn) {
  const Table2 row({5}, {0, 1}, {2, 4}), column({0, 1}, {5}, {2, 4});
  EXPECT_EQ(row(-3, 0.5), 3);
  EXPECT_EQ(column(0.5, 77), 3);
  EXPECT_EQ(Table2::constant(9)(1, 2), 9);
  EXPECT_EQ(Table2{}(1, 2), 0);
}

TEST(Table2, NamesWhatIsWrong) {
  const std::vector<double> good{0, 1}, bad{1, 0}, four{1, 2, 3, 4};
  EXPECT_FALSE(Table2::problem(good, good, four));
  EXPECT_TRUE(Table2::problem(bad, good, four)->starts_with("rows: breakpoints must increase"));
  EXPECT_TRUE(Table2::problem(good, bad, four)->starts_with("columns: breakpoints must increase"));
  EXPECT_EQ(Table2::problem(good, good, good), "2 by 2 breakpoints need 4 values, not 2");
}

TEST(Table2, AllocatesNothingWhenLookedUp) {
  const Table2 table({0, 1, 2}, {0, 1}, {1, 2, 3, 4, 5, 6});
  const Table1 line({0, 1, 5}, {1, 2, 3});
  NoAllocation guard;
  double sum = 0;
  for (double x = -1; x < 6; x += 0.125)
    sum += table(x, x) + line(x);
  EXPECT_GT(sum, 0);
}

/// Breakpoints that are even, uneven or very uneven.
std::vector<double> some_breakpoints() {
  const int exponent = *rc::gen::inRange(0, 12);
  const auto whole = *rc::gen::nonEmpty<std::set<std::int16_t>>();
  std::vector<double> breakpoints;
  for (const std::int16_t n : whole)
    breakpoints.push_back(n * 0.1 + std::copysign(std::pow(std::fabs(n) * 1e-3, exponent), n));
  return breakpoints;
}

RC_GTEST_PROP(Axis, FindsTheCellThatASearchFinds, ()) {
  const Axis axis(some_breakpoints());
  const auto b = axis.breakpoints();
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (const double x : {b[i], std::nextafter(b[i], -kNoLimit), std::nextafter(b[i], kNoLimit),
                           0.5 * (b[i] + b[std::min(i + 1, b.size() - 1)])}) {
      const TableCell cell = axis.cell(x);
      RC_ASSERT(cell.fraction >= 0 && cell.fraction <= 1);
      if (x <= b.front() || b.size() == 1) {
        RC_ASSERT(cell.index == 0 && cell.fraction == 0);
      } else if (x >= b.back()) {
        RC_ASSERT(cell.index == b.size() - 2 && cell.fraction == 1);
      } else {
        const auto above = std::upper_bound(b.begin(), b.end(), x) - b.begin();
        RC_ASSERT(cell.index == static_cast<std::size_t>(above) - 1);
      }
    }
  }
}

RC_GTEST_PROP(Table2, ReproducesABilinearFunction, (std::int16_t a, std::int16_t b)) {
  const auto f = [](double x, double y) { return 1 + 2 * x - 3 * y + 0.5 * x * y; };
  const std::vector<double> rows{-2, 0, 1, 7}, columns{0, 3, 4};
  std::vector<double> values;
  for (const double x : rows)
    for (const double y : columns)
      values.push_back(f(x, y));
  const Table2 table(rows, columns, values);
  const double x = 2.5 + a * 4.5 / 32768, y = 2 + b * 2.0 / 32768;
  RC_ASSERT(std::fabs(table(x, y) - f(x, y)) < 1e-13);
}

}  // namespace
}  // namespace eyrie
