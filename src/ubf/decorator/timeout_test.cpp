// SPDX-License-Identifier: MIT
#include "ubf/decorator/timing.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

Child timeout(double after, Child child) {
  auto node = make<Timeout<State, Action>>(std::move(child));
  node->after = after;
  return node;
}

TEST(Timeout, FailsAndHaltsAChildThatRunsForTooLong) {
  Robot robot(timeout(2, probe(0)));
  robot.cue(0) = {kRunning, 3, {.heading = 1}};
  EXPECT_EQ(robot.tick_at(10), kRunning);
  EXPECT_EQ(robot.tick_at(11.9), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_EQ(robot.tick_at(12), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
  EXPECT_FALSE(robot.asked_now("root/probe"));
  EXPECT_EQ(robot.halts("root/probe"), 1);
  EXPECT_EQ(robot.asked("root/probe"), 0u);
}

TEST(Timeout, BeginsAnewInTheNextTick) {
  Robot robot(timeout(2, probe(0)));
  robot.say(0, kRunning);
  robot.tick_at(0);
  EXPECT_EQ(robot.tick_at(5), kFailure);
  EXPECT_EQ(robot.tick_at(5.1), kRunning);
  EXPECT_EQ(robot.tick_at(7), kRunning);
  EXPECT_EQ(robot.tick_at(7.1), kFailure);
}

TEST(Timeout, CountsFromWhenTheChildBeganToRunAndNotFromWhenItEnded) {
  Robot robot(timeout(2, probe(0)));
  robot.say(0, kRunning);
  robot.tick_at(0);
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick_at(1.9), kSuccess);
  robot.say(0, kRunning);
  EXPECT_EQ(robot.tick_at(3), kRunning);
  EXPECT_EQ(robot.tick_at(4.9), kRunning);
  EXPECT_EQ(robot.tick_at(5), kFailure);
}

TEST(Timeout, IsOnTimeAlthoughTimesAreSumsOfSteps) {
  Robot robot(timeout(0.5, probe(0)));
  robot.say(0, kRunning);
  robot.tick_at(0.2);
  EXPECT_LT(0.7 - 0.2, 0.5);
  EXPECT_EQ(robot.tick_at(0.7), kFailure);
}

TEST(Timeout, ForgetsItsClockWhenItLosesControl) {
  Robot robot(make<Selector<State, Action>>(probe(1), timeout(2, probe(0))));
  robot.say(0, kRunning);
  robot.tick_at(0);
  robot.say(1, kRunning);
  robot.tick_at(1);
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick_at(2.5), kRunning);
  EXPECT_EQ(robot.tick_at(4.4), kRunning);
  EXPECT_EQ(robot.tick_at(4.5), kFailure);
}

}  // namespace
}  // namespace eyrie::ubf::testing
