// SPDX-License-Identifier: MIT
#include "campaign/replicate.hpp"

#include <gtest/gtest.h>

namespace eyrie::campaign {
namespace {

SeedFlown flown(std::uint64_t seed, std::uint32_t blue_losses, std::uint32_t red_losses,
                double time, scenario::Outcome outcome = scenario::Outcome::blue_home) {
  SeedFlown one;
  one.seed = seed;
  one.hash = 100 + seed;
  one.time = time;
  one.outcome = outcome;
  one.blue = {.losses = blue_losses, .shots = 4, .kills = red_losses};
  one.red = {.losses = red_losses, .shots = 2, .kills = blue_losses};
  return one;
}
std::string words(const SeedTable& seeds) {
  std::string all;
  for (const auto& [seed, why] : seeds.stand_out())
    all += fmt::format("{}: {}; ", seed, why);
  return all;
}

TEST(SeedTable, EstimateWhatSidesLoseAndShareOutcomes) {
  SeedTable seeds;
  seeds.add(flown(1, 1, 2, 100));
  seeds.add(flown(2, 0, 2, 200, scenario::Outcome::time));
  seeds.add(flown(3, 1, 1, 300));
  EXPECT_EQ(seeds.share(scenario::Outcome::blue_home).count, 2U);
  EXPECT_EQ(seeds.share(scenario::Outcome::time).count, 1U);
  std::map<std::string, SeedEstimate> by_name;
  for (const SeedEstimate& estimate : seeds.estimates())
    by_name.emplace(estimate.name, estimate);
  EXPECT_EQ(by_name.at("end time, s").value, 200);
  EXPECT_NEAR(*by_name.at("red losses per blue loss").value, 2.5, 1e-12);
  EXPECT_FALSE(by_name.at("red losses per blue loss").interval) << "of three flights: no bounds";
  EXPECT_NEAR(*by_name.at("kills per blue shot").value, 5.0 / 12, 1e-12);
  EXPECT_TRUE(by_name.at("kills per blue shot").interval);
}

TEST(SeedTable, NameThoseThatStandOut) {
  SeedTable seeds;
  EXPECT_EQ(words(seeds), "");
  seeds.add(flown(7, 1, 2, 100));
  EXPECT_EQ(words(seeds), "7: first, typical, longest; ");
  seeds.add(flown(8, 0, 4, 150));
  seeds.add(flown(9, 1, 2, 160));
  seeds.add(flown(10, 4, 1, 170, scenario::Outcome::fault));
  seeds.add(flown(11, 1, 3, 900));
  EXPECT_EQ(words(seeds),
            "7: first, worst for blue; 8: best for blue; 9: typical; 10: fault; 11: longest; ");
}

TEST(SeedTable, CountFaultsAndNothingElseOfThem) {
  SeedTable seeds;
  seeds.add(flown(1, 4, 0, 900, scenario::Outcome::fault));
  EXPECT_EQ(words(seeds), "1: fault; ");
  EXPECT_FALSE(seeds.estimates().front().value);
  seeds.add(flown(2, 1, 2, 100));
  seeds.add(flown(3, 2, 2, 200));
  EXPECT_EQ(seeds.flown(), 3U);
  EXPECT_EQ(seeds.share(scenario::Outcome::fault).n, 3U);
  const auto estimates = seeds.estimates();
  EXPECT_EQ(estimates[0].value, 1.5) << estimates[0].name;
  EXPECT_TRUE(estimates[0].interval);
  EXPECT_FALSE(estimates[1].interval) << "both are 2";
  EXPECT_NEAR(*estimates[5].value, 4.0 / 3, 1e-12) << estimates[5].name;
  EXPECT_EQ(words(seeds).find("1: first"), std::string::npos) << words(seeds);
}

TEST(SeedTable, HashTheirOrder) {
  SeedTable one, other;
  one.add(flown(1, 0, 0, 1));
  one.add(flown(2, 0, 0, 1));
  other.add(flown(2, 0, 0, 1));
  other.add(flown(1, 0, 0, 1));
  EXPECT_NE(one.hash(), other.hash());
}

}  // namespace
}  // namespace eyrie::campaign
