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

}  // namespace
}  // namespace eyrie::ubf::testing
