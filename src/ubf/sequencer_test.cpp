// SPDX-License-Identifier: MIT
#include "ubf/sequencer.hpp"

#include <gtest/gtest.h>

#include "support/ubf/registry.hpp"
#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Phases = Sequencer<State, Action>;
using Transitions = std::vector<Transition>;

Child named(std::string name, Child node) {
  node->set_label(std::move(name));
  return node;
}

/// Trees out (cue 0), fight (cue 1) and home (cue 2). Rules, in this order:
/// out -> fight when cue 3, fight -> out when cue 4, any -> home when cue 5.
Child mission() {
  Children trees, conditions;
  trees.push_back(named("out", probe(0)));
  trees.push_back(named("fight", probe(1)));
  trees.push_back(named("home", probe(2)));
  conditions.push_back(named("see", probe(3)));
  conditions.push_back(named("clear", probe(4)));
  conditions.push_back(named("bingo", probe(5)));
  return make<Phases>(std::move(trees), std::vector<Phases::Rule>{{0, 1}, {1, 0}, {kNone, 2}},
                      std::move(conditions));
}

Robot robot_on_a_mission() {
  Robot robot(mission());
  for (std::size_t i = 0; i < 3; ++i)
    robot.cue(i) = {kRunning, 1, {.altitude = static_cast<double>(i)}};
  return robot;
}

Transitions logged(const Robot& robot) {
  return {robot.log.entries().begin(), robot.log.entries().end()};
}

TEST(Sequencer, EntersItsFirstTreeAndReportsThat) {
  Robot robot = robot_on_a_mission();
  EXPECT_EQ(phase(robot), "");
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.altitude, 0);
  EXPECT_EQ(robot.supplier(1), "root/out");
  EXPECT_EQ(logged(robot), (Transitions{{0, kNone, 0}}));
  EXPECT_EQ(phase(robot), "out");
  robot.tick();
  EXPECT_EQ(logged(robot), Transitions{});
}

TEST(Sequencer, HandsControlOverInTheTickInWhichTheConditionSucceeds) {
  Robot robot = robot_on_a_mission();
  robot.tick();
  robot.say(3, kSuccess);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 1);
  EXPECT_FALSE(robot.asked_now("root/out"));
  EXPECT_EQ(logged(robot), (Transitions{{0, 0, 1}}));
  EXPECT_EQ(phase(robot), "fight");
}

TEST(Sequencer, MakesTheTreeItLeavesForgetExactlyOnce) {
  Robot robot = robot_on_a_mission();
  robot.tick();
  robot.tick();
  EXPECT_EQ(robot.asked("root/out"), 2u);
  robot.say(3, kSuccess);
  robot.tick();
  EXPECT_EQ(robot.halts("root/out"), 1);
  EXPECT_EQ(robot.asked("root/out"), 0u);
  robot.say(3, kFailure);
  robot.tick();
  EXPECT_EQ(robot.halts("root/out"), 0);
}

TEST(Sequencer, MakesAlsoATreeForgetThatHasEnded) {
  Robot robot = robot_on_a_mission();
  robot.say(0, kSuccess);
  robot.tick();
  robot.say(3, kSuccess);
  robot.tick();
  EXPECT_EQ(robot.asked("root/out"), 0u);
}

TEST(Sequencer, TakesTheFirstTransitionInFileOrderAndOnlyOnePerTick) {
  Robot robot = robot_on_a_mission();
  robot.say(3, kSuccess);
  robot.say(4, kSuccess);
  robot.say(5, kSuccess);
  robot.tick();
  EXPECT_EQ(logged(robot), (Transitions{{0, kNone, 0}, {0, 0, 1}}));
  EXPECT_FALSE(robot.asked_now("root/bingo"));
  robot.tick();
  EXPECT_EQ(logged(robot), (Transitions{{0, 1, 0}}));
}

TEST(Sequencer, AsksOnlyConditionsThatLeaveTheActiveTree) {
  Robot robot = robot_on_a_mission();
  robot.tick();
  EXPECT_TRUE(robot.asked_now("root/see"));
  EXPECT_FALSE(robot.asked_now("root/clear"));
  EXPECT_TRUE(robot.asked_now("root/bingo"));
}

