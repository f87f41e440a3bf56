// SPDX-License-Identifier: MIT
#include "ubf/decorator/timing.hpp"

#include <gtest/gtest.h>

#include "support/ubf/testing.hpp"

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
  EXPECT_STREQ(robot.trace.why(0), "its time is up");
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

Child cooldown(double duration, Child child) {
  auto node = make<Cooldown<State, Action>>(std::move(child));
  node->duration = duration;
  return node;
}

TEST(Cooldown, KeepsAChildThatSucceededFromStartingAgain) {
  Robot robot(cooldown(3, probe(0)));
  robot.cue(0) = {kSuccess, 2, {.release = 1}};
  EXPECT_EQ(robot.tick_at(10), kSuccess);
  EXPECT_EQ(robot.out.action.release, 1u) << "the tick in which the child ends still counts";
  EXPECT_EQ(robot.tick_at(12.9), kFailure);
  EXPECT_STREQ(robot.trace.why(0), "it ended too recently");
  EXPECT_TRUE(robot.out.is_empty());
  EXPECT_FALSE(robot.asked_now("root/probe"));
  EXPECT_EQ(robot.tick_at(13), kSuccess);
}

TEST(Cooldown, StartsWhenARunningChildFailsButNotWhenOneWasNeverApplicable) {
  Robot robot(cooldown(3, probe(0)));
  robot.say(0, kFailure);
  robot.tick_at(1);
  EXPECT_EQ(robot.tick_at(2), kFailure);
  EXPECT_TRUE(robot.asked_now("root/probe"));
  robot.say(0, kRunning);
  EXPECT_EQ(robot.tick_at(3), kRunning);
  robot.say(0, kFailure);
  robot.tick_at(4);
  robot.tick_at(6.9);
  EXPECT_FALSE(robot.asked_now("root/probe"));
  robot.tick_at(7);
  EXPECT_TRUE(robot.asked_now("root/probe"));
}

TEST(Cooldown, GoesOnCoolingWhileOthersAreInControl) {
  Robot robot(make<Selector<State, Action>>(probe(1), cooldown(5, probe(0))));
  robot.say(0, kSuccess);
  robot.tick_at(0);
  robot.say(1, kRunning);
  robot.tick_at(1);
  robot.say(1, kFailure);
  robot.tick_at(4);
  EXPECT_FALSE(robot.asked_now("root/cooldown/probe"));
  robot.tick_at(5);
  EXPECT_TRUE(robot.asked_now("root/cooldown/probe"));
}

TEST(Cooldown, GoesOnCoolingAroundAnArbiterToo) {
  Robot robot(make<Selector<State, Action>>(probe(1), cooldown(5, make<Wta>(probe(0), probe(2)))));
  robot.say(0, kSuccess, 5);
  robot.say(2, kRunning, 1);
  robot.tick_at(0);
  EXPECT_EQ(robot.halts("root/cooldown/winner_takes_all/probe[1]"), 1)
      << "the arbiter is not asked for a while, so its loser loses control";
  robot.say(1, kRunning);
  robot.tick_at(1);
  robot.say(1, kFailure);
  robot.tick_at(4);
  EXPECT_FALSE(robot.asked_now("root/cooldown/winner_takes_all"));
}

TEST(Cooldown, ForgetsThatItsChildRanWhenBothAreHalted) {
  Robot robot(make<Selector<State, Action>>(probe(1), cooldown(5, probe(0))));
  robot.say(0, kRunning);
  robot.tick_at(0);
  robot.say(1, kRunning);
  robot.tick_at(1);
  EXPECT_EQ(robot.halts("root/cooldown/probe"), 1);
  robot.say(1, kFailure);
  robot.say(0, kFailure);
  robot.tick_at(2);
  robot.tick_at(3);
  EXPECT_TRUE(robot.asked_now("root/cooldown/probe"));
}

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
  EXPECT_STREQ(robot.trace.why(0), "it began too recently");
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
