// SPDX-License-Identifier: MIT
#include "ubf/decorator/outcome.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

Child repeat(std::optional<std::uint32_t> count, Child child) {
  auto node = make<Repeat<State, Action>>(std::move(child));
  node->count = count;
  return node;
}

TEST(Repeat, SucceedsWhenItsChildHasSucceededOftenEnough) {
  Robot robot(repeat(3, probe(0)));
  robot.cue(0) = {kSuccess, 2, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.tick(), kRunning) << "it counts anew";
}

TEST(Repeat, CountsNoTickInWhichTheChildRuns) {
  Robot robot(repeat(2, probe(0)));
  for (const Status answer : {kRunning, kSuccess, kRunning, kRunning}) {
    robot.say(0, answer);
    EXPECT_EQ(robot.tick(), kRunning);
  }
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
}

TEST(Repeat, FailsWithItsChildAndForgetsTheCount) {
  Robot robot(repeat(2, probe(0)));
  robot.say(0, kSuccess);
  robot.tick();
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.tick(), kSuccess);
}

TEST(Repeat, WithoutACountGoesOnForEver) {
  Robot robot(repeat(std::nullopt, probe(0)));
  robot.say(0, kSuccess);
  for (int i = 0; i < 1000; ++i)
    ASSERT_EQ(robot.tick(), kRunning);
}

TEST(Repeat, LetsAnArbiterThatEndedForgetBeforeTheNextRound) {
  Robot robot(repeat(2, make<Wta>(probe(0), probe(1))));
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  robot.tick();
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
}

TEST(Repeat, ForgetsTheCountWhenItLosesControl) {
  Robot robot(make<Selector<State, Action>>(probe(1), repeat(2, probe(0))));
  robot.say(0, kSuccess);
  robot.tick();
  robot.say(1, kRunning);
  robot.tick();
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.tick(), kSuccess);
}

}  // namespace
}  // namespace eyrie::ubf::testing
