// SPDX-License-Identifier: MIT
#include "campaign/summary.hpp"

#include <gtest/gtest.h>

#include "core/draw.hpp"
#include "core/math.hpp"
#include "support/campaign/made_up.hpp"
#include "support/program.hpp"

namespace eyrie::campaign {
namespace {

/// Three cells of 30 replicates with "end" as given; "kills" is 1 everywhere.
template <class End>
Summary flown(const test::TempFolder& folder, const Spec& spec, End end) {
  const std::vector<Cell> cells = cells_of(spec);
  Store store(folder / "out", spec, cells, {}, false);
  for (std::uint64_t cell = 0; cell < 3; ++cell)
    for (std::uint64_t i = 0; i < 30; ++i) {
      Result result = test::made_up(spec, cell, i);
      result.flown.outcome = scenario::Outcome::time;
      result.flown.fault.clear();
      result.values = {end(cell, i), 1, 1, cell == 2 && i % 3 == 0 ? 1.0 : 0.0};
      store.put(result);
    }
  store.flush();
  return read_summary(folder / "out");
}

TEST(Compare, SubtractsWhatCellsShareReplicateByReplicate) {
  const test::TempFolder folder;
  const Spec spec = test::made_up_spec();
  // the noise of a replicate is a hundred times the difference of the cells
  const Summary summary = flown(folder, spec, [](std::uint64_t cell, std::uint64_t i) {
    return 100.0 * static_cast<double>(i % 7) + static_cast<double>(cell) +
           0.1 * static_cast<double>(i % 2);
  });
  EXPECT_LT(summary.cells[0].estimates[0].interval->low, *summary.cells[2].estimates[0].value);
  const auto all = compare(folder / "out", summary);
  ASSERT_EQ(all.size(), 3 * 4U);
  for (const Comparison& c : all) {
    EXPECT_EQ(c.n, 30U);
    EXPECT_GE(c.holm, c.p);
    if (c.measure == 0) {
      EXPECT_NEAR(c.value, static_cast<double>(c.cell) - static_cast<double>(c.than), 1e-9);
      EXPECT_LT(c.holm, 1e-6);
    } else if (c.measure == 3 && c.cell == 2) {
      EXPECT_NEAR(c.value, 1.0 / 3, 1e-9);
      // 10 pairs differ, all in one direction: 2 / 2^10
      EXPECT_NEAR(c.p, 2.0 / 1024, 1e-12);
      EXPECT_NEAR(c.holm, 6.0 / 1024, 1e-12);  // the least of three comparisons, twice
    } else {
      EXPECT_EQ(c.value, 0);
      EXPECT_EQ(c.p, 1);
    }
  }
  const auto by_one = compare(folder / "out", summary, 3);
  ASSERT_EQ(by_one.size(), 3U);
  for (const Comparison& c : by_one) {
    EXPECT_EQ(c.measure, 3U);
    EXPECT_NEAR(c.holm, c.cell == 2 ? 6.0 / 1024 : 1, 1e-12);
  }
}

TEST(Compare, TakesCellsOfOtherSeedsAsIndependent) {
  const test::TempFolder folder;
  Spec spec = test::made_up_spec();
  spec.seeds.paired = false;
  // what pairs by number would take for a difference without noise
  const Summary summary = flown(folder, spec, [](std::uint64_t cell, std::uint64_t i) {
    return cell == 2 && i % 2 ? math::kNaN : static_cast<double>(i + cell);
  });
  EXPECT_FALSE(summary.paired);
  stats::Moments all, half;
  for (int i = 0; i < 30; ++i) {
    all.add(i);
    if (i % 2 == 0)
      half.add(i + 2);
  }
  bool found = false;
  for (const Comparison& c : compare(folder / "out", summary)) {
    EXPECT_EQ(c.n_than, 30U);
    if (c.measure == 0 && c.cell == 2 && c.than == 0) {
      found = true;
      EXPECT_EQ(c.n, 15U);
      EXPECT_NEAR(c.value, half.mean() - all.mean(), 1e-12);
      EXPECT_NEAR(c.p, stats::welch_test(half, all), 1e-12);
      EXPECT_EQ(c.interval->low, stats::welch_interval(half, all)->low);
    } else if (c.measure == 3 && c.cell == 2 && c.than == 0) {
      EXPECT_NEAR(c.p, stats::fisher({10, 30}, {0, 30}), 1e-12);
    }
  }
  EXPECT_TRUE(found);
  // a part has other replicates of each cell
  Database(folder / "out/results.db", Database::Access::write)
      .run("DELETE FROM replicates WHERE replicate % 3 <> cell % 3");
  EXPECT_FALSE(read_summary(folder / "out").paired);
}

/// The summary of a full factorial of two factors with these values, the second changing fastest,
/// each with that standard error.
Summary factorial(std::vector<double> values, std::optional<double> error = 0.0) {
  Summary summary;
  summary.factors = {"a", "b"};
  summary.measures = {{"x", Measure::mean, 0, 0}};
  for (std::size_t i = 0; i < values.size(); ++i)
    summary.cells.push_back({{i < 2 ? "low" : "high", i % 2 ? "on" : "off"},
                             "",
                             10,
                             0,
                             {{10, values[i], std::nullopt, error}}});
  return summary;
}

TEST(Effects, AddUpToAllWhereFactorsAdd) {
  const Summary summary = factorial({0, 1, 3, 4});
  const auto all = effects(summary);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].factor, 0U);
  EXPECT_NEAR(all[0].part, 0.9, 1e-12);
  EXPECT_NEAR(all[1].part, 0.1, 1e-12);
  EXPECT_EQ(all[0].levels[1].name, "high");
  EXPECT_EQ(all[0].levels[1].mean, 3.5);
  for (const Interaction& both : interactions(summary))
    EXPECT_NEAR(both.part, 0, 1e-12);
}

