// SPDX-License-Identifier: MIT
#include "campaign/design.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>

namespace eyrie::campaign {
namespace {

Factor levels(const std::string& name, const std::vector<std::string>& values) {
  Factor factor{.name = name, .where = {}, .paths = {name}, .levels = {}, .distribution = {}};
  for (const std::string& value : values)
    factor.levels.push_back({value, {name + "=" + value}});
  return factor;
}
Factor uniform(const std::string& name) {
  Factor factor = levels(name, {});
  factor.distribution = {Distribution::Kind::uniform, 0, 1, ""};
  return factor;
}
/// How many cells lie in each of n equal parts of (0, 1).
std::vector<int> strata(std::span<const Cell> cells, std::size_t factor, std::size_t n) {
  std::vector<int> count(n);
  for (const Cell& cell : cells)
    ++count[static_cast<std::size_t>(std::atof(cell.values[factor].c_str()) *
                                     static_cast<double>(n))];
  return count;
}

TEST(FullFactorial, IsEveryCombinationTheLastFactorFirst) {
  const std::vector<Factor> factors{levels("a", {"1", "2"}), levels("b", {"x", "y", "z"})};
  std::string all;
  for (const Cell& cell : cells_of({}, factors))
    all += cell.values[0] + cell.values[1] + " ";
  EXPECT_EQ(all, "1x 1y 1z 2x 2y 2z ");
  EXPECT_EQ(cells_of({}, {}), std::vector<Cell>(1)) << "no factor: one cell";
}

TEST(OneAtATime, ChangesOneFactorFromTheFirstLevels) {
  const std::vector<Factor> factors{levels("a", {"1", "2"}), levels("b", {"x", "y", "z"})};
  std::string all;
  for (const Cell& cell : cells_of({.kind = DesignKind::one_at_a_time, .cells = {}}, factors))
    all += cell.values[0] + cell.values[1] + " ";
  EXPECT_EQ(all, "1x 2x 1y 1z ");
}

TEST(LatinHypercube, HasOneCellInEachStratumOfEachFactor) {
  const std::vector<Factor> factors{uniform("a"), uniform("b"), levels("c", {"x", "y", "z", "w"})};
  for (const std::uint64_t seed : {1U, 2U}) {
    const auto cells =
        cells_of({.kind = DesignKind::latin_hypercube, .cells = 40, .seed = seed}, factors);
    EXPECT_EQ(strata(cells, 0, 40), std::vector<int>(40, 1));
    EXPECT_EQ(strata(cells, 1, 40), std::vector<int>(40, 1));
    std::map<std::string, int> count;
    for (const Cell& cell : cells)
      ++count[cell.values[2]];
    EXPECT_EQ(count["x"], 10);
    EXPECT_EQ(count["w"], 10);
    double covariance = 0;
    for (const Cell& cell : cells)
      covariance += (std::atof(cell.values[0].c_str()) - 0.5) *
                    (std::atof(cell.values[1].c_str()) - 0.5) / 40;
    EXPECT_LT(std::abs(covariance) * 12, 0.5) << "the factors go each its own way";
  }
  const Design one{.kind = DesignKind::latin_hypercube, .cells = 40, .seed = 1};
  Design other = one;
  other.seed = 2;
  EXPECT_EQ(cells_of(one, factors), cells_of(one, factors));
  EXPECT_NE(cells_of(one, factors), cells_of(other, factors));
}

/// The first points of Joe & Kuo's own program with new-joe-kuo-6.21201.
TEST(Sobol, IsTheReferenceSequence) {
  const double expected[10][3] = {{0, 0, 0},
                                  {0.5, 0.5, 0.5},
                                  {0.75, 0.25, 0.25},
                                  {0.25, 0.75, 0.75},
                                  {0.375, 0.375, 0.625},
                                  {0.875, 0.875, 0.125},
                                  {0.625, 0.125, 0.875},
                                  {0.125, 0.625, 0.375},
                                  {0.1875, 0.3125, 0.9375},
                                  {0.6875, 0.8125, 0.4375}};
  for (std::uint32_t i = 0; i < 10; ++i)
    for (std::size_t d = 0; d < 3; ++d)
      EXPECT_EQ(sobol(i, d) * 0x1p-32, expected[i][d]) << i << ", " << d;
}

TEST(Sobol, FillsEachDimensionEvenlyAndNoTwoAlike) {
  std::set<std::vector<std::uint32_t>> all;
  for (std::size_t d = 0; d < kSobolDimensions; ++d) {
    std::set<std::uint32_t> parts;
    std::vector<std::uint32_t> points;
    for (std::uint32_t i = 0; i < 1024; ++i) {
      points.push_back(sobol(i, d));
      parts.insert(points.back() >> 22);
    }
    EXPECT_EQ(parts.size(), 1024U) << d;
    all.insert(points);
  }
  EXPECT_EQ(all.size(), kSobolDimensions);
}

TEST(Sobol, StaysEvenWhenItIsShifted) {
  const std::vector<Factor> factors{uniform("a"), uniform("b")};
  const auto cells = cells_of({.kind = DesignKind::sobol, .cells = 64, .seed = 3}, factors);
  EXPECT_EQ(strata(cells, 0, 64), std::vector<int>(64, 1));
  std::set<std::pair<int, int>> squares;  // a (0, 6, 2)-net: one point in each of 8 x 8 squares
  for (const Cell& cell : cells)
    squares.emplace(static_cast<int>(8 * std::atof(cell.values[0].c_str())),
                    static_cast<int>(8 * std::atof(cell.values[1].c_str())));
  EXPECT_EQ(squares.size(), 64U);
  EXPECT_NE(cells[0].values[0], "0") << "a normal distribution has no value at 0";
}

TEST(Random, CoversTheFactorsEachByItself) {
  const std::vector<Factor> factors{uniform("a"), uniform("b")};
  const auto cells = cells_of({.kind = DesignKind::random, .cells = 4000}, factors);
  for (const std::size_t f : {0U, 1U})
    for (const int count : strata(cells, f, 4))
      EXPECT_NEAR(count, 1000, 4 * 28) << "binomial: a deviation of 27.4";
  int both = 0;
  for (const Cell& cell : cells)
    both += std::atof(cell.values[0].c_str()) < 0.5 && std::atof(cell.values[1].c_str()) < 0.5;
  EXPECT_NEAR(both, 1000, 4 * 28);
}

TEST(Design, SaysWhyThereIsNone) {
  const auto why = [](const Design& design, std::span<const Factor> factors) {
    return problem_of(design, factors).value().message;
  };
  const std::vector<Factor> many(22, uniform("a"));
  EXPECT_EQ(why({.kind = DesignKind::sobol, .cells = 8}, many),
            "sobol takes at most 21 factors, here are 22; choose latin_hypercube");
  EXPECT_EQ(why({.kind = DesignKind::random, .cells = 8}, {}), "random needs factors");
  const std::vector<Factor> wide(6, levels("a", {"1", "2", "3", "4", "5", "6", "7"}));
  EXPECT_EQ(why({}, wide), "117649 combinations; at most 100000 cells are flown");
  EXPECT_EQ(why({.cells = 3}, std::span(wide).first(1)),
            "the levels say how many cells full_factorial has, not 'cells'");
}

}  // namespace
}  // namespace eyrie::campaign
