// SPDX-License-Identifier: MIT
#include "debrief/health.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "record/names.hpp"
#include "scenario/mission.hpp"

namespace eyrie::test {
namespace {

using debrief::Health, model::EventKind;

/// The same run, its events alone.
class Counts final : public sim::Observer {
 public:
  void observe(const sim::World&, const sim::StepInfo&,
               std::span<const sim::Event> events) override {
    for (const sim::Event& e : events)
      if (const EventKind kind = record::kind_of(e); kind != EventKind::defend || e.whom)
        ++of[kind];
  }
  std::map<EventKind, std::uint64_t> of;  ///< of defenses those against missiles
};

TEST(Health, CountsWhatTheEventsOfTheRunSay) {
  const auto sweep = scenario::load({"scenarios/sweep.yaml", {}}, scenario::Source::disk("."));
  Health all;
  std::uint64_t launches = 0, defenses = 0, shots = 0;
  for (const std::uint64_t seed : {13, 14}) {
    const Health one = debrief::measure(sweep, seed);
    EXPECT_EQ(one.runs, 1U);
    all.add(one);
    Counts counts;
    scenario::Mission mission(sweep, seed);
    mission.run().attach(counts);
    mission.fly();
    launches += counts.of[EventKind::launch];
    defenses += counts.of[EventKind::defend];
  }
  EXPECT_EQ(all.runs, 2U);
  EXPECT_EQ(all.missiles, launches);
  EXPECT_EQ(all.launch_mach.size(), launches);
  EXPECT_EQ(all.defenses, defenses);
  for (const Health::Bin& bin : all.by_zone) {
    EXPECT_LE(bin.kills, bin.shots);
    shots += bin.shots;
  }
  EXPECT_GT(shots, 0U);
  EXPECT_LE(shots + all.at_the_dead, launches);
  EXPECT_GT(all.pursued, 60);
  EXPECT_GE(all.turned, all.gained);
  EXPECT_EQ(all.players[0], 8U);
}

double share_below(const std::vector<float>& values, float limit) {
  const auto below =
      std::count_if(values.begin(), values.end(), [=](float v) { return v < limit; });
  return static_cast<double>(below) / static_cast<double>(values.size());
}

/// What docs/models/health.md holds of 300 seeds, with room for the chance of sixteen.
TEST(Health, OfVeteransHolds) {
  const auto sweep = scenario::load({"scenarios/sweep.yaml", {}}, scenario::Source::disk("."));
  Health all;
  for (std::uint64_t seed = 1; seed <= 16; ++seed)
    all.add(debrief::measure(sweep, seed));
  EXPECT_LT(60 * static_cast<double>(all.reversals) / all.pursued, 2.5) << "they weave";
  EXPECT_LT(all.turned, 2.5 * all.gained);
  EXPECT_LT(share_below(all.pursuit_mach, 0.6F), 0.05);
  EXPECT_LT(share_below(all.pursuit_mach, 0.85F), 0.5);
  EXPECT_LT(share_below(all.launch_mach, 0.85F), 0.5);
  ASSERT_GT(all.missiles, 40U);
  EXPECT_LE(all.at_the_dead, all.missiles / 20);
  EXPECT_EQ(all.fratricides, 0U);
  EXPECT_LE(all.target_changes, 2 * all.engagements);
  EXPECT_LE(all.for_others, all.defenses / 12);
  EXPECT_GE(all.wvr_seen * 10, all.wvr * 8);
  EXPECT_LE(all.near_mates, 4U) << "mates fly into each other";
  EXPECT_EQ(all.collisions, 0U);
  EXPECT_GT(all.recommits, 20U);
  EXPECT_LE(all.recommits_lost, all.recommits / 6);
}

TEST(Health, SeesThatTrueTracksAreFlownMoreSteadily) {
  const auto steadiness = [](std::vector<std::string> sets) {
    const auto scenario = scenario::load({"scenarios/sweep_phases.yaml", std::move(sets)},
                                         scenario::Source::disk("."));
    Health all;
    for (std::uint64_t seed = 1; seed <= 16; ++seed)
      all.add(debrief::measure(scenario, seed));
    return static_cast<double>(all.reversals) / all.pursued;
  };
  EXPECT_LT(
      1.1 * steadiness({"blue.flights.eagle.privileged=true", "red.flights.bogey.privileged=true"}),
      steadiness({}));
}

}  // namespace
}  // namespace eyrie::test
