// SPDX-License-Identifier: MIT
#include "ubf/control/branch.hpp"

#include <gtest/gtest.h>

#include "support/ubf/registry.hpp"
#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using If = IfThenElse<State, Action>;

TEST(IfThenElse, AsksTheBranchThatItsConditionSays) {
  Robot robot(make<If>(probes(3)));
  robot.cue(1) = {kSuccess, 2, {.heading = 1}};
  robot.cue(2) = {kSuccess, 3, {.heading = 2}};
  robot.cue(0) = {kSuccess, 9, {.heading = 0, .altitude = 5}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1})) << "what the condition proposes is ignored";
  EXPECT_EQ(robot.supplier(0), "root/probe[1]");
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.action.heading, 2);
  EXPECT_EQ(robot.out.vote, 3);
}

TEST(IfThenElse, DoesNotAskTheConditionWhileABranchRuns) {
  Robot robot(make<If>(probes(3)));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_FALSE(robot.asked_now("root/probe[0]"));
  EXPECT_TRUE(robot.asked_now("root/probe[1]"));
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  robot.tick();
  EXPECT_TRUE(robot.asked_now("root/probe[2]")) << "the condition is asked again";
}

TEST(IfThenElse, RunsWithoutAProposalWhileItsConditionRuns) {
  Robot robot(make<If>(probes(3)));
  robot.cue(0) = {kRunning, 9, {.heading = 0}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(IfThenElse, ClosesAnArbiterThatEnded) {
  Robot robot(make<If>(check(2), make<Wta>(probe(0), probe(1)), probe(3)));
  robot.say(2, kSuccess);
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
}

TEST(IfThenElse, HasThreeChildren) {
  EXPECT_EQ(make<If>(probes(2))->problems(),
            std::vector<std::string>{"takes exactly 'if', 'then', 'else', but has 2 children"});
  EXPECT_EQ(make<If>(probes(3))->problems(), std::vector<std::string>{});
}

using Loop = While<State, Action>;

TEST(While, ChecksItsConditionInEveryTick) {
  Robot robot(make<Loop>(probes(3)));
  robot.cue(0) = {kSuccess, 9, {.altitude = 5}};
  robot.cue(1) = {kRunning, 2, {.heading = 1}};
  robot.cue(2) = {kRunning, 3, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 2}));
  EXPECT_EQ(robot.supplier(0), "root/probe[2]");
}

TEST(While, MakesTheBranchItTurnsAwayFromForgetOnce) {
  Robot robot(make<Loop>(probes(3)));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kFailure);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[1]"), 1);
  EXPECT_EQ(robot.asked("root/probe[1]"), 0u);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[1]"), 0);
}

TEST(While, LeavesTheMemoryOfABranchThatEndedByItselfAlone) {
  Robot robot(make<Loop>(probes(3)));
  robot.say(0, kSuccess);
  robot.say(1, kSuccess);
  robot.tick();
  robot.say(0, kFailure);
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe[1]"), 1u);
}

TEST(While, AlsoHaltsAnArbiterThatStandsAlthoughItEnded) {
  Robot robot(make<Loop>(check(2), make<Wta>(probe(0), probe(1)), probe(3)));
  robot.say(2, kSuccess);
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 0);
  robot.say(2, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
}