TEST(Sequencer, DoesNotEnterAgainFromAnyTheTreeThatIsAlreadyActive) {
  Robot robot = robot_on_a_mission();
  robot.say(5, kSuccess);
  robot.tick();
  robot.tick();
  EXPECT_EQ(phase(robot), "home");
  EXPECT_EQ(logged(robot), Transitions{});
  EXPECT_FALSE(robot.asked_now("root/bingo"));
  EXPECT_EQ(robot.asked("root/home"), 2u);
}

TEST(Sequencer, ARunningConditionDoesNotFireAndKeepsItsMemory) {
  Robot robot = robot_on_a_mission();
  robot.say(3, kRunning);
  robot.tick();
  robot.tick();
  EXPECT_EQ(phase(robot), "out");
  EXPECT_EQ(robot.asked("root/see"), 2u);
}

TEST(Sequencer, MakesTheConditionsForgetAtATransition) {
  Robot robot = robot_on_a_mission();
  robot.say(3, kRunning);
  robot.say(5, kRunning);
  robot.tick();
  robot.say(3, kSuccess);
  robot.tick();
  EXPECT_EQ(robot.halts("root/see"), 1);
  EXPECT_EQ(robot.asked("root/see"), 0u);
  EXPECT_EQ(robot.halts("root/bingo"), 1);
  EXPECT_EQ(robot.asked("root/bingo"), 0u);
  EXPECT_EQ(robot.halts("root/clear"), 0);
}

TEST(Sequencer, IgnoresWhatConditionsPropose) {
  Robot robot = robot_on_a_mission();
  robot.cue(3) = {kFailure, 9, {.heading = 1}};
  robot.cue(5) = {kRunning, 9, {.release = 1}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.altitude = 0}));
  EXPECT_EQ(robot.out.vote, 1);
}

TEST(Sequencer, SendsUpTheStatusOfTheActiveTree) {
  Robot robot = robot_on_a_mission();
  for (const Status says : {kSuccess, kRunning, kFailure}) {
    robot.say(0, says);
    EXPECT_EQ(robot.tick(), says);
  }
}

TEST(Sequencer, StartsFromItsFirstTreeAfterItLostControl) {
  Robot robot(make<Selector<State, Action>>(probe(9), mission()));
  robot.say(3, kSuccess);
  robot.cue(1) = {kSuccess, 1, {}};
  robot.tick();
  EXPECT_EQ(phase(robot), "fight");
  robot.say(9, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/sequencer"), 1);
  EXPECT_EQ(phase(robot), "");
  robot.say(9, kFailure);
  robot.say(3, kFailure);
  robot.tick();
  EXPECT_EQ(logged(robot), (Transitions{{2, kNone, 0}}));
}

TEST(Sequencer, WorksWithoutAnyoneListening) {
  Robot robot = robot_on_a_mission();
  RobotProposal out;
  EXPECT_EQ(robot.tree.tick({.state = robot.state, .memory = robot.slab.data()}, out), kRunning);
  EXPECT_EQ(out.action.altitude, 0);
}

TEST(Sequencer, RefusesRulesThatLeadNowhere) {
  const auto problem = [](std::vector<Phases::Rule> rules, std::size_t conditions,
                          std::uint16_t start) {
    return make<Phases>(probes(2), std::move(rules), probes(conditions), start)->problem();
  };
  EXPECT_EQ(problem({{0, 1}}, 1, 0), "");
  EXPECT_EQ(problem({}, 0, 2), "a sequencer needs a tree to start with");
  EXPECT_EQ(problem({{0, 1}}, 0, 0), "a sequencer needs one condition per transition");
  const std::string nowhere = "a transition leads from one tree of the sequencer to another";
  EXPECT_EQ(problem({{0, 2}}, 1, 0), nowhere);
  EXPECT_EQ(problem({{2, 0}}, 1, 0), nowhere);
  EXPECT_EQ(problem({{1, 1}}, 1, 0), nowhere);
  EXPECT_EQ(make<Phases>()->problem(), "a sequencer needs a tree to start with");
}

}  // namespace
}  // namespace eyrie::ubf::testing
