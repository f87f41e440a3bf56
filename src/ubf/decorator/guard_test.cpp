// SPDX-License-Identifier: MIT
#include "ubf/decorator/outcome.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Guarded = Guard<State, Action>;

TEST(Guard, AsksItsChildOnlyWhileTheConditionHolds) {
  Robot robot(make<Guarded>(check(0), probe(1)));
  robot.cue(1) = {kSuccess, 3, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_FALSE(robot.asked_now("root/probe"));
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.supplier(0), "root/probe");
}

TEST(Guard, MakesARunningChildForgetOnceWhenTheConditionEnds) {
  Robot robot(make<Guarded>(check(0), probe(1)));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.halts("root/probe"), 1);
  EXPECT_EQ(robot.asked("root/probe"), 0u);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe"), 0);
}

TEST(Guard, LeavesTheMemoryOfAChildThatEndedByItselfAlone) {
  Robot robot(make<Guarded>(check(0), probe(1)));
  robot.say(0, kSuccess);
  robot.say(1, kSuccess);
  robot.tick();
  robot.say(0, kFailure);
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe"), 1u);
}

TEST(Guard, IgnoresWhatTheConditionProposes) {
  Robot robot(make<Guarded>(probe(0), probe(1)));
  robot.cue(0) = {kSuccess, 9, {.altitude = 5}};
  robot.cue(1) = {kRunning, 3, {.heading = 1}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.out.vote, 3);
}

TEST(Guard, TreatsARunningConditionAsOneThatDoesNotHold) {
  Robot robot(make<Guarded>(probe(0), probe(1)));
  robot.say(0, kRunning);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.halts("root/probe[0]"), 1);
  EXPECT_FALSE(robot.asked_now("root/probe[1]"));
}

TEST(Guard, NeedsAConditionAndAChild) {
  EXPECT_EQ(make<Guarded>(probe(0))->problems(),
            std::vector<std::string>{"takes exactly 'when', 'child', but has 1 child"});
  EXPECT_EQ(make<Guarded>(probe(0), probe(1))->problems(), std::vector<std::string>{});
}

}  // namespace
}  // namespace eyrie::ubf::testing
