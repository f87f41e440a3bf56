// SPDX-License-Identifier: MIT
#include "ubf/control/sequence.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

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

}  // namespace
}  // namespace eyrie::ubf::testing