TEST(While, TreatsARunningConditionAsOneThatDoesNotHold) {
  Robot robot(make<Loop>(probes(3)));
  robot.say(0, kRunning);
  robot.say(2, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/probe[0]"), 1);
}

TEST(While, HasThreeChildren) {
  EXPECT_EQ(make<Loop>(probes(2))->problems(),
            std::vector<std::string>{"takes exactly 'when', 'do', 'else', but has 2 children"});
  EXPECT_EQ(make<Loop>(probes(3))->problems(), std::vector<std::string>{});
}

/// Children for phases 0 and 1, and with `has_default` one for the rest.
Robot by_phase(bool has_default) {
  auto node = make<Switch<State, Action>>(probes(has_default ? 3 : 2));
  node->look_at([](const State& s) { return static_cast<double>(s.phase); }, {0, 1});
  return Robot(std::move(node));
}

TEST(Switch, AsksTheChildOfTheValueAndHandsItsProposalOn) {
  Robot robot = by_phase(true);
  for (std::uint8_t phase = 0; phase < 3; ++phase) {
    robot.state.phase = phase;
    robot.cue(phase) = {kSuccess, static_cast<float>(phase + 1), {.heading = phase}};
    EXPECT_EQ(robot.tick(), kSuccess);
    EXPECT_EQ(robot.out.vote, phase + 1);
    EXPECT_EQ(robot.leader(), fmt::format("root/probe[{}]", phase));
    for (int other = 0; other < 3; ++other)
      EXPECT_EQ(robot.asked_now(fmt::format("root/probe[{}]", other)), other == phase);
  }
}

TEST(Switch, FailsWithoutAChildForTheValueAndWithoutAValue) {
  Robot robot = by_phase(false);
  robot.state.phase = 2;
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty() || robot.status == kFailure);
  auto node = make<Switch<State, Action>>(probes(2));
  node->look_at([](const State&) { return kNoValue; }, {0});
  Robot unknown(std::move(node));
  unknown.say(1, kRunning, 1);
  EXPECT_EQ(unknown.tick(), kRunning) << "the default";
}

TEST(Switch, MakesTheChildItTurnsAwayFromForgetOnce) {
  Robot robot = by_phase(false);
  robot.say(0, kRunning, 1);
  robot.say(1, kRunning, 1);
  robot.tick();
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe[0]"), 2u);
  robot.state.phase = 1;
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[0]"), 1);
  EXPECT_EQ(robot.asked("root/probe[0]"), 0u);
  robot.state.phase = 2;
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.halts("root/probe[0]"), 0);
  EXPECT_EQ(robot.halts("root/probe[1]"), 1);
}

TEST(Switch, IsReadWithItsCases) {
  Robot robot(
      build("{switch: {on: phase, cases: {fetch: {probe: {cue: 1}}, home: {probe: {cue: 2}}}, "
            "default: {probe: {cue: 3}}, vote_scale: 2}}"));
  const auto vote = [&](std::uint8_t phase) {
    for (std::size_t i = 1; i < 4; ++i)
      robot.say(i, kRunning, static_cast<float>(i));
    robot.state.phase = phase;
    robot.tick();
    return robot.out.vote;
  };
  EXPECT_EQ(vote(0), 6);
  EXPECT_EQ(vote(1), 2);
  EXPECT_EQ(vote(2), 4);
}

TEST(Switch, MistakesAreSaid) {
  EXPECT_EQ(mistakes("{switch: {on: phas, cases: {home: {probe: {cue: 1}}}}}"),
            "test.yaml:1:15: there is no state field 'phas'; did you mean 'phase'?");
  EXPECT_EQ(mistakes("{switch: {on: phase, cases: {hom: {probe: {cue: 1}}}}}"),
            "test.yaml:1:30: 'phase' is never 'hom'; did you mean 'home'?");
  EXPECT_EQ(mistakes("{switch: {on: alarm, cases: {yes: {probe: {cue: 1}}}}}"),
            "test.yaml:1:30: 'alarm' is never 'yes'");
  EXPECT_EQ(mistakes("{switch: {on: count, cases: {1: {probe: {cue: 1}}, 1.0: {probe: "
                     "{cue: 1}}}}}"),
            "test.yaml:1:52: there are two cases '1.0'");
  EXPECT_EQ(mistakes("{switch: {on: phase}}"),
            "test.yaml:1:2: switch needs 'cases', a map from values to nodes");
}

}  // namespace
}  // namespace eyrie::ubf::testing