TEST(Effects, AreNoneWhereOnlyBothTogetherMatter) {
  const Summary summary = factorial({0, 1, 1, 0});
  for (const Effect& effect : effects(summary))
    EXPECT_NEAR(effect.part, 0, 1e-12);
  ASSERT_EQ(interactions(summary).size(), 1U);
  EXPECT_NEAR(interactions(summary)[0].part, 1, 1e-12);
}

TEST(Effects, AreNoneOfAMeasureThatNoCellHas) {
  Summary summary = factorial({0, 0, 0, 0});
  for (auto& cell : summary.cells)
    cell.estimates[0].value.reset();
  EXPECT_TRUE(effects(summary).empty());
  for (const Interaction& both : interactions(summary))
    EXPECT_EQ(both.part, 0);
}

/// Cells of factors with so many levels each, a value per cell from `value_of` its levels.
Summary crossed_cells(const std::vector<int>& counts, std::size_t cells, auto value_of) {
  Summary summary;
  summary.measures = {{"x", Measure::mean, 0, 0}};
  for (std::size_t f = 0; f < counts.size(); ++f)
    summary.factors.push_back(fmt::format("f{}", f));
  for (std::size_t c = 0; c < cells; ++c) {
    std::vector<std::string> levels;
    std::size_t rest = c;
    for (const int count : counts) {
      levels.push_back(std::to_string(rest % static_cast<std::size_t>(count)));
      rest /= static_cast<std::size_t>(count);
    }
    summary.cells.push_back({levels, "", 10, 0, {{10, value_of(c), std::nullopt}}});
  }
  return summary;
}

TEST(Interactions, AreNoneOfMorePairsThanTheCellsTellApart) {
  // a Latin square: every two of three factors are crossed, each combination in one cell
  Summary summary = crossed_cells({4, 4}, 16, [](std::size_t c) { return double(c * 7 % 5); });
  summary.factors.emplace_back("third");
  for (std::size_t c = 0; c < 16; ++c)
    summary.cells[c].values.push_back(std::to_string((c + c / 4) % 4));
  EXPECT_TRUE(interactions(summary).empty());
}

TEST(Interactions, OfFactorsThatDoNothingAreNoneInTheMean) {
  double sum = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Draw draw(1, PlayerId{1}, Stream::test, i);
    for (const Interaction& both :
         interactions(crossed_cells({3, 3, 3}, 27, [&](std::size_t) { return draw.normal(); })))
      sum += both.part / (400 * 3);
  }
  EXPECT_LT(sum, 0.1) << "of them chance alone would have 2/13, but what is below 0 is left out";
}

