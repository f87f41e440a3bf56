// SPDX-License-Identifier: MIT
#include "campaign/factor.hpp"

#include <gtest/gtest.h>

#include "core/yaml.hpp"

namespace eyrie::campaign {
namespace {

Factor factor(const std::string& text) {
  Diagnostics diagnostics;
  const Value map = parse_yaml("f: " + text, "f.yaml", diagnostics);
  std::vector<Factor> factors = read_factors(map, diagnostics);
  EXPECT_TRUE(diagnostics.ok()) << diagnostics.text();
  return factors.at(0);
}

TEST(Factor, SetsEveryPathToItsLevel) {
  const Factor f = factor("{path: [a.b, c], values: [1 nmi, [x, 'y, z'], {k: {v: null}}]}");
  ASSERT_EQ(f.levels.size(), 3U);
  EXPECT_EQ(f.sets_of("1 nmi"), (std::vector<std::string>{"a.b=1 nmi", "c=1 nmi"}));
  EXPECT_EQ(f.levels[1].sets[1], "c=[x, \"y, z\"]");
  EXPECT_EQ(f.levels[2].name, "{k: {v: null}}");
}

TEST(Factor, MayNameItsLevels) {
  const Factor f = factor("{path: a, values: {near: 40 nmi, far: [90 nmi]}}");
  EXPECT_EQ(f.value_at(0.49), "near");
  EXPECT_EQ(f.value_at(0.5), "far");
  EXPECT_EQ(f.sets_of("far"), std::vector<std::string>{"a=[90 nmi]"});
}

TEST(Factor, StepsThroughARange) {
  const Factor f = factor("{path: a, values: !range {from: 1 nmi, to: 2 nmi, count: 4}}");
  std::vector<std::string> names;
  for (const Level& level : f.levels)
    names.push_back(level.name);
  EXPECT_EQ(names, (std::vector<std::string>{"1 nmi", "1.33333 nmi", "1.66667 nmi", "2 nmi"}));
}

TEST(Factor, TakesAShareOfItsDistribution) {
  EXPECT_EQ(factor("{path: a, values: !uniform {low: 1 nmi, high: 3 nmi}}").value_at(0.25),
            "1.5 nmi");
  EXPECT_EQ(factor("{path: a, values: !log_uniform {low: 1, high: 100}}").value_at(0.5), "10");
  const Factor normal = factor("{path: a, values: !normal {mean: 100 kg, deviation: 10 kg}}");
  EXPECT_EQ(normal.value_at(0.5), "100 kg");
  EXPECT_EQ(normal.value_at(0.975), "119.6 kg");
  EXPECT_EQ(normal.sets_of("119.6 kg"), std::vector<std::string>{"a=119.6 kg"});
}

TEST(Factor, WritesValuesOfANarrowRangeWithAsManyDigitsAsTellThemApart) {
  const auto at = [](const std::string& values, double u) {
    return factor("{path: a, values: " + values + "}").value_at(u);
  };
  EXPECT_EQ(at("!uniform {low: 1000 kg, high: 1000.001 kg}", 0.25), "1000.00025 kg");
  EXPECT_EQ(at("!normal {mean: 1000, deviation: 0.001}", 0.975), "1000.00196");
  EXPECT_EQ(at("!range {from: 50000 ft, to: 49999.9 ft, count: 3}", 0.5), "49999.95 ft");
}

/// SciPy: scipy.stats.norm.ppf(p).
TEST(NormalQuantile, IsThatOfTheReference) {
  EXPECT_DOUBLE_EQ(normal_quantile(0.5), 0);
  EXPECT_NEAR(normal_quantile(0.9), 1.2815515655446004, 1e-14);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.001), -3.090232306167813, 1e-14);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-13);
  EXPECT_NEAR(normal_quantile(1e-20), -9.262340089798408, 1e-13);
}

}  // namespace
}  // namespace eyrie::campaign
