// SPDX-License-Identifier: MIT
#include "ubf/decorator/outcome.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

TEST(ForceSuccess, TurnsFailureIntoASuccessThatProposesNothing) {
  Robot robot(make<ForceSuccess<State, Action>>(probe(0)));
  robot.cue(0) = {kFailure, 3, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(ForceSuccess, PassesEverythingElse) {
  Robot robot(make<ForceSuccess<State, Action>>(probe(0)));
  for (const Status says : {kRunning, kSuccess}) {
    robot.cue(0) = {says, 3, {.heading = 1}};
    EXPECT_EQ(robot.tick(), says);
    EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
    EXPECT_EQ(robot.out.vote, 3);
  }
}

}  // namespace
}  // namespace eyrie::ubf::testing