TEST(Interactions, OfTwoFactorsAloneAreToldFromChanceByTheReplicates) {
  double sum = 0, together = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Draw draw(1, PlayerId{1}, Stream::test, i);
    std::vector<double> values;
    for (int cell = 0; cell < 4; ++cell)
      values.push_back(draw.normal());
    for (const Interaction& both : interactions(factorial(values, 1.0)))
      sum += both.part / 400;
    values[0] += 20;  // which three of the four effects share
    for (const Interaction& both : interactions(factorial(values, 1.0)))
      together += both.part / 400;
  }
  EXPECT_LT(sum, 0.16) << "of them chance alone has 1/3, but what is below 0 is left out";
  EXPECT_NEAR(together, 1.0 / 3, 0.03);
  EXPECT_TRUE(interactions(factorial({0, 1, 1, 0}, std::nullopt)).empty()) << "one replicate each";
}

TEST(Interactions, AreFoundBesideAThirdFactor) {
  const auto all = interactions(crossed_cells({2, 2, 2}, 8, [](std::size_t c) {
    return double((c & 1) ^ (c >> 1 & 1)) + 3 * double(c >> 2);
  }));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].one, 0U);
  EXPECT_EQ(all[0].other, 1U);
  EXPECT_NEAR(all[0].part, 0.1, 1e-12);  // 1/4 of 1/4 + 9/4
}

TEST(Effects, OfManyNumbersAreThoseOfBins) {
  Summary summary;
  summary.factors = {"speed"};
  summary.measures = {{"x", Measure::mean, 0, 0}};
  for (int i = 0; i < 80; ++i)
    summary.cells.push_back({{fmt::format("{} kt", (i * 37) % 80)},
                             "",
                             10,
                             0,
                             {{10, static_cast<double>((i * 37) % 80), std::nullopt}}});
  const auto all = effects(summary);
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].levels.size(), 8U);
  EXPECT_GT(all[0].part, 0.98);
  for (const auto& level : all[0].levels)
    EXPECT_EQ(level.cells, 10U);
  EXPECT_EQ(all[0].levels[0].name, "0 kt to 9 kt");
  EXPECT_EQ(all[0].levels[7].name, "70 kt to 79 kt");
}

TEST(Effects, OfNumbersInSeveralUnitsPutNoneTogether) {
  Summary summary;
  summary.factors = {"within"};
  summary.measures = {{"x", Measure::mean, 0, 0}};
  for (int i = 1; i < 13; ++i)
    summary.cells.push_back({{i < 12 ? fmt::format("{} s", i) : "1 min"},
                             "",
                             10,
                             0,
                             {{10, static_cast<double>(i), std::nullopt}}});
  EXPECT_TRUE(effects(summary).empty()) << "each cell has another level, 1 min is not 1 s";
}

TEST(Effects, OfDrawnNumbersThatDoNothingAreMostlyNone) {
  int none = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    Draw draw(1, PlayerId{1}, Stream::test, i);
    Summary summary;
    summary.factors = {"speed"};
    summary.measures = {{"x", Measure::mean, 0, 0}};
    for (int c = 0; c < 16; ++c)
      summary.cells.push_back(
          {{fmt::format("{} kt", draw.uniform())}, "", 10, 0, {{10, draw.normal(), std::nullopt}}});
    none += effects(summary).empty();
  }
  EXPECT_NEAR(none / 400.0, 0.55, 0.1) << "eight bins over 16 cells have 7/15 by chance";
}

TEST(Effects, AreNoneOfAFactorThatIsOfEachCellAnother) {
  Summary summary = factorial({0, 1, 3, 4});
  summary.factors = {"a"};
  for (std::size_t c = 0; c < summary.cells.size(); ++c)
    summary.cells[c].values = {fmt::format("{} kt", c)};
  EXPECT_TRUE(effects(summary).empty());
}

/// The summary of cells of which the measure is the second factor.
Summary second_factor_only(std::size_t cells, std::size_t (*first)(std::size_t),
                           std::size_t (*second)(std::size_t)) {
  Summary summary;
  summary.factors = {"nothing", "all"};
  summary.measures = {{"x", Measure::mean, 0, 0}};
  for (std::size_t c = 0; c < cells; ++c)
    summary.cells.push_back({{fmt::format("{} kt", first(c)), fmt::format("{} s", second(c))},
                             "",
                             10,
                             0,
                             {{10, static_cast<double>(second(c)), std::nullopt}}});
  return summary;
}

