// SPDX-License-Identifier: MIT
#include "ubf/arbiter/layers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

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
