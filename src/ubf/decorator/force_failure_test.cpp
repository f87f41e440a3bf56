// SPDX-License-Identifier: MIT
#include "ubf/decorator/outcome.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

TEST(ForceFailure, TurnsSuccessIntoFailure) {
  Robot robot(make<ForceFailure<State, Action>>(probe(0)));
  for (const Status says : {kSuccess, kFailure}) {
    robot.cue(0) = {says, 3, {.heading = 1}};
    EXPECT_EQ(robot.tick(), kFailure);
    EXPECT_TRUE(robot.out.is_empty());
  }
}

TEST(ForceFailure, LeavesRunningAndItsProposal) {
  Robot robot(make<ForceFailure<State, Action>>(probe(0)));
  robot.cue(0) = {kRunning, 3, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
}

}  // namespace
}  // namespace eyrie::ubf::testing
