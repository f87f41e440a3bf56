// SPDX-License-Identifier: MIT
#include "ubf/control/sequence.hpp"

#include <gtest/gtest.h>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Select = Selector<State, Action>;

TEST(Selector, SendsUpTheActionOfTheFirstChildThatDoesNotFailEvenWithoutAVote) {
  Robot robot(make<Select>(probes(3)));
  robot.cue(0) = {kFailure, 9, {.heading = 0}};
  robot.cue(1) = {kRunning, 0, {.heading = 1}};
  robot.cue(2) = {kRunning, 5, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.out.vote, 0);
  EXPECT_FALSE(robot.asked_now("root/probe[2]"));
  EXPECT_EQ(robot.supplier(0), "root/probe[1]");
}

TEST(Selector, NeverMixesInWhatAFailingChildLeftBehind) {
  Robot robot(make<Select>(probes(2)));
  robot.cue(0) = {kFailure, 9, {.heading = 0, .altitude = 5}};
  robot.cue(1) = {kSuccess, 1, {.speed = 2}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.speed = 2}));
}

TEST(Selector, LetsAnEarlierChildTakeOverAndTheRunningOneForgetOnce) {
  Robot robot(make<Select>(probes(2)));
  robot.say(0, kFailure);
  robot.say(1, kRunning);
  robot.tick();
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe[1]"), 2u);
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[1]"), 1);
  EXPECT_EQ(robot.asked("root/probe[1]"), 0u);
  robot.tick();
  EXPECT_EQ(robot.halts("root/probe[1]"), 0);
}

TEST(Selector, LeavesTheMemoryOfAChildThatEndedByItselfAlone) {
  Robot robot(make<Select>(probes(2)));
  robot.say(0, kFailure);
  robot.say(1, kSuccess);
  robot.tick();
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.asked("root/probe[1]"), 1u);
}

TEST(Selector, HaltsAnArbiterItTurnsAwayFromEvenIfThatSucceeded) {
  Robot robot(make<Select>(probe(0), make<Wta>(probe(1), probe(2))));
  robot.say(0, kFailure);
  robot.say(1, kSuccess, 5);
  robot.say(2, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  robot.tick();
  const std::string loser = "root/winner_takes_all/probe[1]";
  EXPECT_EQ(robot.asked(loser), 2u) << "asked in every tick, so it goes on";
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts(loser), 1);
  EXPECT_EQ(robot.asked(loser), 0u);
  robot.tick();
  EXPECT_EQ(robot.halts(loser), 0);
}

TEST(Selector, ForgettingReachesEveryLevelAtOnce) {
  Robot robot(make<Select>(probe(0), make<Select>(make<Select>(probe(1)))));
  robot.say(0, kFailure);
  robot.say(1, kRunning);
  robot.tick();
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/selector/selector/probe"), 1);
  EXPECT_EQ(robot.asked("root/selector/selector/probe"), 0u);
}

TEST(Selector, GivesThePlainTreeUnderAnArbiterItsVote) {
  auto plain = make<Select>(probe(0), probe(1));
  plain->vote = 7;
  Robot robot(make<Wta>(std::move(plain), probe(2)));
  robot.cue(1) = {kRunning, 0, {.heading = 1}};
  robot.cue(2) = {kRunning, 6, {.heading = 2}};
  robot.tick();
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_EQ(robot.out.vote, 7);
}

TEST(Selector, TellsWhichChildIsRunning) {
  Robot robot(make<Select>(probes(2)));
  EXPECT_EQ(robot.tree.root().active_child(robot.slab.data()), kNone);
  robot.say(1, kRunning);
  robot.tick();
  EXPECT_EQ(robot.tree.root().active_child(robot.slab.data()), 1);
}

using Seq = Sequence<State, Action>;

TEST(Sequence, OfConditionsAndAnActionSendsUpTheAction) {
  Robot robot(make<Seq>(check(0), check(1), probe(2)));
  robot.say(0, kSuccess);
  robot.say(1, kSuccess);
  robot.cue(2) = {kRunning, 4, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 2}));
  EXPECT_EQ(robot.out.vote, 4);
  EXPECT_EQ(robot.supplier(0), "root/probe");
}

TEST(Sequence, KeepsTheActionIfAConditionFollowsIt) {
  Robot robot(make<Seq>(probe(0), check(1)));
  robot.cue(0) = {kSuccess, 4, {.heading = 2}};
  robot.say(1, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 2}));
  EXPECT_EQ(robot.out.vote, 4);
  EXPECT_EQ(robot.supplier(0), "root/probe");
}

TEST(Sequence, SendsUpTheLastProposalWholeAndNotMixed) {
  Robot robot(make<Seq>(probes(2)));
  robot.cue(0) = {kSuccess, 9, {.heading = 0, .altitude = 5}};
  robot.cue(1) = {kRunning, 1, {.heading = 1}};
  robot.tick();
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1}));
  EXPECT_EQ(robot.out.vote, 1);
  EXPECT_EQ(robot.supplier(1), "");
}

TEST(Sequence, ProposesNothingWhenItFails) {
  Robot robot(make<Seq>(probes(2)));
  robot.cue(0) = {kSuccess, 9, {.heading = 0}};
  robot.cue(1) = {kFailure, 9, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
  EXPECT_TRUE(robot.row("root").proposal.is_empty());
}

TEST(Sequence, OfConditionsAloneProposesNothingEvenWithAFixedVote) {
  auto node = make<Seq>(check(0));
  node->vote = 5;
  Robot robot(std::move(node));
  robot.say(0, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(Sequence, InterruptsALaterChildWhenAnEarlierConditionCeasesToHold) {
  Robot robot(make<Seq>(check(0), probe(1)));
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

TEST(Sequence, HaltsEveryArbiterBehindTheChildThatStoppedIt) {
  Robot robot(make<Seq>(probe(0), make<Wta>(probe(1), probe(2)), probe(3)));
  robot.say(0, kSuccess);
  robot.say(1, kSuccess, 2);
  robot.say(2, kRunning, 1);
  robot.say(3, kSuccess);
  EXPECT_EQ(robot.tick(), kSuccess);
  robot.say(0, kRunning);
  robot.tick();
  EXPECT_EQ(robot.halts("root/winner_takes_all/probe[1]"), 1);
  EXPECT_EQ(robot.asked("root/winner_takes_all/probe[1]"), 0u);
  EXPECT_EQ(robot.asked("root/probe[1]"), 1u) << "it had ended by itself";
}

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
