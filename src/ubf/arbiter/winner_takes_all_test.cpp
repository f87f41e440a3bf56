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

}  // namespace
}  // namespace eyrie::ubf::testing
