// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>

#include "core/units.hpp"
#include "support/flight.hpp"

namespace eyrie::test {
namespace {

TEST(Merge, IsFoughtOutWithinSightWithShortRangeMissilesAndTheGun) {
  const auto scenario = load_scenario("merge");
  constexpr std::uint64_t kSeeds = 24;
  std::map<std::string, int> kills, winners;
  int wvr = 0, launches = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Flight f(scenario, seed);
    f.mission.fly();

    // the fight is on when they pass, within a second for both, and never before
    double first_wvr = 1e9;
    for (const char* who : {"viper1", "bandit1"}) {
      const auto phases = f.log.phases(who);
      ASSERT_EQ(phases.size(), 2U) << who;
      EXPECT_EQ(phases[0].first, "ingress");
      EXPECT_EQ(phases[1].first, "wvr");
      EXPECT_NEAR(phases[1].second, 47, 3) << who;
      first_wvr = std::min(first_wvr, phases[1].second);
      wvr += 1;
    }
    for (const EventKind shot : {EventKind::launch, EventKind::gun_burst})
      for (const Happened& h : f.log.of(shot))
        EXPECT_GT(h.time, first_wvr);

    // nobody has a missile for more than the eye sees
    for (const Happened& h : f.log.of(EventKind::launch)) {
      ++launches;
      EXPECT_EQ(record::store_label(*scenario, h.event.values[1]), "AIM-9");
      EXPECT_LT(h.event.values[0], si(5, "nmi"));
    }
    for (const Happened& h : f.log.of(EventKind::crash))
      EXPECT_TRUE(f.log.first(EventKind::fuel_out, scenario->roster.name(h.event.who)))
          << "nobody flies into the ground or the other";
    for (const Happened& h : f.log.of(EventKind::kill)) {
      ++kills[h.event.detail ? "missile" : "gun"];
      ++winners[scenario->roster.name(h.event.who)];
    }
  }
  EXPECT_EQ(wvr, 2 * static_cast<int>(kSeeds));
  EXPECT_GE(kills["missile"] + kills["gun"], static_cast<int>(kSeeds) / 2) << "most are decided";
  EXPECT_GE(launches, 1);
  EXPECT_GE(kills["gun"], 1);
  EXPECT_GE(winners["viper1"], 1) << "neutral: either may win";
  EXPECT_GE(winners["bandit1"], 1);
}

}  // namespace
}  // namespace eyrie::test
