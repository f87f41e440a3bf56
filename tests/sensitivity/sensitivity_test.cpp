// SPDX-License-Identifier: MIT
/// \file  The tool that tells what the judgements of data/ do.
#include <gtest/gtest.h>

#include <numeric>

#include "../../apps/sensitivity/design.hpp"
#include "../../apps/sensitivity/judgement.hpp"

namespace eyrie::sensitivity {
namespace {

using Column = std::vector<int>;

std::vector<Column> columns_of(const Design& design, std::size_t values) {
  std::vector<Column> columns(values);
  for (std::size_t value = 0; value < values; ++value)
    for (std::size_t plot = 0; plot < design.plots(); ++plot)
      for (std::size_t row = 0; row < design.rows_in_plot(); ++row)
        columns[value].push_back(design.sign(plot, row, value));
  return columns;
}

TEST(Design, TellsTheEffectOfEachValueFromThoseOfAllOthers) {
  for (const auto& [costly, others] :
       {std::pair<std::size_t, std::size_t>{2, 0}, {0, 40}, {20, 9}, {44, 88}}) {
    const std::vector<Column> columns = columns_of({costly, others}, costly + others);
    for (std::size_t a = 0; a < columns.size(); ++a) {
      ASSERT_EQ(std::accumulate(columns[a].begin(), columns[a].end(), 0), 0) << a;
      for (std::size_t b = 0; b < a; ++b)
        ASSERT_EQ(std::inner_product(columns[a].begin(), columns[a].end(), columns[b].begin(), 0),
                  0)
            << a << ", " << b << " of " << costly << " + " << others;
    }
  }
}

TEST(Design, FliesEveryRowWithAllSignsTurnedTooAndChangesCostlyValuesRarely) {
  const Design design(20, 30);
  for (std::size_t plot = 0; plot < design.plots(); plot += 2)
    for (std::size_t row = 0; row < design.rows_in_plot(); ++row)
      for (std::size_t value = 0; value < 50; ++value) {
        EXPECT_EQ(design.sign(plot, row, value), -design.sign(plot + 1, row, value));
        if (value < 20) {
          EXPECT_EQ(design.sign(plot, row, value), design.sign(plot, 0, value));
        }
      }
}

TEST(Judgements, AreScaledToValuesThatMayBe) {
  EXPECT_EQ(scaled("2 mrad", 1.2), "2.4 mrad");
  EXPECT_EQ(scaled("0.8 m/s2", 0.8), "0.64 m/s2") << "the 2 belongs to the unit";
  EXPECT_EQ(scaled("[1.15, 0.5]", 0.8), "[0.92, 0.4]");
  EXPECT_EQ(scaled("60", 0.8), "48");
  EXPECT_EQ(scaled("2", 1.2), "3") << "a count stays whole, and changes";
  EXPECT_EQ(scaled("0", 1.2), "0.2");
  EXPECT_EQ(scaled("0", 0.8), "0");
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
