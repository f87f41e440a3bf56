// SPDX-License-Identifier: MIT
#include "ubf/arbiter/winner_takes_all.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

TEST(WinnerTakesAll, HandsOnActionVoteAndStatusOfTheHighestVote) {
  Robot robot(make<Wta>(probes(3)));
  robot.cue(0) = {kSuccess, 2, {.heading = 1}};
  robot.cue(1) = {kRunning, 5, {.altitude = 3000, .release = 7}};
  robot.cue(2) = {kSuccess, 3, {.speed = 200}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 5);
  EXPECT_TRUE(equal(robot.out.action, {.altitude = 3000, .release = 7}));
}

TEST(WinnerTakesAll, BreaksTiesInFavorOfTheEarlierChild) {
  Robot robot(make<Wta>(probes(3)));
  robot.cue(0) = {kRunning, 1, {.heading = 0}};
  robot.cue(1) = {kRunning, 4, {.heading = 1}};
  robot.cue(2) = {kSuccess, 4, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
}

TEST(WinnerTakesAll, IgnoresAFailingChildHoweverHighItsVote) {
  Robot robot(make<Wta>(probes(2)));
  robot.cue(0) = {kFailure, 100, {.heading = 0}};
  robot.cue(1) = {kRunning, 1, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.heading, 1);
}

TEST(WinnerTakesAll, FailsWithAnEmptyProposalIfEveryoneFailsOrAbstains) {
  Robot robot(make<Wta>(probes(2)));
  robot.cue(0) = {kFailure, 3, {.heading = 0}};
  robot.cue(1) = {kSuccess, 0, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(WinnerTakesAll, AsksEveryChildEveryTimeSoThatLosersKeepTheirMemory) {
  Robot robot(make<Wta>(probes(2)));
  robot.say(0, kSuccess, 2);
  robot.say(1, kRunning, 1);
  for (int i = 0; i < 3; ++i)
    robot.tick();
  EXPECT_EQ(robot.asked("root/probe[1]"), 3u);
  EXPECT_EQ(robot.halts("root/probe[1]"), 0);
}

TEST(WinnerTakesAll, RescalesWhatItSendsUp) {
  auto inner = make<Wta>(probes(1));
  inner->vote_scale = 0.5;
  Robot scaled(std::move(inner));
  scaled.cue(0) = {kRunning, 8, {.heading = 1}};
  scaled.tick();
  EXPECT_EQ(scaled.out.vote, 4);

  auto fixed = make<Wta>(probes(1));
  fixed->vote = 30;
  Robot always(std::move(fixed));
  always.cue(0) = {kRunning, 8, {.heading = 1}};
  always.tick();
  EXPECT_EQ(always.out.vote, 30);
  always.cue(0).vote = 0;
  EXPECT_EQ(always.tick(), kFailure);
  EXPECT_EQ(always.out.vote, 0) << "a fixed vote must not turn an abstention into a proposal";
}

TEST(WinnerTakesAll, TracesTheWinnerAsTheSupplierThroughTwoLevels) {
  Robot robot(make<Wta>(make<Wta>(probe(0), probe(1)), make<Wta>(probe(2), probe(3))));
  robot.cue(0) = {kRunning, 1, {.heading = 1}};
  robot.cue(2) = {kRunning, 2, {.heading = 2}};
  robot.cue(3) = {kRunning, 3, {.heading = 3, .speed = 5}};
  robot.tick();
  EXPECT_EQ(robot.supplier(0), "root/winner_takes_all[1]/probe[1]");
  EXPECT_EQ(robot.supplier(1), "");
  EXPECT_EQ(robot.supplier(2), "root/winner_takes_all[1]/probe[1]");
}

RC_GTEST_PROP(WinnerTakesAllLaw, VoteAndStatusAreTheStrongestsAndSilenceChangesNothing, ()) {
  obeys_common_laws<Wta>(*any_cues());
}

RC_GTEST_PROP(WinnerTakesAllLaw, TheActionIsExactlyThatOfAMaximalVote, ()) {
  const Cues cues = *any_cues_with_a_heading();
  RC_ASSERT(equal(ask<Wta>(cues).proposal.action, cues[strongest(cues)].action));
}

RC_GTEST_PROP(WinnerTakesAllLaw, OrderDoesNotMatterWithoutTies, ()) {
  const Cues cues = without_ties(*any_cues());
  RC_ASSERT(ask<Wta>(shuffled(cues)) == ask<Wta>(cues));
}

RC_GTEST_PROP(WinnerTakesAllLaw, GroupingDoesNotMatter, ()) {
  const Cues cues = *any_cues();
  RC_PRE(cues.size() > 1);
  const std::size_t cut = *rc::gen::inRange<std::size_t>(1, cues.size());
  Children first = probes(cues.size()), second;
  std::move(first.begin() + static_cast<std::ptrdiff_t>(cut), first.end(),
            std::back_inserter(second));
  first.resize(cut);
  Robot grouped(make<Wta>(make<Wta>(std::move(first)), make<Wta>(std::move(second))));
  RC_ASSERT(ask(grouped, cues) == ask<Wta>(cues));
}

using Commit = Commitment<State, Action>;

struct Settings {
  float margin = 0;
  double min_time = 0, hold = 0;
};

Child commitment(std::size_t children, const Settings& settings) {
  auto node = make<Commit>(probes(children));
  node->margin = settings.margin;
  node->min_time = settings.min_time;
  node->hold = settings.hold;
  return node;
}

/// Child i proposes altitude i, so that the result tells who was chosen.
Robot robot_with(std::size_t children, const Settings& settings) {
  Robot robot(commitment(children, settings));
  for (std::size_t i = 0; i < children; ++i)
    robot.cue(i).action.altitude = static_cast<double>(i);
  return robot;
}

TEST(Commitment, KeepsItsChoiceUntilARivalIsBetterByMoreThanTheMargin) {
  Robot robot = robot_with(2, {.margin = 3});
  robot.say(0, kRunning, 10);
  robot.say(1, kRunning, 9);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 0);
  robot.say(1, kRunning, 13);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 0);
  EXPECT_EQ(robot.out.vote, 10);
  robot.say(1, kRunning, 13.5);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 1);
  robot.say(0, kRunning, 16);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 1) << "the margin now protects the new choice";
}

