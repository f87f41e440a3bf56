// SPDX-License-Identifier: MIT
#include "ubf/decorator/outcome.hpp"

#include <gtest/gtest.h>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Invert = Inverter<State, Action>;

TEST(Inverter, TurnsSuccessIntoFailureAndBackAndLeavesRunning) {
  Robot robot(make<Invert>(probe(0)));
  for (const auto& [says, answer] :
       {std::pair{kFailure, kSuccess}, {kRunning, kRunning}, {kSuccess, kFailure}}) {
    robot.cue(0) = {says, 3, {.heading = 1}};
    EXPECT_EQ(robot.tick(), answer);
    EXPECT_EQ(robot.out.is_empty(), says != kRunning) << to_text(says);
  }
}

TEST(Inverter, OfARunningChildHandsOnItsProposal) {
  Robot robot(make<Invert>(probe(0)));
  robot.cue(0) = {kRunning, 3, {.heading = 1}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.out.vote, 3);
  EXPECT_EQ(robot.supplier(0), "root/probe");
}

TEST(Inverter, MakesAnArbiterBelowItStandAsLongAsItIsAsked) {
  Robot robot(make<Selector<State, Action>>(probe(0), make<Invert>(make<Wta>(probe(1), probe(2)))));
  robot.say(1, kSuccess, 5);
  robot.say(2, kRunning, 1);
  robot.tick();
  robot.tick();
  EXPECT_EQ(robot.asked("root/inverter/winner_takes_all/probe[1]"), 2u);
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.asked("root/inverter/winner_takes_all/probe[1]"), 0u);
}

TEST(Inverter, NeedsExactlyOneChild) {
  EXPECT_EQ(make<Invert>()->problems(),
            std::vector<std::string>{"takes exactly 'child', but has 0 children"});
  EXPECT_EQ(make<Invert>(probe(0), probe(1))->problems(),
            std::vector<std::string>{"takes exactly 'child', but has 2 children"});
  EXPECT_EQ(make<Invert>(probe(0))->problems(), std::vector<std::string>{});
}

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

TEST(ForceSuccess, OfARunningChildGoesOnNextTickAndIsHaltedByWhoStopsAsking) {
  auto node = make<ForceSuccess<State, Action>>(probe(0));
  node->running = true;
  Robot robot(make<Sequence<State, Action>>(probe(1), std::move(node)));
  robot.say(1, kSuccess);
  robot.cue(0) = {kRunning, 3, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.asked("root/force_success/probe"), 2u);
  robot.say(1, kFailure);
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_EQ(robot.asked("root/force_success/probe"), 0u);
}

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
