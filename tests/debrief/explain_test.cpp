// SPDX-License-Identifier: MIT
/// \file  Recorded runs looked at again: what is explained is what was flown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "debrief/what_if.hpp"
#include "pilot/outside.hpp"
#include "support/recorded.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

using namespace debrief;

class ExplainedRun : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Whole, ExplainedRun, testing::Values("sweep", "convoy"),
                         [](const auto& run) { return std::string(run.param); });

TEST_P(ExplainedRun, IsTheOneThatWasFlown) {
  const Recorded run = recorded_flight(GetParam(), 900, 5);
  const scenario::Scenario& s = *run.scenario;
  Reflight flight(run);
  std::size_t decisions = 0;
  while (flight.step()) {
    if (flight.before().step() / 5 % 5 != 0)  // every fifth decision
      continue;
    for (std::size_t i = 0; i < s.roster.players.size(); ++i) {
      const PlayerId who{static_cast<std::uint32_t>(i + 1)};
      const auto decision =
          debrief::explain(s, flight.before(), flight.after(), who, flight.orders());
      if (!decision)
        continue;
      ++decisions;
      // what the agent's row says after the step
      ASSERT_EQ(decision->leader, s.leader(flight.after(), who))
          << s.roster.name(who) << " at " << flight.time();
      ASSERT_EQ(decision->nodes.size() > 0, true);
      // the leader set what came out, or some of it, or did so earlier
      for (const Won& won : decision->action) {
        ASSERT_LT(won.winner, decision->nodes.size());
        if (!won.held) {
          ASSERT_TRUE(decision->nodes[won.winner].asked);
          ASSERT_NE(decision->nodes[won.winner].status, ubf::Status::failure);
        }
      }
    }
  }
  EXPECT_GT(decisions, 5'000U);
}

TEST(Explain, GivesAReasonForEveryBehaviorThatFails) {
  const Recorded run = recorded_flight("sweep_phases", 800, 13);
  Reflight flight(run);
  std::size_t failures = 0;
  while (flight.step()) {
    if (flight.before().step() / 5 % 5 != 0)
      continue;
    const auto d = debrief::explain(*run.scenario, flight.before(), flight.after(), PlayerId{1},
                                    flight.orders());
    for (std::size_t i = 0; d && i < d->nodes.size(); ++i) {
      const Answer& node = d->nodes[i];
      if (!node.is_leaf || !node.asked || node.status != ubf::Status::failure)
        continue;
      ++failures;
      ASSERT_NE(node.why, "") << node.path << " at " << d->time;
    }
  }
  EXPECT_GT(failures, 5'000U);
}

TEST(WhatIf, FindsNothingWithoutAChange) {
  const Recorded run = recorded_flight("sweep_phases", 700, 13);
  const auto same = with_overrides(run, {"trees.bvr.per_field.pursue.vote=40"});
  const WhatIf result = what_if(run, *same, PlayerId{2}, 0);
  EXPECT_GT(result.decisions, 3000U);
  EXPECT_EQ(result.different, 0U);
}

TEST(WhatIf, NamesTheTickInWhichTheChangedFlightFirstActsOtherwise) {
  const std::string change = "trees.ingress.winner_takes_all.follow_lead.vote=5";
  const Recorded run = recorded_flight("sweep_phases", 60, 13),
                 other = recorded_flight("sweep_phases", 60, 13, {change});
  std::string problem;
  const auto flown = compare(run, other, problem);
  ASSERT_TRUE(flown && flown->action) << problem;
  std::uint64_t first = ~std::uint64_t{0};
  for (std::uint32_t i = 1; i <= run.scenario->roster.players.size(); ++i)
    if (const WhatIf result = what_if(run, *other.scenario, PlayerId{i}, 0); result.first)
      first = std::min(first, result.first->step);
  EXPECT_EQ(first, flown->action->step);
}

TEST(WhatIf, SaysByHowMuch) {
  const Recorded run = recorded_flight("convoy", 500, 3);
  const auto other = with_overrides(run, {"trees.convoy.winner_takes_all.scatter.range=3 km"});
  const WhatIf result = what_if(run, *other, run.scenario->roster.find("supply2").value(), 0);
  ASSERT_TRUE(result.first);
  EXPECT_EQ(result.first->flown, "scatter");
  EXPECT_EQ(result.first->other, "follow_lead");
  EXPECT_EQ(result.spans.front().first, result.first->time);
  ASSERT_EQ(result.first->fields.at(0).name, "heading");
  EXPECT_NEAR(std::fabs(result.first->fields[0].difference.value()), si(70, "deg"), 0.3);
  EXPECT_EQ(result.first->fields.at(2).name, "call");
  EXPECT_EQ(result.first->fields[2].other, "-");
}

TEST(WhatIf, KeepsAVoteWithItsNodeWhereverThatStands) {
  Recorded run = recorded_flight("merge", 20);
  const auto& trees = run.scenario->fleets.front()->trees;
  const auto tree = std::ranges::find(trees, "dogfight", &ubf::AnyTree::name);
  ASSERT_NE(tree, trees.end());
  const auto node = (*tree)->find("root/ingress/navigate");
  ASSERT_TRUE(node);
  const PlayerId viper = *run.scenario->roster.find("viper1");
  scenario::Mission flown(run.scenario, run.run.seed, 20);
  const sim::Order vote = sim::order_for(
      0, viper, pilot::OrderKind::vote,
      model::VoteChange{.vote = 70,
                        .number = static_cast<std::uint16_t>(*node + 1),
                        .tree = static_cast<std::uint16_t>(tree - trees.begin() + 1)});
  ASSERT_EQ(flown.run().submit(vote), "");
  sim::TrailRecorder trail;
  flown.run().attach(trail);
  flown.fly();
  run.run.trail = trail.trail();
  run.run.orders = {vote};

  const std::string wall = "trees.wall={winner_takes_all: [{tree: evade}, ";
  const auto moved = with_overrides(
      run, {wall + "{avoid_collision: {vote: 90}}, {navigate: {vote: 10, speed: 520 kt}}, "
                   "{egress: {vote: 5}}]}"});
  EXPECT_TRUE(votes_left_out(run, *moved).empty());
  EXPECT_EQ(what_if(run, *moved, viper, 0).different, 0U);
  std::string problem;
  const auto on = branch(run, moved, past_at(run, 100), 20.0, problem);
  ASSERT_TRUE(on) << problem;
  on->fly();
  EXPECT_EQ(on->after().rows(run.scenario->aircraft.kinematics)[0].heading,
            flown.run().world().rows(run.scenario->aircraft.kinematics)[0].heading);

  const auto without =
      with_overrides(run, {wall + "{follow_lead: {vote: 20}}, {egress: {vote: 5}}]}"});
  EXPECT_EQ(votes_left_out(run, *without), std::vector<std::string>{"root/ingress/navigate"});
  // what no program writes
  for (const model::VoteChange& none :
       {model::VoteChange{.number = 0, .tree = 1}, model::VoteChange{.number = 0, .tree = 9000},
        model::VoteChange{.number = 9000, .tree = 1}, model::VoteChange{.number = 1, .tree = 9000}})
    run.run.orders.push_back(sim::order_for(0, viper, pilot::OrderKind::vote, none));
  EXPECT_EQ(votes_left_out(run, *without), std::vector<std::string>{"root/ingress/navigate"});
}

TEST(WhatIf, BranchesIntoTheSameEndWithoutAChange) {
  const Recorded run = recorded_flight("sweep_phases", 3600, 13);
  const Outcome flown = outcome_of(run);
  std::string problem;
  const auto branched =
      branch(run, run.scenario, past_at(run, 20'000), limit_of(run, flown), problem);
  ASSERT_TRUE(branched) << problem;
  const Outcome same = branched->fly();
  EXPECT_EQ(same.outcome, flown.outcome);
  EXPECT_EQ(same.time, flown.time);
  EXPECT_EQ(same.blue.shots, flown.blue.shots);
  EXPECT_EQ(same.red.losses, flown.red.losses);
  EXPECT_EQ(same.blue.home, flown.blue.home);
  const auto fewer =
      branch(run, with_overrides(run, {"trees.bvr.per_field.release_weapon.zone=0.1"}),
             past_at(run, 20'000), limit_of(run, flown), problem);
  ASSERT_TRUE(fewer) << problem;
  const Outcome other = fewer->fly();
  EXPECT_NE(std::pair(other.time, other.blue.shots), std::pair(flown.time, flown.blue.shots));
}

TEST(WhatIf, EndsWithARunThatRanOutOfTimeAndElseAsTheScenarioSays) {
  const Recorded whole = recorded_flight("sweep_phases", 3600, 13);
  const Outcome ended = outcome_of(whole);
  EXPECT_NE(ended.outcome, "time");
  EXPECT_FALSE(limit_of(whole, ended));
  // slower on the way home: later there
  std::string problem;
  const auto slower = with_overrides(whole, {"trees.home.winner_takes_all.egress.speed=350 kt"});
  const auto later = branch(whole, slower, past_at(whole, 20'000), limit_of(whole, ended), problem);
  ASSERT_TRUE(later) << problem;
  const Outcome home = later->fly();
  EXPECT_EQ(home.outcome, ended.outcome);
  EXPECT_EQ(home.blue.home, ended.blue.home);
  EXPECT_GT(home.time, ended.time);
  Recorded cut = recorded_flight("sweep_phases", 500, 13);
  EXPECT_EQ(outcome_of(cut).outcome, "time");
  EXPECT_EQ(limit_of(cut, outcome_of(cut)), 500);
  for (const char* said : {"stopped", "stopped at 08:20.0; losses: blue 0, red 0"}) {
    cut.run.outcome = said;
    EXPECT_EQ(outcome_of(cut).outcome, "stopped");
  }
  EXPECT_EQ(limit_of(cut, outcome_of(cut)), 500);
  cut.run.outcome = "blue_home";
  EXPECT_EQ(outcome_of(cut).outcome, "time") << "that none of its sides has ended it is seen";
}

TEST(RunDifference, IsNothingForTheSameRun) {
  const Recorded run = recorded_flight("merge", 60, 8);
  std::string problem;
  const auto same = compare(run, recorded_flight("merge", 60, 8), problem);
  ASSERT_TRUE(same) << problem;
  EXPECT_TRUE(same->same());
  EXPECT_EQ(same->steps, 3000U);
}

TEST(RunDifference, SaysWhenOneEndsBeforeTheOther) {
  std::string problem;
  const auto found =
      compare(recorded_flight("merge", 60, 8), recorded_flight("merge", 50, 8), problem);
  ASSERT_TRUE(found && found->world && found->event);
  EXPECT_EQ(found->steps, 2500U);
  EXPECT_EQ(found->world->text, "merge is over, the other goes on");
}

TEST(RunDifference, RefusesWorldsOfOtherTables) {
  std::string problem;
  EXPECT_FALSE(compare(recorded_flight("merge", 1, 8), recorded_flight("convoy", 1, 8), problem));
  EXPECT_NE(problem.find("other tables"), std::string::npos);
}

TEST(RunDifference, RefusesStepsOfAnotherLength) {
  std::string problem;
  const auto at = [](const char* rate) {
    return recorded_flight("merge", 1, 8,
                           {std::string("rates={kinematics: ") + rate + ", decisions: 10 Hz}"});
  };
  EXPECT_FALSE(compare(at("50 Hz"), at("100 Hz"), problem));
  EXPECT_EQ(problem, "merge has steps of 20 ms and merge of 10 ms: they cannot be compared");
}

TEST(RunDifference, ComparesTreesThatRememberOtherThings) {
  const Recorded run = recorded_text(kSmallScenario, 2);
  const Recorded other = recorded_text(
      changed_scenario(
          {{"  cruise:\n", "  cruise: {timeout: {after: 1 s, child: navigate}}\n  old:\n"}}),
      2);
  ASSERT_NE(run.run.layout_hash, other.run.layout_hash);
  std::string problem;
  const auto found = compare(run, other, problem);
  ASSERT_TRUE(found) << problem;
  EXPECT_EQ(found->world.value().text, "the trees of one remember more than those of the other");
  EXPECT_NEAR(found->action.value().time, 1.1, 0.2) << found->action->text;
}

}  // namespace
}  // namespace eyrie::test
