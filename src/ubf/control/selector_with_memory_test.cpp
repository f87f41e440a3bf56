// SPDX-License-Identifier: MIT
#include "ubf/control/sequence.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Resume = SelectorWithMemory<State, Action>;

TEST(SelectorWithMemory, DoesNotLetAnEarlierChildInterruptARunningOne) {
  Robot robot(make<Resume>(probes(2)));
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_FALSE(robot.asked_now("root/probe[0]"));
  EXPECT_EQ(robot.asked("root/probe[1]"), 2u);
}

TEST(SelectorWithMemory, GoesOnToTheNextChildInTheTickInWhichTheRunningOneFails) {
  Robot robot(make<Resume>(probes(3)));
  robot.say(1, kRunning);
  robot.tick();
  robot.say(1, kFailure);
  robot.cue(2) = {kRunning, 3, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.heading, 2);
}

TEST(SelectorWithMemory, StartsFromTheFirstChildAfterItEnded) {
  Robot robot(make<Resume>(probes(2)));
  robot.say(1, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_TRUE(robot.asked_now("root/probe[0]"));
  EXPECT_FALSE(robot.asked_now("root/probe[1]"));
}

TEST(SelectorWithMemory, StartsFromTheFirstChildAfterItWasHalted) {
  Robot robot(make<Selector<State, Action>>(probe(0), make<Resume>(probe(1), probe(2))));
  robot.say(2, kRunning);
  robot.tick();
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/selector_with_memory/probe[1]"), 1);
  robot.say(0, kFailure);
  robot.tick();
  EXPECT_TRUE(robot.asked_now("root/selector_with_memory/probe[0]"));
}

TEST(SelectorWithMemory, ClosesAnArbiterThatFailedBeforeItGoesOn) {
  Robot robot(make<Resume>(make<Wta>(probe(0)), probe(1)));
  robot.say(0, kRunning, 0);  // abstains, so the arbiter fails, but the probe is going on
  robot.say(1, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe"), 1);
  EXPECT_EQ(robot.asked("root/winner_takes_all/probe"), 0u);
}

}  // namespace
}  // namespace eyrie::ubf::testing
