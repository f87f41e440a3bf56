// SPDX-License-Identifier: MIT
#include "ubf/decorator/timing.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

Child delay(double duration, Child child) {
  auto node = make<Delay<State, Action>>(std::move(child));
  node->duration = duration;
  return node;
}

TEST(Delay, RunsWithoutAProposalUntilTheTimeIsUp) {
  Robot robot(delay(2, probe(0)));
  robot.cue(0) = {kRunning, 3, {.heading = 1}};
  for (const double when : {10.0, 11.9}) {
    EXPECT_EQ(robot.tick_at(when), kRunning);
    EXPECT_TRUE(robot.out.is_empty());
    EXPECT_FALSE(robot.asked_now("root/probe"));
  }
  EXPECT_EQ(robot.tick_at(12), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_EQ(robot.tick_at(12.1), kRunning);
  EXPECT_TRUE(robot.asked_now("root/probe"));
}

TEST(Delay, WaitsAgainWhenItsChildHasEnded) {
  for (const Status end : {kFailure, kSuccess}) {
    Robot robot(delay(2, probe(0)));
    robot.say(0, end);
    robot.tick_at(10);
    EXPECT_EQ(robot.tick_at(12), end);
    EXPECT_EQ(robot.tick_at(12.1), kRunning);
    EXPECT_FALSE(robot.asked_now("root/probe"));
    EXPECT_EQ(robot.tick_at(14.1), end);
  }
}

TEST(Delay, IsOnTimeAlthoughTimesAreSumsOfSteps) {
  Robot robot(delay(0.5, probe(0)));
  robot.tick_at(0.2);
  robot.tick_at(0.7);
  EXPECT_TRUE(robot.asked_now("root/probe"));
}

TEST(Delay, ForgetsItsClockWhenItLosesControl) {
  Robot robot(make<Selector<State, Action>>(probe(1), delay(2, probe(0))));
  robot.tick_at(0);
  robot.say(1, kRunning);
  robot.tick_at(1);
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick_at(2.5), kRunning);
  EXPECT_FALSE(robot.asked_now("root/delay/probe"));
}

}  // namespace
}  // namespace eyrie::ubf::testing
