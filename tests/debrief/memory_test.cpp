// SPDX-License-Identifier: MIT
/// \file  What other trees remember when they are asked about a recorded run, and when they fly on.
#include <gtest/gtest.h>

#include "debrief/look.hpp"
#include "debrief/what_if.hpp"
#include "support/recorded.hpp"

namespace eyrie::test {
namespace {

using namespace debrief;

/// One flight whose players have such a tree; `more` stands before the sides.
Recorded flight_by(const std::string& trees, double until, const std::string& more = "",
                   const std::string& players = "eagle1") {
  return recorded_text(R"(eyrie: 1
name: memory
reference: {latitude: 33 deg, longitude: -68 deg}
until: 10 min
ends: time
trees:
)" + trees + more + R"(
blue:
  home: {north: 0 nmi, east: -40 nmi}
  flights:
    eagle:
      aircraft: f15c
      tree: pilot
      players: [)" + players +
                           R"(]
      start: {north: 0 nmi, east: 0 nmi, altitude: 20000 ft, heading: 90 deg, speed: 450 kt}
      route: [{north: 0 nmi, east: 60 nmi}]
)",
                       until);
}

std::shared_ptr<const scenario::Scenario> with_changes(const Recorded& run,
                                                       const std::vector<std::string>& texts) {
  Diagnostics wrong;
  auto overrides = read_overrides(*run.scenario, PlayerId{1}, texts, wrong);
  EXPECT_TRUE(wrong.ok()) << wrong.text();
  return with_overrides(run, overrides.sets, std::move(overrides.changes));
}

/// Whether a branch at the first other decision ends where a flight with the other trees ends that
/// was flown so from its start.
void branches_as_if_flown_so(const Recorded& run, const std::vector<std::string>& texts) {
  const auto other = with_changes(run, texts);
  std::uint64_t first = run.last_step();
  for (std::uint32_t i = 1; i <= run.scenario->roster.players.size(); ++i)
    first = std::min(first, what_if(run, *other, PlayerId{i}, 0).first.value().step);
  std::string problem;
  const auto branched = branch(run, other, past_at(run, first), run.until(), problem);
  ASSERT_TRUE(branched) << problem;
  branched->fly();
  scenario::Mission truth(other, run.run.seed, run.until());
  truth.fly();
  scenario::Mission as_flown(run.scenario, run.run.seed, run.until());
  as_flown.fly();
  for (std::uint32_t i = 1; i <= run.scenario->roster.players.size(); ++i) {
    const auto place = [&](const sim::World& world) {
      const auto player = other->find(world, PlayerId{i}).value();
      return player.fleet.motion(world, player.row).position;
    };
    const Vec3 wanted = place(truth.run().world());
    EXPECT_EQ(norm(place(branched->after()) - wanted), 0) << i;
    EXPECT_GT(norm(place(as_flown.run().world()) - wanted), 10) << i << ": nothing was changed";
  }
}

/// The arbiter that holds its child gets memory where the sequencer had its own, which then begins
/// elsewhere.
TEST(Branch, ReadsNoMemoryOfAnotherLayout) {
  const std::string trees = R"(
  big: {selector: [{timeout: {after: 3 s, child: navigate}}, {timeout: {after: 3 s, child: navigate}}, {timeout: {after: 3 s, child: navigate}}, {timeout: {after: 3 s, child: navigate}}, {timeout: {after: 3 s, child: navigate}}, {timeout: {after: 3 s, child: navigate}}]}
  pilot:
    per_field:
      - winner_takes_all:
          - {guard: {when: time > 12 s, child: {egress: {vote: 50}}}}
          - {navigate: {vote: 5}}
      - sequencer:
          start: go
          trees: {go: {navigate: {vote: 2}}, stay: {navigate: {vote: 1}}}
          transitions: [{from: go, to: stay, when: time < 10 s}]
      - {timeout: {after: 1000 s, child: {navigate: {vote: 1}}}}
      - {timeout: {after: 1000 s, child: {navigate: {vote: 1}}}}
)";
  branches_as_if_flown_so(flight_by(trees, 30),
                          {"root/winner_takes_all=commitment", "root/winner_takes_all.margin=100"});
}

