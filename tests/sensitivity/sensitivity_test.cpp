// SPDX-License-Identifier: MIT
/// \file  The tool that tells what the judgements of data/ do.
#include <gtest/gtest.h>

#include "../../apps/sensitivity/design.hpp"
#include "../../apps/sensitivity/judgement.hpp"

namespace eyrie::sensitivity {
namespace {

int sum_of_products(const Design& design, std::size_t a, std::size_t b) {
  int sum = 0;
  for (std::size_t row = 0; row < design.rows(); ++row)
    sum += design.sign(row, a) * design.sign(row, b);
  return sum;
}

TEST(Design, TellsTheEffectOfEachValueFromThoseOfAllOthers) {
  for (const std::size_t values : {std::size_t{2}, std::size_t{20}, std::size_t{131}}) {
    const Design design(values);
    for (std::size_t a = 0; a < values; ++a) {
      int sum = 0;
      for (std::size_t row = 0; row < design.rows(); ++row)
        sum += design.sign(row, a);
      ASSERT_EQ(sum, 0) << a << " of " << values;
      for (std::size_t b = 0; b < a; ++b)
        ASSERT_EQ(sum_of_products(design, a, b), 0) << a << ", " << b << " of " << values;
    }
  }
}

TEST(Design, FliesEveryRowWithAllSignsTurnedToo) {
  const Design design(20);
  for (std::size_t row = 0; row < design.rows(); row += 2)
    for (std::size_t value = 0; value < 20; ++value)
      EXPECT_EQ(design.sign(row, value), -design.sign(row + 1, value));
}

TEST(Judgements, AreScaledToValuesThatMayBe) {
  EXPECT_EQ(scaled("2 mrad", 1.2), "2.4 mrad");
  EXPECT_EQ(scaled("0.8 m/s2", 0.8), "0.64 m/s2") << "the 2 belongs to the unit";
  EXPECT_EQ(scaled("[1.15, 0.5]", 0.8), "[0.92, 0.4]");
  EXPECT_EQ(scaled("60", 0.8), "48");
  EXPECT_EQ(scaled("2", 1.2), "3") << "a count stays whole, and changes";
  EXPECT_EQ(scaled("10 Hz", 0.8), "8.333333333 Hz") << "every sixth step, not every fifth";
}

TEST(Judgements, AreFoundWhereTheyStand) {
  const std::vector<Judgement> all = judgements(".");
  ASSERT_GT(all.size(), 10U);
  for (const Judgement& j : all) {
    EXPECT_EQ(j.text.substr(j.begin, j.end - j.begin), j.now) << j.name;
    EXPECT_EQ(
        std::count(j.text.begin(), j.text.begin() + static_cast<std::ptrdiff_t>(j.begin), '\n'),
        j.line - 1)
        << j.name;
  }
}

}  // namespace
}  // namespace eyrie::sensitivity
