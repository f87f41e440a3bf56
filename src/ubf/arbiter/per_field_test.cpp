// SPDX-License-Identifier: MIT
#include "ubf/arbiter/fusion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

using Per = PerField<State, Action>;

TEST(PerField, TakesEachFieldFromTheHighestVoteThatSetIt) {
  Robot robot(make<Per>(probes(3)));
  robot.cue(0) = {kRunning, 2, {.heading = 1, .altitude = 1000}};
  robot.cue(1) = {kSuccess, 5, {.heading = 2}};
  robot.cue(2) = {kRunning, 3, {.altitude = 3000, .release = 1}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.vote, 5);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 2, .altitude = 3000, .release = 1}));
}

TEST(PerField, BreaksTiesInFavorOfTheEarlierChild) {
  Robot robot(make<Per>(probes(2)));
  robot.cue(0) = {kRunning, 2, {.heading = 1}};
  robot.cue(1) = {kSuccess, 2, {.heading = 2, .speed = 3}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1, .speed = 3}));
}

TEST(PerField, FailsWithAnEmptyProposalIfEveryoneFailsOrAbstains) {
  Robot robot(make<Per>(probes(2)));
  robot.cue(0) = {kFailure, 3, {.heading = 0}};
  robot.cue(1) = {kSuccess, 0, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(PerField, TracesWhoSuppliedEachFieldThroughNestedArbiters) {
  Robot robot(make<Per>(make<Wta>(probe(0), probe(1)), make<Per>(probe(2), probe(3))));
  robot.cue(0) = {kRunning, 4, {.heading = 1}};
  robot.cue(1) = {kRunning, 5, {.heading = 2}};
  robot.cue(2) = {kRunning, 1, {.heading = 3, .altitude = 30}};
  robot.cue(3) = {kRunning, 2, {.speed = 4}};
  robot.tick();
  EXPECT_EQ(robot.supplier(0), "root/winner_takes_all/probe[1]");
  EXPECT_EQ(robot.supplier(1), "root/per_field/probe[0]");
  EXPECT_EQ(robot.supplier(2), "root/per_field/probe[1]");
  EXPECT_EQ(robot.supplier(3), "");
}

RC_GTEST_PROP(PerFieldLaw, VoteAndStatusAreTheStrongestsAndSilenceChangesNothing, ()) {
  obeys_common_laws<Per>(*any_cues());
}

RC_GTEST_PROP(PerFieldLaw, EveryFieldIsThatOfTheStrongestWhoSetIt, ()) {
  const Cues cues = *any_cues();
  const Answer answer = ask<Per>(cues);
  for_each_field<Action>([&](const auto& f, auto) {
    Cues setters;
    for (const Cue& cue : cues)
      if (is_heard(cue) && cue.action.*f.member)
        setters.push_back(cue);
    const std::size_t best = strongest(setters);
    if (best == setters.size())
      RC_ASSERT(!(answer.proposal.action.*f.member));
    else
      RC_ASSERT((answer.proposal.action.*f.member == setters[best].action.*f.member));
  });
}

RC_GTEST_PROP(PerFieldLaw, SayingEverythingTwiceChangesNothing, ()) {
  Cues cues = *any_cues();
  const Answer once = ask<Per>(cues);
  const Cues copy = cues;
  cues.insert(cues.end(), copy.begin(), copy.end());
  RC_ASSERT(ask<Per>(cues) == once);
}

RC_GTEST_PROP(PerFieldLaw, OrderDoesNotMatterWithoutTies, ()) {
  const Cues cues = without_ties(*any_cues());
  RC_ASSERT(ask<Per>(shuffled(cues)) == ask<Per>(cues));
}

}  // namespace
}  // namespace eyrie::ubf::testing
