// SPDX-License-Identifier: MIT
#include "ubf/leaf.hpp"

#include <gtest/gtest.h>

#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

TEST(AlwaysSuccess, AndAlwaysFailureAreWhatTheySay) {
  Robot robot(build("{sequence: [{probe: {cue: 0}}, always_success]}"));
  robot.cue(0) = {kSuccess, 3, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1})) << "it proposes nothing";
  EXPECT_EQ(Robot(build("always_failure")).tick(), kFailure);
}

TEST(Wait, RunsForItsTimeAndThenSucceedsOnce) {
  Robot robot(build("{sequence_with_memory: [{wait: {duration: 2 s}}, {probe: {cue: 0}}]}"));
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick_at(10), kRunning);
  EXPECT_TRUE(robot.out.is_empty());
  EXPECT_EQ(robot.tick_at(11.9), kRunning);
  EXPECT_EQ(robot.tick_at(12), kSuccess);
  EXPECT_EQ(robot.tick_at(12.1), kRunning) << "it waits again";
  EXPECT_EQ(robot.tick_at(14.1), kSuccess);
}

TEST(Wait, BeginsAnewAfterItLostControl) {
  Robot robot(build("{selector: [{probe: {cue: 0}}, {wait: {duration: 2 s}}]}"));
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick_at(0), kRunning);
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick_at(1), kSuccess);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick_at(2), kRunning);
  EXPECT_EQ(robot.tick_at(3.9), kRunning);
  EXPECT_EQ(robot.tick_at(4), kSuccess);
}

}  // namespace
}  // namespace eyrie::ubf::testing
