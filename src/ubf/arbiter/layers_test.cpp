// SPDX-License-Identifier: MIT
#include "ubf/arbiter/layers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

using Rank = Priority<State, Action>;

/// Child i proposes altitude i, so that the result tells who was chosen.
Robot robot_interrupted(std::vector<bool> interruptible) {
  const std::size_t count = interruptible.size();
  auto node = make<Rank>(probes(count));
  node->interruptible = std::move(interruptible);
  Robot robot(std::move(node));
  for (std::size_t i = 0; i < count; ++i)
    robot.cue(i).action.altitude = static_cast<double>(i);
  return robot;
}

TEST(Priority, TakesTheFirstChildThatIsHeardHoweverItVotes) {
  Robot robot = robot_interrupted({true, true, true, true});
  robot.say(0, kFailure, 9);
  robot.say(1, kSuccess, 0);
  robot.say(2, kRunning, 1);
  robot.say(3, kSuccess, 8);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.altitude, 2);
  EXPECT_EQ(robot.out.vote, 1);
  EXPECT_EQ(robot.supplier(1), "root/probe[2]");
}

TEST(Priority, LetsAChildOfHigherRankTakeOver) {
  Robot robot = robot_interrupted({true, true});
  robot.say(1, kRunning, 5);
  robot.tick();
  robot.say(0, kRunning, 1);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 0);
  EXPECT_EQ(robot.halts("root/probe[1]"), 0) << "losers keep their memory";
}

TEST(Priority, DoesNotInterruptAChildThatIsNotInterruptibleBeforeItEnds) {
  for (const Status end : {kSuccess, kFailure}) {
    Robot robot = robot_interrupted({true, false, true});
    robot.say(1, kRunning, 5);
    robot.tick();
    robot.say(0, kRunning, 9);
    robot.say(2, kRunning, 9);
    EXPECT_EQ(robot.tick(), kRunning);
    EXPECT_EQ(robot.out.action.altitude, 1);
    robot.say(1, end, 5);
    robot.tick();
    EXPECT_EQ(robot.out.action.altitude, end == kSuccess ? 1 : 0);
    robot.say(1, kRunning, 5);
    robot.tick();
    EXPECT_EQ(robot.out.action.altitude, 0);
  }
}

TEST(Priority, LetsGoOfAChildThatAbstains) {
  Robot robot = robot_interrupted({true, false});
  robot.say(1, kRunning, 5);
  robot.tick();
  robot.say(0, kRunning, 1);
  robot.say(1, kRunning, 0);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 0);
}

TEST(Priority, RefusesMarksThatDoNotFitItsChildren) {
  auto node = make<Rank>(probes(2));
  EXPECT_EQ(node->problem(), "");
  node->interruptible = {true};
  EXPECT_EQ(node->problem(), "'interruptible' has 1 items for 2 children");
}

RC_GTEST_PROP(PriorityLaw, IsWinnerTakesAllOverRanks, ()) {
  const Cues cues = *any_cues();
  Cues ranked = cues;
  for (std::size_t i = 0; i < cues.size(); ++i)
    if (cues[i].vote > 0)
      ranked[i].vote = static_cast<float>(cues.size() - i);
  const std::size_t first = strongest(ranked);
  const Answer answer = ask<Rank>(cues);
  if (first == cues.size())
    RC_ASSERT(answer == Answer{});
  else
    RC_ASSERT(answer ==
              (Answer{cues[first].status, {cues[first].action, cues[first].vote, kNone}}));
}

RC_GTEST_PROP(PriorityLaw, WhoIsNotHeardChangesNothing, ()) {
  const Cues cues = *any_cues();
  Cues heard;
  std::copy_if(cues.begin(), cues.end(), std::back_inserter(heard), is_heard);
  RC_PRE(!heard.empty());
  RC_ASSERT(ask<Rank>(heard) == ask<Rank>(cues));
}

