// SPDX-License-Identifier: MIT
#include "campaign/whole_scenario.hpp"

#include <gtest/gtest.h>

#include "campaign/replicate.hpp"

namespace eyrie::campaign {
namespace {

TEST(WholeScenario, FliesAsTheOneItWasMadeOf) {
  const std::vector<std::string> sets{"until=6 min",
                                      "trees.press.per_field.release_weapon.zone=1.5",
                                      "blue.flights.eagle.players.eagle2.fuel=4000 kg"};
  scenario::Source disk = scenario::Source::disk(".");
  const auto original = scenario::load({.file = "scenarios/sweep.yaml", .sets = sets}, disk);
  const std::string text = whole_scenario("scenarios/sweep.yaml", sets, disk).text;
  EXPECT_EQ(text.find("include"), text.npos);
  disk.add("elsewhere/whole.yaml", text);
  const auto whole = scenario::load({.file = "elsewhere/whole.yaml"}, disk);
  EXPECT_EQ(fly(original, 1).hash, fly(whole, 1).hash);
  EXPECT_NE(
      fly(original, 1).hash,
      fly(scenario::load({.file = "scenarios/sweep.yaml", .sets = {"until=6 min"}}, disk), 1).hash);
}

TEST(WholeScenario, FindsANetworkThatAnOptionNamed) {
  scenario::Source disk = scenario::Source::disk(".");
  const std::string text =
      whole_scenario("scenarios/merge.yaml",
                     {"trees.dogfight={policy: {file: scenarios/policies/merge.safetensors}}"},
                     disk)
          .text;
  disk.add("elsewhere/whole.yaml", text);
  EXPECT_NO_THROW(static_cast<void>(scenario::load({.file = "elsewhere/whole.yaml"}, disk)));
}

TEST(WholeScenario, KeepsEveryScenario) {
  for (const auto& entry : std::filesystem::directory_iterator("scenarios")) {
    if (entry.path().extension() != ".yaml")
      continue;
    scenario::Source disk = scenario::Source::disk(".");
    const std::string text = whole_scenario(entry.path().string(), {}, disk).text;
    disk.add("whole.yaml", text);
    std::shared_ptr<const scenario::Scenario> whole;
    EXPECT_NO_THROW(whole = scenario::load({.file = "whole.yaml"}, disk)) << entry.path();
    ASSERT_TRUE(whole);
    const auto original = scenario::load({.file = entry.path().string()}, disk);
    EXPECT_EQ(fly(original, 1, {}, 30.0).hash, fly(whole, 1, {}, 30.0).hash) << entry.path();
  }
}

}  // namespace
}  // namespace eyrie::campaign