TEST(Effects, OfCrossedFactorsDoNotLeakIntoEachOther) {
  const auto all = effects(second_factor_only(
      36, [](std::size_t c) { return c / 3; }, [](std::size_t c) { return c % 3; }));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].factor, 1U);
  EXPECT_NEAR(all[0].part, 1, 1e-12);
  const auto swapped = effects(second_factor_only(
      36, [](std::size_t c) { return c % 3; }, [](std::size_t c) { return c / 3; }));
  ASSERT_EQ(swapped.size(), 1U);
  EXPECT_EQ(swapped[0].levels.size(), 12U) << "levels are not binned";
  EXPECT_NEAR(swapped[0].part, 1, 1e-12);
}

TEST(Effects, OfEqualNumbersAreInOneBin) {
  const Summary summary = second_factor_only(
      40, [](std::size_t) -> std::size_t { return 7; }, [](std::size_t c) { return c % 25; });
  const auto all = effects(summary);
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].levels.size(), 8U);
  for (const auto& level : all[0].levels) {
    const double low = std::stod(level.name),
                 high = std::stod(level.name.substr(level.name.find("to ") + 3));
    std::size_t inside = 0;
    for (const auto& cell : summary.cells)
      inside += low <= std::stod(cell.values[1]) && std::stod(cell.values[1]) <= high;
    EXPECT_EQ(level.cells, inside) << level.name;
  }
}

/// The comparison of a ratio over 100 pairs.
template <class Pair>
std::vector<Comparison> ratio_of(Pair pair) {
  const std::vector<Measure> ratio{{"r", Measure::ratio, 0, 1}};
  return compare_pairs(ratio, [&](const TakePair& use) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const auto [one, other] = pair(i);
      use(one, other);
    }
  });
}
using Values = std::pair<std::vector<double>, std::vector<double>>;

TEST(ComparePairs, RejectsEqualRatiosAsOftenAsItSays) {
  int rejected = 0, missed = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const auto same = ratio_of([&](std::uint64_t replicate) {
      Draw draw(1, PlayerId{1}, Stream::test, 100 * i + replicate);
      const auto some = [&](double share) { return draw.uniform() < share ? 1.0 : 0.0; };
      // both are 1, of .3 over .3 and of 1.5 over 1.5
      return Values{{1 + some(0.5), 1 + some(0.5)}, {some(0.3), some(0.3)}};
    });
    ASSERT_EQ(same.size(), 1U);
    rejected += same[0].p < 0.05;
    missed += same[0].interval->low > 0 || same[0].interval->high < 0;
  }
  EXPECT_NEAR(rejected / 1000.0, 0.05, 0.02);
  EXPECT_EQ(missed, rejected);
}

TEST(ComparePairs, AreNotOfRoundingWhereBothCellsHaveTheSame) {
  const std::vector<Measure> share{{"s", Measure::share, 0, 0}};
  for (std::uint64_t n = 2; n < 60; ++n) {  // one and the other in turn, as often
    const auto same = compare_pairs(share, [&](const TakePair& use) {
      for (std::uint64_t i = 0; i < 2 * n; ++i)
        use({i * 7 % (2 * n) < n ? 1.0 : 0.0}, {i * 7 % (2 * n) < n ? 0.0 : 1.0});
    });
    ASSERT_EQ(same.size(), 1U);
    EXPECT_EQ(same[0].value, 0) << n;
  }
}

TEST(ComparePairs, HasNoneOfARatioOverWhatMayAsWellBeZero) {
  const auto over = [](double one, double often) {
    return ratio_of([=](std::uint64_t i) {
      return Values{{2, 1 + static_cast<double>(i % 2)}, {2, i % 50 == 0 ? one : often}};
    });
  };
  EXPECT_EQ(over(1, 1).size(), 1U);
  EXPECT_TRUE(over(0, 0).empty());
  EXPECT_TRUE(over(1, 0).empty()) << "2 of 100";
}

}  // namespace
}  // namespace eyrie::campaign
