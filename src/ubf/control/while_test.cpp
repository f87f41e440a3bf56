// SPDX-License-Identifier: MIT
#include "ubf/control/branch.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Loop = While<State, Action>;

TEST(While, ChecksItsConditionInEveryTick) {
  Robot robot(make<Loop>(probes(3)));
  robot.cue(0) = {kSuccess, 9, {.altitude = 5}};
  robot.cue(1) = {kRunning, 2, {.heading = 1}};
  robot.cue(2) = {kRunning, 3, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 2}));
  EXPECT_EQ(robot.supplier(0), "root/probe[2]");
}

TEST(While, MakesTheBranchItTurnsAwayFromForgetOnce) {
  Robot robot(make<Loop>(probes(3)));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kFailure);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[1]"), 1);
  EXPECT_EQ(robot.asked("root/probe[1]"), 0u);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[1]"), 0);
}

TEST(While, LeavesTheMemoryOfABranchThatEndedByItselfAlone) {
  Robot robot(make<Loop>(probes(3)));
  robot.say(0, kSuccess);
  robot.say(1, kSuccess);
  robot.tick();
  robot.say(0, kFailure);
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe[1]"), 1u);
}

TEST(While, AlsoHaltsAnArbiterThatStandsAlthoughItEnded) {
  Robot robot(make<Loop>(check(2), make<Wta>(probe(0), probe(1)), probe(3)));
  robot.say(2, kSuccess);
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 0);
  robot.say(2, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
}

TEST(While, TreatsARunningConditionAsOneThatDoesNotHold) {
  Robot robot(make<Loop>(probes(3)));
  robot.say(0, kRunning);
  robot.say(2, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.halts("root/probe[0]"), 1);
}

TEST(While, HasThreeChildren) {
  EXPECT_EQ(make<Loop>(probes(2))->problems(),
            std::vector<std::string>{"takes exactly 'when', 'do', 'else', but has 2 children"});
  EXPECT_EQ(make<Loop>(probes(3))->problems(), std::vector<std::string>{});
}

}  // namespace
}  // namespace eyrie::ubf::testing