TEST(Commitment, KeepsItsChoiceForTheMinimumTime) {
  Robot robot = robot_with(2, {.min_time = 2});
  robot.say(0, kRunning, 1);
  robot.tick_at(10);
  robot.say(1, kRunning, 100);
  robot.tick_at(11.9);
  EXPECT_EQ(robot.out.action.altitude, 0);
  robot.tick_at(12);
  EXPECT_EQ(robot.out.action.altitude, 1);
}

TEST(Commitment, LetsGoAtOnceOfAChildThatFallsSilentIfNothingHoldsIt) {
  Robot robot = robot_with(2, {.margin = 100, .min_time = 100});
  robot.say(0, kRunning, 5);
  robot.say(1, kRunning, 1);
  robot.tick();
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.altitude, 1);
}

TEST(Commitment, KeepsUpTheLastProposalOfASilentChildForTheHoldTime) {
  Robot robot = robot_with(2, {.hold = 1});
  robot.cue(0).action.release = 4;
  robot.say(0, kRunning, 5);
  robot.say(1, kRunning, 4);
  robot.tick_at(10);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick_at(10.9), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.altitude = 0, .release = 4}));
  EXPECT_EQ(robot.out.vote, 5);
  EXPECT_EQ(robot.supplier(1), "root/probe[0]");
  robot.tick_at(11);
  EXPECT_EQ(robot.out.action.altitude, 1);
}

TEST(Commitment, LetsAStrongerRivalEndTheHold) {
  Robot robot = robot_with(2, {.hold = 1});
  robot.say(0, kRunning, 5);
  robot.tick();
  robot.say(0, kFailure);
  robot.say(1, kRunning, 6);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 1);
}

