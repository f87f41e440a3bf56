// SPDX-License-Identifier: MIT
#include "ubf/arbiter/fusion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/ubf/cues.hpp"

namespace eyrie::ubf::testing {
namespace {

using Fuse = Fusion<State, Action>;

constexpr double kClose = 1e-9;

TEST(Fusion, WeighsQuantitiesByVote) {
  Robot robot(make<Fuse>(probes(2)));
  robot.cue(0) = {kRunning, 3, {.altitude = 1000, .speed = 100}};
  robot.cue(1) = {kSuccess, 1, {.altitude = 2000}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 3);
  EXPECT_DOUBLE_EQ(robot.out.action.altitude.value(), 1250);
  EXPECT_EQ(robot.out.action.speed, 100.0F);
}

TEST(Fusion, BlendsHeadingsOnTheCircle) {
  Robot robot(make<Fuse>(probes(2)));
  robot.cue(0) = {kRunning, 1, {.heading = radians(350)}};
  robot.cue(1) = {kRunning, 1, {.heading = radians(20)}};
  robot.tick();
  EXPECT_NEAR(robot.out.action.heading.value(), radians(5), kClose);
}

TEST(Fusion, GivesOppositeHeadingsThatCancelToTheEarlierOfEquals) {
  Robot robot(make<Fuse>(probes(2)));
  robot.cue(0) = {kRunning, 2, {.heading = radians(90)}};
  robot.cue(1) = {kRunning, 2, {.heading = radians(270)}};
  robot.tick();
  EXPECT_NEAR(robot.out.action.heading.value(), radians(90), kClose);
}

TEST(Fusion, NeverAveragesAnOrder) {
  Robot robot(make<Fuse>(probes(3)));
  robot.cue(0) = {kRunning, 1, {.release = 1}};
  robot.cue(1) = {kRunning, 4, {.release = 9}};
  robot.cue(2) = {kRunning, 6, {.altitude = 10}};
  robot.tick();
  EXPECT_EQ(robot.out.action.release, 9u);
}

TEST(Fusion, DropsADisputedChoiceAndKeepsAnAgreedOne) {
  Robot robot(make<Fuse>(probes(3)));
  robot.cue(0) = {kRunning, 1, {.mode = 1}};
  robot.cue(1) = {kRunning, 4, {.mode = 1}};
  robot.cue(2) = {kRunning, 6, {.altitude = 10}};
  robot.tick();
  EXPECT_EQ(robot.out.action.mode, 1);
  robot.cue(2).action.mode = 2;
  robot.tick();
  EXPECT_EQ(robot.out.action.mode, std::nullopt);
}

TEST(Fusion, TracesABlendAsItsOwnAndASingleVoiceAsTheSpeakers) {
  Robot robot(make<Fuse>(probes(3)));
  robot.cue(0) = {kRunning, 1, {.heading = 1, .altitude = 5, .release = 1}};
  robot.cue(1) = {kRunning, 4, {.heading = 2, .release = 2}};
  robot.cue(2) = {kFailure, 9, {.altitude = 7, .release = 3}};
  robot.tick();
  EXPECT_EQ(robot.supplier(0), "root");
  EXPECT_EQ(robot.supplier(1), "root/probe[0]");
  EXPECT_EQ(robot.supplier(3), "root/probe[1]");
}

RC_GTEST_PROP(FusionLaw, VoteAndStatusAreTheStrongestsAndSilenceChangesNothing, ()) {
  obeys_common_laws<Fuse>(*any_cues());
}

RC_GTEST_PROP(FusionLaw, QuantitiesStayWithinWhatWasAskedFor, ()) {
  const Cues cues = *any_cues();
  const Answer answer = ask<Fuse>(cues);
  double low = 1e300, high = -1e300;
  for (const Cue& cue : cues)
    if (is_heard(cue) && cue.action.altitude) {
      low = std::min(low, *cue.action.altitude);
      high = std::max(high, *cue.action.altitude);
    }
  RC_ASSERT(answer.proposal.action.altitude.has_value() == (low <= high));
  if (low <= high) {
    RC_ASSERT(*answer.proposal.action.altitude >= low);
    RC_ASSERT(*answer.proposal.action.altitude <= high);
  }
}

RC_GTEST_PROP(FusionLaw, WhoAgreeGetExactlyWhatTheyAgreeOn, ()) {
  const Cue cue = (*any_cues_with_a_heading()).front();
  Cues cues(*rc::gen::inRange<std::size_t>(1, 6), cue);
  for (Cue& one : cues)
    one.vote = static_cast<float>(*rc::gen::inRange(1, 100)) / 7;
  RC_ASSERT(equal(ask<Fuse>(cues).proposal.action, cue.action));
}

RC_GTEST_PROP(FusionLaw, OrdersAreNeverInventedAndComeFromTheStrongest, ()) {
  const Cues cues = *any_cues();
  Cues setters;
  for (const Cue& cue : cues)
    if (is_heard(cue) && cue.action.release)
      setters.push_back(cue);
  const std::size_t best = strongest(setters);
  const auto release = ask<Fuse>(cues).proposal.action.release;
  if (best == setters.size())
    RC_ASSERT(!release);
  else
    RC_ASSERT(release == setters[best].action.release);
}

RC_GTEST_PROP(FusionLaw, OrderOnlyMovesTheLastBits, ()) {
  const Cues cues = without_ties(*any_cues());
  const Action straight = ask<Fuse>(cues).proposal.action;
  const Action other = ask<Fuse>(shuffled(cues)).proposal.action;
  RC_ASSERT(straight.release == other.release);
  RC_ASSERT(straight.mode == other.mode);
  RC_ASSERT(straight.altitude.has_value() == other.altitude.has_value());
  if (straight.altitude)
    RC_ASSERT(std::fabs(*straight.altitude - *other.altitude) <= 1e-9);
  if (straight.heading)
    RC_ASSERT(std::fabs(angle_between(*straight.heading, *other.heading)) <= kClose);
}

/// How far the resultant of the headings is from cancelling, in [0, 1].
double concentration(const Cues& cues) {
  double east = 0, north = 0, weight = 0;
  for (const Cue& cue : cues) {
    if (!is_heard(cue) || !cue.action.heading)
      continue;
    east += static_cast<double>(cue.vote) * std::sin(*cue.action.heading);
    north += static_cast<double>(cue.vote) * std::cos(*cue.action.heading);
    weight += static_cast<double>(cue.vote);
  }
  return weight > 0 ? std::hypot(east, north) / weight : 0;
}

RC_GTEST_PROP(FusionLaw, TurningEveryHeadingTurnsTheBlend, ()) {
  Cues cues = *any_cues_with_a_heading();
  RC_PRE(concentration(cues) > 1e-3);
  const double before = *ask<Fuse>(cues).proposal.action.heading;
  const double turn = *any_heading();
  for (Cue& cue : cues)
    if (cue.action.heading)
      cue.action.heading = wrap_tau(*cue.action.heading + turn);
  const double after = *ask<Fuse>(cues).proposal.action.heading;
  RC_ASSERT(std::fabs(angle_between(before + turn, after)) <= kClose);
}

RC_GTEST_PROP(FusionLaw, AHeadingStaysInsideTheArcThatHoldsEveryOpinion, ()) {
  Cues cues = *any_cues_with_a_heading();
  const double middle = *any_heading();
  double widest = 0;
  for (Cue& cue : cues) {
    if (!cue.action.heading)
      continue;
    const double aside = *rc::gen::inRange(-85, 86);
    cue.action.heading = wrap_tau(middle + radians(aside));
    if (is_heard(cue))
      widest = std::max(widest, std::fabs(radians(aside)));
  }
  const double blend = *ask<Fuse>(cues).proposal.action.heading;
  RC_ASSERT(blend >= 0);
  RC_ASSERT(blend < kTau);
  RC_ASSERT(std::fabs(angle_between(middle, blend)) <= widest + kClose);
}

RC_GTEST_PROP(FusionLaw, MoreVotePullsTheHeadingCloser, ()) {
  const double a = *any_heading();
  const double b = a + radians(*rc::gen::inRange(1, 179));
  const float vote = static_cast<float>(*rc::gen::inRange(1, 20));
  Cues cues{{kRunning, vote, {.heading = a}}, {kRunning, 3, {.heading = wrap_tau(b)}}};
  const double before = angle_between(a, *ask<Fuse>(cues).proposal.action.heading);
  cues[1].vote = 4;
  const double after = angle_between(a, *ask<Fuse>(cues).proposal.action.heading);
  RC_ASSERT(after > before);
  RC_ASSERT(before > 0);
}

Child fusion(std::size_t children, std::optional<std::uint32_t> top,
             Conflicts conflicts = Conflicts::blend) {
  auto node = make<Fuse>(probes(children));
  node->top = top;
  node->conflicts = conflicts;
  return node;
}

Answer ask_fusion(const Cues& cues, std::optional<std::uint32_t> top,
                  Conflicts conflicts = Conflicts::blend) {
  Robot robot(fusion(cues.size(), top, conflicts));
  return ask(robot, cues);
}

TEST(FusionOptions, BlendOnlyTheStrongest) {
  Robot robot(fusion(4, 2));
  robot.cue(0) = {kSuccess, 3, {.altitude = 1000}};
  robot.cue(1) = {kRunning, 1, {.altitude = 9000, .speed = 5}};
  robot.cue(2) = {kFailure, 9, {.altitude = 5000}};
  robot.cue(3) = {kRunning, 5, {.altitude = 2000}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 5);
  EXPECT_DOUBLE_EQ(robot.out.action.altitude.value(), 1625);
  EXPECT_EQ(robot.out.action.speed, std::nullopt);
  EXPECT_EQ(robot.supplier(1), "root");
}

TEST(FusionOptions, PreferTheEarlierOfEqualsAmongTheStrongest) {
  Robot robot(fusion(3, 2));
  for (std::size_t i = 0; i < 3; ++i)
    robot.cue(i) = {kRunning, 2, {.altitude = 300.0 * static_cast<double>(i)}};
  robot.tick();
  EXPECT_DOUBLE_EQ(robot.out.action.altitude.value(), 150);
}

TEST(FusionOptions, TraceAFieldThatOnlyOneOfTheStrongestSetAsIts) {
  Robot robot(fusion(3, 2));
  robot.cue(0) = {kRunning, 1, {.altitude = 10}};
  robot.cue(1) = {kRunning, 2, {.altitude = 20}};
  robot.cue(2) = {kRunning, 3, {.heading = 1}};
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 20);
  EXPECT_EQ(robot.supplier(1), "root/probe[1]");
}

TEST(FusionOptions, DropFieldsInDispute) {
  Robot robot(fusion(3, std::nullopt, Conflicts::drop));
  robot.cue(0) = {kRunning, 3, {.heading = 1, .altitude = 10, .release = 4}};
  robot.cue(1) = {kRunning, 2, {.altitude = 20, .release = 4}};
  robot.cue(2) = {kFailure, 9, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_TRUE(equal(robot.out.action, {.heading = 1, .release = 4}));
}

RC_GTEST_PROP(FusionOptionsLaw, TopOneIsWinnerTakesAll, ()) {
  const Cues cues = *any_cues();
  RC_ASSERT(ask_fusion(cues, 1) == (ask<WinnerTakesAll<State, Action>>(cues)));
}

RC_GTEST_PROP(FusionOptionsLaw, TopOfAtLeastAllIsPlainFusion, ()) {
  const Cues cues = *any_cues();
  const auto top = static_cast<std::uint32_t>(cues.size());
  RC_ASSERT(ask_fusion(cues, top) == ask<Fuse>(cues));
  RC_ASSERT(ask_fusion(cues, top, Conflicts::drop) ==
            ask_fusion(cues, std::nullopt, Conflicts::drop));
}

RC_GTEST_PROP(FusionOptionsLaw, TopIsFusionOfThoseThatAreLeft, ()) {
  Cues cues = *any_cues();
  const std::uint32_t top = *rc::gen::inRange(1u, 6u);
  const Answer answer = ask_fusion(cues, top);
  Cues rest = cues, few(cues.size());
  for (std::uint32_t i = 0; i < top; ++i)
    if (const std::size_t best = strongest(rest); best != rest.size()) {
      few[best] = rest[best];
      rest[best].status = kFailure;
    }
  RC_ASSERT(answer == ask<Fuse>(few));
}

TEST(Fusion, SaysWhoIsNotAmongTheStrongest) {
  Robot robot(fusion(4, 1));
  robot.cue(0) = {kRunning, 2, {.heading = 1}};
  robot.cue(1) = {kRunning, 5, {.heading = 2}};
  robot.cue(2) = {kFailure, 9, {}};
  robot.cue(3) = {kRunning, 0, {}};
  robot.tick();
  EXPECT_STREQ(robot.trace.why(1), "not among the strongest");
  for (const NodeIndex other : std::to_array<NodeIndex>({2, 3, 4}))
    EXPECT_EQ(robot.trace.why(other), nullptr) << other << " is, failed or abstains";
}

RC_GTEST_PROP(FusionOptionsLaw, DroppingKeepsExactlyWhatNobodyDisputes, ()) {
  const Cues cues = *any_cues();
  const Answer answer = ask_fusion(cues, std::nullopt, Conflicts::drop);
  for_each_field<Action>([&](const auto& f, auto) {
    const Cue* first = nullptr;
    bool disputed = false;
    for (const Cue& cue : cues) {
      if (!is_heard(cue) || !(cue.action.*f.member))
        continue;
      first = first ? first : &cue;
      disputed |= cue.action.*f.member != first->action.*f.member;
    }
    const auto& value = answer.proposal.action.*f.member;
    if (!first || disputed)
      RC_ASSERT(!value);
    else
      RC_ASSERT((value == first->action.*f.member));
  });
}

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