RC_GTEST_PROP(PriorityLaw, WhatRunsAndIsNotInterruptibleGoesOnWhileItIsHeard, ()) {
  auto node = make<Rank>(probes(3));
  node->interruptible = {false, false, false};
  Robot robot(std::move(node));
  std::optional<std::size_t> held;
  for (int tick = 0; tick < 20; ++tick) {
    Cues cues(3);
    for (std::size_t i = 0; i < cues.size(); ++i) {
      cues[i] = *any_cue();
      cues[i].action = {.altitude = static_cast<double>(i)};
    }
    const Answer answer = ask(robot, cues);
    const auto chosen = answer.proposal.action.altitude;
    if (held && is_heard(cues[*held]))
      RC_ASSERT(chosen == static_cast<double>(*held));
    held.reset();
    if (answer.status == kRunning)
      held = static_cast<std::size_t>(*chosen);
  }
}

using Over = Suppress<State, Action>;

/// Probe 0 is the higher layer and asks for heading 1, probe 1 the lower one for heading 2.
Robot suppressing(double hold) {
  auto node = make<Over>(probes(2));
  node->hold = hold;
  Robot robot(std::move(node));
  robot.cue(0).action.heading = 1;
  robot.cue(1).action.heading = 2;
  return robot;
}

TEST(Suppress, ReplacesTheLowerLayerHoweverItVotes) {
  Robot robot = suppressing(0);
  robot.say(0, kSuccess, 1);
  robot.say(1, kRunning, 9);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.out.vote, 1);
  EXPECT_TRUE(robot.asked_now("root/probe[1]")) << "the lower layer goes on";
}

TEST(Suppress, LetsTheLowerLayerThroughWhenTheHigherOneIsSilent) {
  Robot robot = suppressing(0);
  robot.say(0, kRunning, 1);
  robot.say(1, kSuccess, 9);
  robot.tick();
  for (const Status silent : {kFailure, kRunning}) {
    robot.say(0, silent, 0);
    EXPECT_EQ(robot.tick(), kSuccess);
    EXPECT_EQ(robot.out.action.heading, 2);
    EXPECT_EQ(robot.supplier(0), "root/probe[1]");
  }
}

TEST(Suppress, HoldsTheLastProposalOfTheHigherLayer) {
  Robot robot = suppressing(2);
  robot.say(0, kSuccess, 3);
  robot.say(1, kRunning, 9);
  robot.tick_at(10);
  robot.say(0, kFailure);
  robot.cue(0).action.heading = 7;
  EXPECT_EQ(robot.tick_at(11.9), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_EQ(robot.out.vote, 3);
  EXPECT_EQ(robot.leader(), "root/probe[0]");
  EXPECT_EQ(robot.supplier(0), "root/probe[0]");
  EXPECT_TRUE(robot.trace.row(0).held[0]);
  robot.say(0, kRunning, 0);  // proposes something else, without a vote
  EXPECT_EQ(robot.tick_at(11.95), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_TRUE(robot.trace.row(0).held[0]);
  EXPECT_FALSE(robot.trace.row(1).held[0]) << "what it proposes now";
  EXPECT_EQ(robot.tick_at(12), kRunning);
  EXPECT_EQ(robot.out.action.heading, 2);
  EXPECT_FALSE(robot.trace.row(0).held[0]);
}

TEST(Suppress, FailsWhenBothAreSilentAndForgets) {
  Robot robot = suppressing(1);
  robot.say(0, kRunning, 3);
  robot.tick_at(1);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick_at(2), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
  const std::size_t own = sizeof(SuppressMemory<Action>);
  EXPECT_TRUE(std::all_of(robot.slab.begin(), robot.slab.begin() + own,
                          [](std::byte byte) { return byte == std::byte{0}; }));
}

TEST(Suppress, HasTwoLayers) {
  EXPECT_EQ(make<Over>(probes(1))->problems(),
            std::vector<std::string>{"takes exactly 'by', 'child', but has 1 child"});
  EXPECT_EQ(make<Over>(probes(2))->problems(), std::vector<std::string>{});
}

RC_GTEST_PROP(SuppressLaw, IsTheFirstOfTwoThatIsHeard, ()) {
  const Cues cues{*any_cue(), *any_cue()};
  Cues ranked = cues;
  for (std::size_t i = 0; i < 2; ++i)
    if (cues[i].vote > 0)
      ranked[i].vote = static_cast<float>(2 - i);
  const std::size_t first = strongest(ranked);
  const Answer answer = ask<Over>(cues);
  if (first == 2)
    RC_ASSERT(answer == Answer{});
  else
    RC_ASSERT(answer ==
              (Answer{cues[first].status, {cues[first].action, cues[first].vote, kNone}}));
}

RC_GTEST_PROP(SuppressLaw, TheLowerLayerIsHeardOnlyAfterTheHold, ()) {
  const int hold = *rc::gen::inRange(1, 10);  // ticks
  Robot robot = suppressing(0.1 * hold);
  robot.say(1, kRunning, 1);
  int silent = 1000;
  for (int tick = 0; tick < 60; ++tick) {
    const bool speaks = *rc::gen::inRange(0, 4) == 0;
    robot.say(0, speaks ? kRunning : kFailure, 1);
    silent = speaks ? 0 : silent + 1;
    robot.tick();
    RC_ASSERT(robot.out.action.heading == (silent < hold ? 1 : 2));
  }
}

using Block = Inhibit<State, Action>;

Robot inhibiting(double hold) {
  auto node = make<Block>(probes(2));
  node->hold = hold;
  return Robot(std::move(node));
}

TEST(Inhibit, BlocksTheLowerLayerWhileTheHigherOneDoesNotFail) {
  Robot robot = inhibiting(0);
  robot.cue(0).action.heading = 1;
  robot.cue(1) = {kSuccess, 4, {.heading = 2}};
  for (const Status answer : {kRunning, kSuccess}) {
    robot.say(0, answer, 9);
    EXPECT_EQ(robot.tick(), kFailure);
    EXPECT_TRUE(robot.out.is_empty());
    EXPECT_TRUE(robot.asked_now("root/probe[1]"));
  }
  robot.say(0, kFailure, 9);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 2}));
  EXPECT_EQ(robot.out.vote, 4);
  EXPECT_EQ(robot.leader(), "root/probe[1]");
}