TEST(Commitment, AroundOneChildBridgesItsSilence) {
  Robot robot = robot_with(1, {.hold = 1});
  robot.say(0, kRunning, 5);
  robot.tick_at(1);
  robot.say(0, kRunning, 0);
  EXPECT_EQ(robot.tick_at(1.5), kRunning);
  EXPECT_EQ(robot.out.vote, 5);
  EXPECT_EQ(robot.tick_at(2), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(Commitment, IsOverWhenTheChosenChildSucceeds) {
  Robot robot = robot_with(2, {.margin = 100});
  robot.say(0, kSuccess, 5);
  robot.say(1, kRunning, 1);
  EXPECT_EQ(robot.tick(), kSuccess);
  robot.say(1, kRunning, 6);
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 1);
}

TEST(Commitment, ForgetsEverythingWhenNobodyIsLeft) {
  Robot robot = robot_with(2, {.hold = 1});
  robot.say(0, kRunning, 5);
  robot.tick_at(1);
  robot.say(0, kFailure);
  EXPECT_EQ(robot.tick_at(9), kFailure);
  const std::size_t own = sizeof(CommitmentMemory);
  EXPECT_TRUE(std::all_of(robot.slab.begin(), robot.slab.begin() + own,
                          [](std::byte byte) { return byte == std::byte{0}; }));
}

TEST(Commitment, NeedsRoomForAProposalOnlyIfItHoldsOne) {
  EXPECT_LT(commitment(1, {.margin = 1})->memory_bytes(),
            commitment(1, {.hold = 1})->memory_bytes());
}

TEST(Commitment, WithoutAnySettingCommitsToNothingAndIsRefused) {
  EXPECT_EQ(commitment(1, {})->problem(),
            "commitment needs 'margin', 'min_time' or 'hold' above 0, or it commits to nothing");
  EXPECT_EQ(commitment(1, {.hold = 1})->problem(), "");
}

/// How often the altitude, that is the chosen child, changes.
int changes(Robot& robot, const std::vector<Cues>& ticks) {
  std::optional<double> last;
  int count = 0;
  for (const Cues& cues : ticks) {
    const auto now = ask(robot, cues).proposal.action.altitude;
    count += last && now && *last != *now;
    if (now)
      last = now;
  }
  return count;
}

/// Three children that always propose, with votes that jump about.
std::vector<Cues> restless_votes() {
  std::vector<Cues> ticks(30, Cues(3));
  for (Cues& cues : ticks)
    for (std::size_t i = 0; i < cues.size(); ++i)
      cues[i] = {kRunning,
                 static_cast<float>(*rc::gen::resize(100, rc::gen::inRange(1, 10))),
                 {.altitude = static_cast<double>(i)}};
  return ticks;
}

RC_GTEST_PROP(CommitmentLaw, NeverChangesItsMindMoreOftenThanWinnerTakesAll, ()) {
  const auto ticks = restless_votes();
  Robot restless(make<WinnerTakesAll<State, Action>>(probes(3)));
  Robot committed(commitment(3, {.margin = static_cast<float>(*rc::gen::inRange(1, 8))}));
  RC_ASSERT(changes(committed, ticks) <= changes(restless, ticks));
}

RC_GTEST_PROP(CommitmentLaw, EachChoiceStandsForTheMinimumTime, ()) {
  const auto ticks = restless_votes();
  Robot robot(commitment(3, {.min_time = 0.5}));
  RC_ASSERT(changes(robot, ticks) <= 30 / 5);
}

RC_GTEST_PROP(CommitmentLaw, WhatGoesUpIsWhatTheChosenChildSays, ()) {
  Robot robot(commitment(3, {.margin = 2}));
  for (const Cues& cues : restless_votes()) {
    const Answer answer = ask(robot, cues);
    const auto chosen = static_cast<std::size_t>(*answer.proposal.action.altitude);
    RC_ASSERT(answer.proposal.vote == cues[chosen].vote);
    RC_ASSERT(cues[strongest(cues)].vote - answer.proposal.vote <= 2);
  }
}

}  // namespace
}  // namespace eyrie::ubf::testing
