// SPDX-License-Identifier: MIT
#include "ubf/control/sequence.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Select = Selector<State, Action>;

TEST(Selector, SendsUpTheActionOfTheFirstChildThatDoesNotFailEvenWithoutAVote) {
  Robot robot(make<Select>(probes(3)));
  robot.cue(0) = {kFailure, 9, {.heading = 0}};
  robot.cue(1) = {kRunning, 0, {.heading = 1}};
  robot.cue(2) = {kRunning, 5, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.out.vote, 0);
  EXPECT_FALSE(robot.asked_now("root/probe[2]"));
  EXPECT_EQ(robot.supplier(0), "root/probe[1]");
}

TEST(Selector, NeverMixesInWhatAFailingChildLeftBehind) {
  Robot robot(make<Select>(probes(2)));
  robot.cue(0) = {kFailure, 9, {.heading = 0, .altitude = 5}};
  robot.cue(1) = {kSuccess, 1, {.speed = 2}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.speed = 2}));
}

TEST(Selector, LetsAnEarlierChildTakeOverAndTheRunningOneForgetOnce) {
  Robot robot(make<Select>(probes(2)));
  robot.say(0, kFailure);
  robot.say(1, kRunning);
  robot.tick();
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe[1]"), 2u);
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[1]"), 1);
  EXPECT_EQ(robot.asked("root/probe[1]"), 0u);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[1]"), 0);
}

TEST(Selector, LeavesTheMemoryOfAChildThatEndedByItselfAlone) {
  Robot robot(make<Select>(probes(2)));
  robot.say(0, kFailure);
  robot.say(1, kSuccess);
  robot.tick();
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe[1]"), 1u);
}

TEST(Selector, HaltsAnArbiterItTurnsAwayFromEvenIfThatSucceeded) {
  Robot robot(make<Select>(probe(0), make<Wta>(probe(1), probe(2))));
  robot.say(0, kFailure);
  robot.say(1, kSuccess, 5);
  robot.say(2, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  robot.tick();
  const std::string loser = "root/winner_takes_all/probe[1]";
  EXPECT_EQ(robot.asked(loser), 2u) << "asked in every tick, so it goes on";
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts(loser), 1);
  EXPECT_EQ(robot.asked(loser), 0u);
  robot.tick();
  EXPECT_EQ(robot.halts(loser), 0);
}

TEST(Selector, ForgettingReachesEveryLevelAtOnce) {
  Robot robot(make<Select>(probe(0), make<Select>(make<Select>(probe(1)))));
  robot.say(0, kFailure);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/selector/selector/probe"), 1);
  EXPECT_EQ(robot.asked("root/selector/selector/probe"), 0u);
}

TEST(Selector, GivesThePlainTreeUnderAnArbiterItsVote) {
  auto plain = make<Select>(probe(0), probe(1));
  plain->vote = 7;
  Robot robot(make<Wta>(std::move(plain), probe(2)));
  robot.cue(1) = {kRunning, 0, {.heading = 1}};
  robot.cue(2) = {kRunning, 6, {.heading = 2}};
  robot.tick();
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_EQ(robot.out.vote, 7);
}

TEST(Selector, TellsWhichChildIsRunning) {
  Robot robot(make<Select>(probes(2)));
  EXPECT_EQ(robot.tree.root().active_child(robot.slab.data()), kNone);
  robot.say(1, kRunning);
  robot.tick();
  EXPECT_EQ(robot.tree.root().active_child(robot.slab.data()), 1);
}

}  // namespace
}  // namespace eyrie::ubf::testing
