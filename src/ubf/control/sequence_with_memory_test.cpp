// SPDX-License-Identifier: MIT
#include "ubf/control/sequence.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Steps = SequenceWithMemory<State, Action>;

TEST(SequenceWithMemory, DoesNotAskAgainWhatHasSucceeded) {
  Robot robot(make<Steps>(probes(2)));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_FALSE(robot.asked_now("root/probe[0]"));
}

TEST(SequenceWithMemory, SendsUpOnlyWhatWasProposedInThisTick) {
  Robot robot(make<Steps>(probes(2)));
  robot.cue(0) = {kSuccess, 4, {.heading = 1}};
  robot.say(1, kRunning);
  robot.tick();
  EXPECT_EQ(robot.out.action.heading, 1);
  robot.tick();
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(SequenceWithMemory, StartsFromTheFirstChildAfterAFailure) {
  Robot robot(make<Steps>(probes(2)));
  robot.say(0, kSuccess);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_TRUE(robot.asked_now("root/probe[0]"));
}

TEST(SequenceWithMemory, ClosesAnArbiterThatSucceededBeforeItGoesOn) {
  Robot robot(make<Steps>(make<Wta>(probe(0), probe(1)), probe(2)));
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  robot.say(2, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
  EXPECT_EQ(robot.asked("root/winner_takes_all/probe[1]"), 0u);
  robot.tick();
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 0);
}

}  // namespace
}  // namespace eyrie::ubf::testing