TEST(Inhibit, GoesOnForTheHold) {
  Robot robot = inhibiting(2);
  robot.cue(1) = {kRunning, 4, {.heading = 2}};
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick_at(10), kFailure);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick_at(11.9), kFailure);
  EXPECT_STREQ(robot.trace.why(0), "it was inhibited a moment ago");
  EXPECT_EQ(robot.tick_at(12), kRunning);
}

TEST(Inhibit, MayBeDoneByACondition) {
  Robot robot(make<Block>(check(0), probe(1)));
  robot.cue(1) = {kRunning, 4, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick(), kFailure);
}

TEST(Inhibit, FailsIfTheLowerLayerAbstains) {
  Robot robot = inhibiting(0);
  robot.cue(1) = {kRunning, 0, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(Inhibit, HasTwoLayers) {
  EXPECT_EQ(make<Block>(probes(3))->problems(),
            std::vector<std::string>{"takes exactly 'by', 'child', but has 3 children"});
  EXPECT_EQ(make<Block>(probes(2))->problems(), std::vector<std::string>{});
}

RC_GTEST_PROP(InhibitLaw, IsTheLowerLayerOrNothing, ()) {
  const Cues cues{*any_cue(), *any_cue()};
  const Answer answer = ask<Block>(cues);
  if (cues[0].status == kFailure && is_heard(cues[1]))
    RC_ASSERT(answer == (Answer{cues[1].status, {cues[1].action, cues[1].vote, kNone}}));
  else
    RC_ASSERT(answer == Answer{});
}

RC_GTEST_PROP(InhibitLaw, TheLowerLayerIsHeardOnlyAfterTheHold, ()) {
  const int hold = *rc::gen::inRange(1, 10);  // ticks
  Robot robot = inhibiting(0.1 * hold);
  robot.say(1, kRunning, 1);
  int silent = 1000;
  for (int tick = 0; tick < 60; ++tick) {
    const bool speaks = *rc::gen::inRange(0, 4) == 0;
    robot.say(0, speaks ? kRunning : kFailure);
    silent = speaks ? 0 : silent + 1;
    RC_ASSERT(robot.tick() == (silent < hold || speaks ? kFailure : kRunning));
  }
}

}  // namespace
}  // namespace eyrie::ubf::testing
