// SPDX-License-Identifier: MIT
#include "ubf/decorator/outcome.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

Child run_once(Afterwards then, Child child) {
  auto node = make<RunOnce<State, Action>>(std::move(child));
  node->then = then;
  return node;
}

TEST(RunOnce, DoesNotAskAChildAgainThatHasEnded) {
  for (const Status end : {kFailure, kSuccess}) {
    Robot robot(run_once(Afterwards::same, probe(0)));
    robot.cue(0) = {kRunning, 2, {.heading = 1}};
    EXPECT_EQ(robot.tick(), kRunning);
    EXPECT_EQ(robot.out.action.heading, 1);
    robot.say(0, end, 2);
    EXPECT_EQ(robot.tick(), end);
    robot.say(0, kRunning, 2);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(robot.tick(), end);
      EXPECT_TRUE(robot.out.is_empty());
      EXPECT_FALSE(robot.asked_now("root/probe"));
    }
  }
}

TEST(RunOnce, AnswersAfterwardsWhatItIsToldTo) {
  struct Row {
    Afterwards then;
    Status end, afterwards;
  };
  for (const Row& row :
       {Row{Afterwards::same, kFailure, kFailure}, Row{Afterwards::same, kSuccess, kSuccess},
        Row{Afterwards::failure, kFailure, kFailure}, Row{Afterwards::failure, kSuccess, kFailure},
        Row{Afterwards::success, kFailure, kSuccess},
        Row{Afterwards::success, kSuccess, kSuccess}}) {
    Robot robot(run_once(row.then, probe(0)));
    robot.say(0, row.end);
    EXPECT_EQ(robot.tick(), row.end);
    EXPECT_EQ(robot.tick(), row.afterwards);
  }
}

TEST(RunOnce, KeepsItsMemoryWhenASelectorPassesItBy) {
  Robot robot(make<Selector<State, Action>>(probe(1), run_once(Afterwards::same, probe(0))));
  robot.say(0, kSuccess);
  robot.tick();
  robot.say(1, kRunning);
  robot.tick();
  robot.say(1, kFailure);
  robot.tick();
  EXPECT_FALSE(robot.asked_now("root/run_once/probe"));
}

TEST(RunOnce, BeginsAnewWhenItLosesControlWhileItsChildRuns) {
  Robot robot(make<Selector<State, Action>>(probe(1), run_once(Afterwards::same, probe(0))));
  robot.say(0, kRunning);
  robot.tick();
  robot.say(1, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/run_once/probe"), 1);
  robot.say(1, kFailure);
  robot.tick();
  EXPECT_TRUE(robot.asked_now("root/run_once/probe"));
}

}  // namespace
}  // namespace eyrie::ubf::testing
