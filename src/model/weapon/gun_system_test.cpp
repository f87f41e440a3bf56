// SPDX-License-Identifier: MIT
#include "model/weapon/systems.hpp"

#include <gtest/gtest.h>

#include "support/model/firing_range.hpp"

namespace eyrie::model::weapon {
namespace {

using test::Range;
using E = EventKind;

/// Blue `distance` behind red, both northbound at the same speed.
struct Chase {
  explicit Chase(double distance, std::uint64_t seed = 1)
      : range(seed),
        blue(range.add({0, 0, -3000}, 0, 250)),
        red(range.add({distance, 0, -3000}, 0, 250, Side::red)) {}
  void trigger(bool pressed) {
    range.row(range.aircraft().request, blue).trigger = pressed ? 1 : 0;
  }
  GunState& gun() { return range.row(range.aircraft().gun, blue); }

  Range range;
  PlayerId blue, red;
};

TEST(GunSystem, CountsRoundsAndReportsTheBurstWhenTheTriggerIsReleased) {
  Chase chase(5000);  // nobody in reach
  chase.trigger(true);
  chase.range.run(0.5);
  chase.trigger(false);
  chase.range.run(0.1);
  ASSERT_EQ(chase.range.count(E::gun_burst), 1u);
  const sim::Event burst = chase.range.all(E::gun_burst)[0];
  EXPECT_EQ(burst.values[0], 50);
  EXPECT_FALSE(burst.whom);
  EXPECT_TRUE(std::isnan(burst.values[1])) << "nobody has no range";
  EXPECT_EQ(chase.gun().rounds, 890u);
  EXPECT_EQ(chase.range.count(E::hit), 0u);
}

TEST(GunSystem, ABurstIsAtWhoComesIntoTheSightAndEachHasHisOwn) {
  Chase chase(5000);
  const PlayerId other = chase.range.add({9000, 0, -3000}, 0, 250, Side::red);
  const auto ahead = [&](PlayerId who, double distance) {
    const auto& columns = chase.range.aircraft();
    chase.range.row(columns.kinematics, who).position =
        chase.range.row(columns.kinematics, chase.blue).position + Vec3{distance, 0, 0};
  };
  const auto fire = [&](int steps) {
    for (int i = 0; i < steps; ++i) {
      chase.range.step();
      for (const PlayerId who : {chase.red, other})  // they survive whatever happens
        chase.range.row(chase.range.aircraft().damage, who).damage = 0;
    }
  };
  chase.trigger(true);
  fire(15);
  ahead(chase.red, 500);
  fire(5);
  ahead(chase.red, 6000);
  ahead(other, 500);
  fire(5);
  chase.trigger(false);
  chase.range.run(0.1);
  const auto bursts = chase.range.all(E::gun_burst);
  ASSERT_EQ(bursts.size(), 2u);
  EXPECT_EQ(bursts[0].whom, chase.red);
  EXPECT_NEAR(bursts[0].values[1], 500, 1);
  EXPECT_EQ(bursts[1].whom, other);
  EXPECT_EQ(bursts[0].values[0] + bursts[1].values[0], 50) << "the gun fires on";
}

TEST(GunSystem, ABurstGoesOnPastWhoIsInTheSightAndCannotBeHit) {
  Chase chase(500);
  const auto& columns = chase.range.aircraft();
  chase.trigger(true);
  for (int i = 0; i < 20; ++i) {
    // 2 degrees aside, the other 1.8 on the other side: both outside of the cone
    const Vec3 here = chase.range.row(columns.kinematics, chase.blue).position;
    chase.range.row(columns.kinematics, chase.red).position = here + Vec3{500, 17, 0};
    chase.range.row(columns.damage, chase.red).damage = 0;
    if (i == 10)
      chase.range.add({here.x + 500, -15.7, here.z}, 0, 250, Side::red);
    chase.range.step();
  }
  chase.trigger(false);
  chase.range.run(0.1);
  ASSERT_EQ(chase.range.count(E::gun_burst), 1U);
  EXPECT_EQ(chase.range.all(E::gun_burst)[0].whom, chase.red);
}

TEST(GunSystem, ReportsLongBurstsInPartsAndStopsWhenTheDrumIsEmpty) {
  Chase chase(5000);
  chase.trigger(true);
  chase.range.run(12);
  EXPECT_EQ(chase.gun().rounds, 0u);
  float rounds = 0;
  for (const sim::Event& burst : chase.range.all(E::gun_burst)) {
    EXPECT_LE(burst.values[0], 100);
    rounds += burst.values[0];
  }
  EXPECT_EQ(rounds, 940);
}

TEST(GunSystem, KillsACloseTargetAndIsCredited) {
  Chase chase(300);
  chase.trigger(true);
  chase.range.run(1);
  ASSERT_EQ(chase.range.count(E::kill), 1u);
  const sim::Event kill = chase.range.all(E::kill)[0];
  EXPECT_EQ(kill.who, chase.blue);
  EXPECT_EQ(kill.whom, chase.red);
  EXPECT_EQ(kill.detail, 0u) << "the gun is no player";
}

TEST(GunSystem, HitsAsOftenAsTheModelSays) {
  std::uint32_t rounds = 0;
  double damage = 0, expected = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Chase chase(600, seed);
    // red survives whatever happens, so that every round is counted
    chase.trigger(true);
    for (int step = 0; step < 10; ++step) {
      chase.range.step();
      chase.range.row(chase.range.aircraft().damage, chase.red).damage = 0;
    }
    for (const sim::Event& hit : chase.range.all(E::hit))
      damage += static_cast<double>(hit.values[0]);
    rounds += 20;
    const auto k = chase.range.world().rows(chase.range.aircraft().kinematics);
    const GunType& gun = chase.range.library().guns[0];
    const double density = chase.range.library().environment.atmosphere.at(3000).density;
    const Lead lead = lead_on(gun, density, k[0], body_axes(k[0]).forward, k[1]);
    expected += 20 * hit_probability(gun, lead, chase.range.library().aircraft[0].signature, k[1]);
  }
  const double hits = damage / 0.2, p = expected / rounds;
  EXPECT_GT(p, 0.05);
  EXPECT_LT(p, 0.5);
  EXPECT_NEAR(hits, expected, 4 * std::sqrt(rounds * p * (1 - p)));
}

TEST(GunSystem, ShootsAtWhoeverIsInTheSightFriendsToo) {
  Chase chase(400);
  chase.range.row(chase.range.aircraft().fit, chase.red).side = Side::blue;
  chase.trigger(true);
  chase.range.run(0.5);
  EXPECT_GT(chase.range.count(E::hit), 0u);
}

TEST(GunSystem, FiresNothingWithoutAGunOrTrigger) {
  Library library = Range::standard();
  AircraftType unarmed = library.aircraft[0];
  unarmed.index.gun.reset();
  Library other;
  for (std::size_t i = 0; i < library.missiles.size(); ++i)
    other.missiles.add(library.missiles.name(i), library.missiles[i]);
  other.guns.add("gun", library.guns[0]);
  other.aircraft.add("unarmed", unarmed);
  Range range(1, std::move(other));
  const PlayerId blue = range.add({0, 0, -3000}, 0, 250);
  range.add({300, 0, -3000}, 0, 250, Side::red);
  range.row(range.aircraft().request, blue).trigger = 1;
  range.run(1);
  EXPECT_TRUE(range.events().empty());
}

}  // namespace
}  // namespace eyrie::model::weapon