const std::string kTwoPhases = R"(
  pilot:
    sequencer:
      start: a
      trees: {a: navigate, b: {selector: [{guard: {when: time > 12 s, child: egress}}, navigate]}}
      transitions: [{from: a, to: b, when: time > 5 s and time < 5 s}]
)";
const std::string kToB = "trees.pilot.sequencer.transitions.0.when=time > 5 s and time < 6 s";

TEST(Branch, BeginsWithWhatTheOtherTreesRememberBeforeTheyActOtherwise) {
  branches_as_if_flown_so(flight_by(kTwoPhases, 30), {kToB});
  branches_as_if_flown_so(flight_by(kTwoPhases, 30, "", "eagle1, eagle2"), {kToB});
}

TEST(WhatIf, RemembersFromTheStartWhateverIsCounted) {
  const Recorded run = flight_by(kTwoPhases, 30);
  const auto other = with_changes(run, {kToB});
  const WhatIf whole = what_if(run, *other, PlayerId{1}, 0),
               late = what_if(run, *other, PlayerId{1}, 20);
  EXPECT_EQ(whole.different, 180U);
  EXPECT_EQ(late.decisions, 100U);
  EXPECT_EQ(late.different, 100U);
  EXPECT_NEAR(late.first.value().time, 20, 0.1);
  // and nothing is other that would not have been
  EXPECT_EQ(what_if(run, *with_changes(run, {"root/a.vote=10"}), PlayerId{1}, 20).different, 0U);
}

const std::string kOnceForThreeSeconds = R"(
  other: navigate
  pilot:
    selector: [{run_once: {then: failure, child: {timeout: {after: 3 s, child: navigate}}}}, egress]
)";

TEST(WhatIf, ForgetsWithAnOrderToUseTheTreeThatIsUsed) {
  const Recorded run = flight_by(kOnceForThreeSeconds, 20,
                                 "orders: [{at: 10 s, player: eagle1, swap_tree: pilot}]\n");
  const auto same = with_changes(run, {"root/run_once/timeout/navigate.vote=10"});
  EXPECT_EQ(what_if(run, *same, PlayerId{1}, 0).different, 0U);
  branches_as_if_flown_so(run, {"root/run_once/timeout.after=2 s"});
}

std::vector<std::string> changes_of(const Recorded& run) {
  std::vector<std::string> all;
  const auto found = look(run, PlayerId{1}, {.changes = true}, [&](const debrief::Change& change) {
    all.push_back(
        fmt::format("{:.1f} {} -> {}: {}", change.now.time, change.from, change.to, change.why));
  });
  EXPECT_EQ(found.count, all.size());
  return all;
}

TEST(Look, SaysWhereTheTreeWasSwappedAndNamesWhoLedInTheOldOne) {
  const std::string trees = R"(
  other:
    winner_takes_all: [navigate, {egress: {vote: 40}}]
  pilot:
    winner_takes_all: [egress, {navigate: {vote: 40}}]
)";
  const auto swapped =
      changes_of(flight_by(trees, 20, "orders: [{at: 10 s, player: eagle1, swap_tree: other}]\n"));
  ASSERT_EQ(swapped.size(), 2U) << "the same place in both trees";
  EXPECT_TRUE(swapped[0].ends_with(" nobody -> navigate: the first decision")) << swapped[0];
  EXPECT_TRUE(swapped[1].ends_with(" navigate -> egress: tree pilot was swapped for other"))
      << swapped[1];
  const auto there_and_back = changes_of(flight_by(kOnceForThreeSeconds, 20,
                                                   "orders: [{at: 10 s, player: eagle1, swap_tree: "
                                                   "other}, {at: 12 s, player: eagle1, swap_tree: "
                                                   "pilot}]\n"));
  ASSERT_EQ(there_and_back.size(), 5U);
  EXPECT_TRUE(there_and_back[2].ends_with(" egress -> navigate: tree pilot was swapped for other"));
  EXPECT_TRUE(
      there_and_back[3].ends_with(" navigate -> navigate: tree other was swapped for pilot"));
  EXPECT_TRUE(there_and_back[4].find(" navigate -> egress: ") != std::string::npos);
}

}  // namespace
}  // namespace eyrie::test
