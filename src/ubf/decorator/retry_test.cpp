// SPDX-License-Identifier: MIT
#include "ubf/decorator/outcome.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

Child retry(std::optional<std::uint32_t> attempts, Child child) {
  auto node = make<Retry<State, Action>>(std::move(child));
  node->attempts = attempts;
  return node;
}

TEST(Retry, FailsWhenItsChildHasFailedOftenEnough) {
  Robot robot(retry(2, probe(0)));
  robot.cue(0) = {kFailure, 2, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(robot.out.is_empty()) << "a failing child proposes nothing";
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.tick(), kRunning) << "it counts anew";
}

TEST(Retry, SucceedsWithItsChildAndForgetsTheCount) {
  Robot robot(retry(2, probe(0)));
  robot.tick();
  robot.cue(0) = {kSuccess, 2, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.action.heading, 1);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
}

TEST(Retry, CountsNoTickInWhichTheChildRuns) {
  Robot robot(retry(2, probe(0)));
  for (const Status answer : {kRunning, kFailure, kRunning, kRunning}) {
    robot.say(0, answer);
    EXPECT_EQ(robot.tick(), kRunning);
  }
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
}

TEST(Retry, WithoutANumberTriesForEver) {
  Robot robot(retry(std::nullopt, probe(0)));
  for (int i = 0; i < 1000; ++i)
    ASSERT_EQ(robot.tick(), kRunning);
}

}  // namespace
}  // namespace eyrie::ubf::testing
