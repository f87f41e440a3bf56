// SPDX-License-Identifier: MIT
// The tactics of scenarios/packages/defense.yaml do what their names say.
#include <gtest/gtest.h>

#include "core/units.hpp"
#include "pilot/pilot_system.hpp"
#include "support/flight.hpp"

namespace eyrie::test {
namespace {

/// An F-15 by that tree against a MiG that comes on, lets its radar search and never shoots.
struct Duel {
  explicit Duel(const std::string& tree, std::vector<std::string> sets = {}, std::uint64_t seed = 1)
      : f(load_scenario("duel_defense", with(tree, std::move(sets))), seed) {
    f.mission.run().attach(gauge);
  }

  static std::vector<std::string> with(const std::string& tree, std::vector<std::string> sets) {
    sets.insert(sets.begin(),
                {"blue.flights.eagle.tree=" + tree, "blue.flights.eagle.loadout=[aim120,aim120]"});
    return sets;
  }
  /// By truth, step by step: how near they are, and how deep the F-15 is inside the MiG's reach.
  struct Gauge final : sim::Observer {
    Duel& duel;
    double nearest = 1e9, range = 0, least_ratio = 1e9, heading = 0;
    explicit Gauge(Duel& d) : duel(d) {}
    void observe(const sim::World& world, const sim::StepInfo&,
                 std::span<const sim::Event>) override {
      const auto& s = *duel.f.scenario;
      const auto own = world.row(s.aircraft.table, s.roster.find("eagle1").value());
      const auto other = world.row(s.aircraft.table, s.roster.find("bogey1").value());
      if (!own || !other)
        return;
      const auto& a = world.rows(s.aircraft.kinematics)[*own];
      const auto& b = world.rows(s.aircraft.kinematics)[*other];
      range = norm(a.position - b.position);
      nearest = std::min(nearest, range);
      heading = a.heading;
      const auto& missile = s.library->missiles[0];  // there is one kind
      const auto zone = missile.zone.at(model::weapon::launch_situation(
          {b.position, b.velocity, b.altitude}, {a.position, a.velocity, a.altitude}));
      if (zone.r_ne > 0)
        least_ratio = std::min(least_ratio, range / zone.r_ne);
    }
  };
  [[nodiscard]] bool went(const std::string& tree) const {
    for (const auto& [phase, time] : f.log.phases("eagle1"))
      if (phase == tree)
        return true;
    return false;
  }
  [[nodiscard]] std::vector<std::string> way() const {
    std::vector<std::string> all;
    for (const auto& [phase, time] : f.log.phases("eagle1"))
      all.push_back(phase);
    return all;
  }

  Flight f;
  Gauge gauge{*this};
};

class Tactics : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Tactics, SkateLaunchesSupportsAndIsOutBeforeTheNoEscapeRange) {
  Duel duel("skate", {}, GetParam());
  for (int second = 1; second <= 240 && !duel.went("recommit"); ++second)
    duel.f.fly_until(second);
  ASSERT_TRUE(duel.f.log.first(EventKind::launch));
  const auto way = duel.way();
  ASSERT_GE(way.size(), 3U);
  EXPECT_EQ(std::vector(way.begin(), way.begin() + 3),
            (std::vector<std::string>{"launch", "support", "out"}));
  EXPECT_GT(duel.gauge.least_ratio, 1) << "of the range to the enemy's no-escape range";
  EXPECT_LT(duel.f.log.first(EventKind::seeker_active)->time,
            duel.f.log.phases("eagle1")[2].second + 3)
      << "leaves when the missile is on its own, not long before";
}

TEST_P(Tactics, ShortSkateLeavesWhenItIsSearchedForFromWithinReach) {
  Duel duel("short_skate", {}, GetParam());
  duel.f.fly_until(240);
  ASSERT_TRUE(duel.f.log.first(EventKind::launch));
  EXPECT_TRUE(duel.went("support"));
  EXPECT_TRUE(duel.went("out") || duel.f.log.first(EventKind::kill)) << "unless it has hit";
}

TEST_P(Tactics, ShortSkateGoesOnInWhenNothingSpeaksAgainstIt) {
  Duel duel("short_skate",
            {"data={aircraft: {silent: {base: mig29, radar: null}}}",
             "red.flights.bogey.aircraft=silent"},
            GetParam());
  duel.f.fly_until(240);
  ASSERT_TRUE(duel.f.log.first(EventKind::launch));
  EXPECT_FALSE(duel.went("out"));
  EXPECT_EQ(duel.way().front(), "press");
  EXPECT_TRUE(duel.went("support"));
}

TEST_P(Tactics, BanzaiGoesOnInWhateverItHears) {
  // with missiles that never kill, so that the fight goes on
  Duel duel("banzai",
            {"data={missiles: {blank: {base: aim120, warhead: {best_kill: 0}}}}",
             "blue.flights.eagle.loadout=[blank,blank]"},
            GetParam());
  duel.f.fly_until(240);
  ASSERT_TRUE(duel.f.log.first(EventKind::launch));
  EXPECT_FALSE(duel.went("out"));
  EXPECT_LT(duel.gauge.nearest, si(5, "nmi"));
  EXPECT_LT(duel.gauge.least_ratio, 1) << "inside the no-escape range, where a skate never is";
}

TEST_P(Tactics, OutAndAbortOpenTheRangeAndAbortIsNotSlower) {
  double turned[2] = {};
  for (const bool abort : {false, true}) {
    Duel duel("recommit", {}, GetParam());
    duel.f.fly_until(100);
    const double before = duel.gauge.range;
    ASSERT_LT(before, si(35, "nmi"));
    const auto& s = *duel.f.scenario;
    ASSERT_EQ(duel.f.mission.run().submit(pilot::PilotSystem::swap_tree_order(
                  duel.f.world().step() + 1, s.roster.find("eagle1").value(),
                  s.trees->find(abort ? "abort" : "out").value())),
              "");
    const double first = duel.gauge.heading;
    for (turned[abort] = 0; turned[abort] < 60; ++turned[abort]) {
      if (std::fabs(angle_between(first, duel.gauge.heading)) >= si(120, "deg"))
        break;
      duel.f.fly_until(100 + turned[abort] + 1);
    }
    EXPECT_LT(turned[abort], 40);
    duel.f.fly_until(190);
    const double after = duel.gauge.range;
    duel.f.fly_until(200);
    EXPECT_GT(duel.gauge.range, after) << "it runs away";
  }
  EXPECT_LE(turned[1], turned[0]);
}

TEST_P(Tactics, RecommitTurnsInWithoutAShot) {
  Duel duel("recommit", {}, GetParam());
  duel.f.fly_until(200);
  EXPECT_FALSE(duel.f.log.first(EventKind::launch));
  EXPECT_LT(duel.gauge.nearest, si(15, "nmi"));
}
INSTANTIATE_TEST_SUITE_P(Seeds, Tactics, testing::Range<std::uint64_t>(1, 5));

}  // namespace
}  // namespace eyrie::test
