// SPDX-License-Identifier: MIT
// The architectures of studies/architectures fly, and what is known of them beforehand holds.
#include <gtest/gtest.h>

#include "record/story.hpp"
#include "scenario/mission.hpp"

namespace eyrie {
namespace {

struct Flown {
  record::Tally::OfSide blue, red;
  std::uint64_t hash = 0;
};
Flown flown(const std::string& tree, std::uint64_t seed = 1) {
  const auto scenario = scenario::load(
      {.file = "studies/architectures/mission.yaml", .sets = {"blue.flights.eagle.tree=" + tree}},
      scenario::Source::disk("."));
  record::Tally tally(*scenario);
  scenario::Mission mission(scenario, seed);
  mission.run().attach(tally);
  mission.fly();
  EXPECT_NE(mission.outcome(), scenario::Outcome::fault) << tree;
  return {tally.side(model::Side::blue), tally.side(model::Side::red),
          mission.run().world().hash()};
}

TEST(Architectures, FightAllOfThem) {
  for (const char* tree :
       {"paper_fusion", "weighted_fusion", "per_field", "subsumption", "sequencer"}) {
    const Flown run = flown(tree);
    EXPECT_GT(run.blue.shots, 0U) << tree;
    EXPECT_GT(run.red.shots, 0U) << tree;
  }
}

// votes that do not change rank the behaviors once and for all, as a selector does; but that asks
// nobody behind the chosen one, who then forgets what he avoided (one of ten flights)
TEST(Architectures, WinnerTakesAllWithVotesInOrderIsABehaviorTree) {
  const Flown arbiter = flown("winner_takes_all", 4), tree = flown("behavior_tree", 4);
  EXPECT_EQ(arbiter.blue.losses, tree.blue.losses);
  EXPECT_EQ(arbiter.blue.shots, tree.blue.shots);
  EXPECT_EQ(arbiter.red.shots, tree.red.shots);
  EXPECT_EQ(arbiter.hash, tree.hash) << "everybody has come home, or is lost";
}

}  // namespace
}  // namespace eyrie
