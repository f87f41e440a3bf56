// SPDX-License-Identifier: MIT
#include "ubf/decorator/timing.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

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

}  // namespace
}  // namespace eyrie::ubf::testing
