// SPDX-License-Identifier: MIT
#include "ubf/decorator/timing.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

Child rate_limit(double period, Child child) {
  auto node = make<RateLimit<State, Action>>(std::move(child));
  node->period = period;
  return node;
}

TEST(RateLimit, LetsItsChildBeginOncePerPeriod) {
  Robot robot(rate_limit(2, probe(0)));
  robot.cue(0) = {kSuccess, 3, {.release = 1}};
  EXPECT_EQ(robot.tick_at(10), kSuccess);
  EXPECT_EQ(robot.out.action.release, 1u);
  EXPECT_EQ(robot.tick_at(10.1), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
  EXPECT_FALSE(robot.asked_now("root/probe"));
  EXPECT_EQ(robot.tick_at(11.9), kFailure);
  EXPECT_EQ(robot.tick_at(12), kSuccess);
  EXPECT_EQ(robot.tick_at(13), kFailure);
}

TEST(RateLimit, CountsFromTheBeginningAndNeverCutsAChildShort) {
  Robot robot(rate_limit(2, probe(0)));
  robot.say(0, kRunning);
  for (const double when : {10.0, 11.0, 13.0})
    EXPECT_EQ(robot.tick_at(when), kRunning);
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick_at(13.5), kSuccess);
  EXPECT_EQ(robot.tick_at(13.6), kSuccess) << "the period passed while it ran";
  EXPECT_EQ(robot.tick_at(13.7), kFailure);
}

TEST(RateLimit, DoesNotCountAChildThatFailsWithoutHavingRun) {
  Robot robot(rate_limit(2, probe(0)));
  robot.tick_at(10);
  robot.tick_at(10.1);
  EXPECT_TRUE(robot.asked_now("root/probe"));
  robot.say(0, kRunning);
  robot.tick_at(10.2);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick_at(10.3), kFailure);
  robot.tick_at(10.4);
  EXPECT_FALSE(robot.asked_now("root/probe")) << "it failed after it had begun";
  robot.tick_at(12.2);
  EXPECT_TRUE(robot.asked_now("root/probe"));
}

TEST(RateLimit, ForgetsWhenItLosesControlWhileItsChildRuns) {
  Robot robot(make<Selector<State, Action>>(probe(1), rate_limit(9, probe(0))));
  robot.say(0, kRunning);
  robot.tick();
  robot.say(1, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/rate_limit"), 1);
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
}

}  // namespace
}  // namespace eyrie::ubf::testing
