// SPDX-License-Identifier: MIT
#include "model/weapon/countermeasures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/weapon/homing.hpp"
#include "support/description_mistakes.hpp"
#include "support/model/firing_range.hpp"

namespace eyrie::model::weapon {
namespace {

using test::kMedium;
using test::kShort;
using test::Range;
using E = EventKind;

const Vec3 kDownward{0, 0, 1};

Decoy thrown(Dispense kind) {
  return {.velocity = {250, 0, 0}, .time = 10, .step = 500, .kind = kind};
}

TEST(Dispenser, IsDescribedRightly) {
  EXPECT_EQ(eyrie::description_mistakes<Dispenser>(), "");
}

TEST(DecoyAt, LetsChaffStandInTheAirAfterItsTimeConstant) {
  const Dispenser d;
  const DecoyNow late = *decoy_at(d, thrown(Dispense::chaff), kDownward, {}, 15);
  EXPECT_NEAR(late.position.x, 250 * d.chaff_slowing, 1e-3);
  EXPECT_LT(norm(late.velocity), 1e-3);
  EXPECT_NEAR(late.signature, d.chaff_section, 0.01);
  EXPECT_NEAR(decoy_at(d, thrown(Dispense::chaff), kDownward, {}, 10 + d.chaff_bloom)->signature,
              d.chaff_section * (1 - std::exp(-1)), 1e-9);
  EXPECT_FALSE(decoy_at(d, thrown(Dispense::chaff), kDownward, {}, 10 + d.chaff_life + 0.01));
}

TEST(DecoyAt, LetsChaffDriftWithTheWind) {
  const Dispenser d;
  const Vec3 wind{-30, 40, 0};
  Decoy carried = thrown(Dispense::chaff);
  carried.velocity += wind;
  for (const double time : {10.1, 12.0, 15.0}) {
    const DecoyNow calm = *decoy_at(d, thrown(Dispense::chaff), kDownward, {}, time);
    const DecoyNow now = *decoy_at(d, carried, kDownward, wind, time);
    EXPECT_LT(norm(now.position - calm.position - (time - 10) * wind), 1e-9);
    EXPECT_LT(norm(now.velocity - calm.velocity - wind), 1e-9);
  }
}

TEST(DecoyAt, LetsAFlareFallTowardsItsTerminalSpeed) {
  Dispenser d;
  d.flare_life = 100;
  const DecoyNow late = *decoy_at(d, thrown(Dispense::flares), kDownward, {}, 60);
  EXPECT_NEAR(late.velocity.z, kGravity * d.flare_slowing, 1e-6);
  // the closed form is the integral of its own velocity
  double z = 0, x = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto v =
        decoy_at(d, thrown(Dispense::flares), kDownward, {}, 10 + (i + 0.5) * 0.001)->velocity;
    z += 0.001 * v.z;
    x += 0.001 * v.x;
  }
  const DecoyNow five = *decoy_at(d, thrown(Dispense::flares), kDownward, {}, 15);
  EXPECT_NEAR(five.position.z, z, 1e-4);
  EXPECT_NEAR(five.position.x, x, 1e-3);
}

TEST(ThrowOut, KeepsTheProgramsIntervalAndEndsWhenItIsEmpty) {
  const Dispenser d{.chaff = 3, .flares = 1, .interval = 0.5};
  Decoys decoys = loaded(d);
  int cartridges = 0;
  for (std::uint64_t step = 0; step < 200; ++step)
    cartridges +=
        throw_out(d, Dispense::both, {}, {}, 0.02 * double(step), step, decoys) != Dispense::none;
  EXPECT_EQ(cartridges, 3);
  EXPECT_EQ(decoys.chaff, 0);
  EXPECT_EQ(decoys.flares, 0);
  EXPECT_EQ(decoys.thrown[0].kind, Dispense::chaff);
  EXPECT_EQ(decoys.thrown[1].kind, Dispense::flares);
  EXPECT_EQ(decoys.thrown[2].step, 25U);
  EXPECT_EQ(decoys.thrown[3].step, 50U);
}

TEST(Merged, IsChaffWithAnAircraftOnTheBeamOnly) {
  const SeekerType seeker{.range_gate = 150, .doppler_gate = 30};
  const auto merges = [&](double degrees) {  // heading of the aircraft off the line, chaff at rest
    const Vec3 v{250 * std::cos(radians(degrees)), 250 * std::sin(radians(degrees)), 0};
    return merged(seeker, {.line = {1, 0, 0}, .range = 8000, .offset = -0.5 * v, .slip = -1 * v});
  };
  EXPECT_TRUE(merges(90));
  EXPECT_TRUE(merges(87));
  EXPECT_FALSE(merges(86)) << "250 m/s cos 86 deg = 17 m/s, half of the gate is 15";
  EXPECT_FALSE(merges(0));
  EXPECT_FALSE(merges(180));
  EXPECT_FALSE(merged(seeker, {.line = {1, 0, 0}, .range = 8000, .offset = {76, 0, 0}}));
}

/// What flies from a seeker, or at it, gains nothing by chaff, not even in the moment in which a
/// cloud has still its speed: it loses that faster than a gate follows.
TEST(Merged, IsChaffNeverWithWhoFliesAlongTheLine) {
  const SeekerType seeker{.range_gate = 150, .doppler_gate = 30};
  const Dispenser d;
  for (double speed = 45; speed < 400; speed += 5)
    for (double age = 0.02; age < d.chaff_life; age += 0.02) {
      const Vec3 v{speed, 0, 0};
      const Decoy decoy{.velocity = v, .kind = Dispense::chaff};
      const DecoyNow now = *decoy_at(d, decoy, kDownward, {}, age);
      EXPECT_FALSE(merged(seeker, {.line = {1, 0, 0},
                                   .range = 8000,
                                   .offset = now.position - age * v,
                                   .slip = now.velocity - v,
                                   .acceleration = now.acceleration}))
          << speed << " m/s after " << age << " s";
    }
}

TEST(Merged, IsAFlareInTheFieldOfView) {
  const SeekerType seeker{.kind = SeekerKind::infrared, .field_of_view = 0.04};
  const auto at = [&](double aside) {
    return merged(seeker, {.line = {1, 0, 0}, .range = 3000, .offset = {900, aside, 0}});
  };
  EXPECT_TRUE(at(59));
  EXPECT_FALSE(at(61));
}

TEST(Seduction, IsTheShareOfThePowerLessWhatIsRejected) {
  EXPECT_NEAR(seduction({}, 60, 30), 2.0 / 3, 1e-12);
  EXPECT_NEAR(seduction({.decoy_rejection = 0.6}, 8000, 2000), 0.4 * 0.8, 1e-12);
  EXPECT_EQ(seduction({}, 0, 0), 0);
}

TEST(TowedAt, IsBehindTheAircraftOneAfterTheOther) {
  const Dispenser d{.towed = 2, .tow_length = 100};
  Decoys decoys = loaded(d);
  EXPECT_EQ(*towed_at(d, decoys, {0, 250, 0}, 0), (Vec3{0, -100, 0}));
  decoys.tow_time = 30;
  EXPECT_FALSE(towed_at(d, decoys, {0, 250, 0}, 29.9));
  EXPECT_TRUE(towed_at(d, decoys, {0, 250, 0}, 30));
  decoys.towed = 0;
  EXPECT_FALSE(towed_at(d, decoys, {0, 250, 0}, 40));
}

TEST(SeenTogether, IsTheCentroidUntilGateOrBeamResolvesThemAndThenTheStronger) {
  const SeekerType seeker{.field_of_view = 0.2, .range_gate = 150};
  const Vec3 across{0, 100, 0}, along{100, 0, 0};
  const auto at = [&](double range, const Vec3& offset, double decoy) {
    return seen_together(seeker, {range, 0, 0}, offset, decoy, 10);
  };
  EXPECT_EQ(at(8000, across, 30).shift, 0.75 * across);
  EXPECT_DOUBLE_EQ(at(8000, across, 30).signature, 40);
  // 0.2 rad of beam are 100 m at 500 m
  EXPECT_EQ(at(510, across, 30).shift, 0.75 * across);
  EXPECT_EQ(at(490, across, 30).shift, across);
  EXPECT_EQ(at(490, across, 9).shift, Vec3{});
  EXPECT_DOUBLE_EQ(at(490, across, 9).signature, 10);
  // along the line half a gate of 150 m is between them
  EXPECT_EQ(at(8000, along, 30).shift, along);
  EXPECT_EQ(at(8000, along, 9).shift, Vec3{});
}

/// A missile of a kind at an aircraft that crosses, above it, or comes; with or without decoys from
/// 3 s before it would be there. Kills of so many shots.
struct Shots {
  test::Store store = kMedium;
  double heading = kPi / 2;
  double range = 8000;
  bool throws = false;
  int shots = 60;
  double towed = 0;  ///< m^2, of a decoy on a line; 0: none
  int kills = 0, fell = 0, met = 0;

  void fly() {
    for (int seed = 1; seed <= shots; ++seed) {
      Library library = Range::standard();
      AircraftType type;
      type.stations = {{"medium", 1}, {"short", 1}};
      type.index.gun = 0;
      type.index.dispenser = library.dispensers.add(
          "dispenser", {.towed = static_cast<std::uint16_t>(towed > 0), .towed_section = towed});
      type.signature = {.rcs_front = 5, .rcs_side = 30, .rcs_rear = 8};
      Shelf<AircraftType> shelf;
      shelf.add("fighter", type);
      library.aircraft = shelf;
      Range sky(static_cast<std::uint64_t>(seed), std::move(library));
      const PlayerId blue = sky.add({0, 0, -6000}, 0, 280);
      const PlayerId red = sky.add({range, 0, -7500}, heading, 250, Side::red);
      sky.row(sky.aircraft().decoys, red) = loaded(sky.library().dispensers[0]);
      bool launched = false;
      sky.run(40, [&] {
        if (!sky.alive(red))
          return true;
        if (!launched)
          sky.shoot(blue, red, store);
        launched = sky.count(E::launch) > 0;
        if (launched)
          sky.hold_fire(blue);
        sky.row(sky.aircraft().request, red).dispense =
            throws && launched ? Dispense::both : Dispense::none;
        return launched && sky.in_flight() == 0;
      });
      kills += !sky.alive(red);
      fell += sky.count(E::decoyed) > 0;
      for (const sim::Event& e : sky.all(E::timeout))
        met += e.values[0] == float(MissileEnd::decoy) && e.whom == red;
      if (towed > 0 && sky.alive(red) && met > 0) {
        EXPECT_LE(sky.row(sky.aircraft().decoys, red).towed, 1);
      }
    }
  }
};

TEST(Chaff, SavesWhoFliesOnTheBeamAndNobodyElse) {
  // the missile leads by 15 degrees
  const double abeam = radians(105), off = radians(115);
  Shots beam{.heading = abeam}, beam_chaff{.heading = abeam, .throws = true}, hot{.heading = kPi},
      hot_chaff{.heading = kPi, .throws = true}, off_beam{.heading = off},
      off_beam_chaff{.heading = off, .throws = true};
  for (Shots* s : {&beam, &beam_chaff, &hot, &hot_chaff, &off_beam, &off_beam_chaff})
    s->fly();
  EXPECT_GT(beam.kills, 32);
  EXPECT_LT(beam_chaff.kills, beam.kills / 2);
  EXPECT_GT(beam_chaff.fell, 40);
  EXPECT_EQ(hot_chaff.fell, 0) << "its own speed tells it from a cloud that stands in the air";
  EXPECT_EQ(hot_chaff.kills, hot.kills);
  EXPECT_EQ(off_beam_chaff.kills, off_beam.kills);
}

TEST(TowedDecoy, IsHitInTheAircraftsPlaceWhereItIsStronger) {
  Shots none, strong{.towed = 300}, weak{.towed = 1}, heat{.store = kShort, .range = 2500},
      heat_towed{.store = kShort, .range = 2500, .towed = 300};
  for (Shots* s : {&none, &strong, &weak, &heat, &heat_towed})
    s->fly();
  EXPECT_GT(none.kills, 32);
  EXPECT_EQ(strong.kills, 0);
  EXPECT_GT(strong.met, 50);
  EXPECT_NEAR(weak.kills, none.kills, 12) << "a thirtieth of the echo from the side";
  EXPECT_EQ(weak.met, 0);
  EXPECT_EQ(heat_towed.kills, heat.kills) << "an infrared seeker does not see it";
}

TEST(TowedDecoy, OfTheStrengthOfTheAircraftLetsMostMissilesPassBetween) {
  Shots between{.towed = 30};
  between.fly();
  EXPECT_LT(between.kills, 15) << "a beam of 12 degrees resolves 100 m half a second before";
}

TEST(TowedDecoy, IsFollowedByTheNextAfterItsTime) {
  Library library = Range::standard();
  AircraftType type;
  type.stations = {{"medium", 1}, {"medium", 1}};
  type.index.gun = 0;
  type.index.dispenser =
      library.dispensers.add("dispenser", {.towed = 2, .towed_section = 300, .tow_time = 12});
  type.signature = {.rcs_front = 5, .rcs_side = 30, .rcs_rear = 8};
  Shelf<AircraftType> shelf;
  shelf.add("fighter", type);
  library.aircraft = shelf;
  Range sky(1, std::move(library));
  const PlayerId blue = sky.add({0, 0, -6000}, 0, 280);
  const PlayerId red = sky.add({8000, 0, -7500}, kPi / 2, 250, Side::red);
  Decoys& decoys = sky.row(sky.aircraft().decoys, red);
  decoys = loaded(sky.library().dispensers[0]);
  sky.run(60, [&] {
    if (sky.count(E::launch) == 0)
      sky.shoot(blue, red, kMedium);
    else
      sky.hold_fire(blue);
    return sky.count(E::timeout) > 0;
  });
  ASSERT_EQ(sky.count(E::timeout), 1U);
  const Decoys& left = sky.row(sky.aircraft().decoys, red);
  EXPECT_EQ(left.towed, 1);
  EXPECT_NEAR(left.tow_time, sky.time() + 12, 0.1);
  const Dispenser& d = sky.library().dispensers[0];
  EXPECT_FALSE(towed_at(d, left, {250, 0, 0}, sky.time()));
  EXPECT_TRUE(towed_at(d, left, {250, 0, 0}, sky.time() + 12.1));
}

TEST(Flares, SaveFromAnInfraredMissileAsItsRejectionLets) {
  Shots without{.store = kShort, .heading = 0, .range = 2500},
      with{.store = kShort, .heading = 0, .range = 2500, .throws = true};
  without.fly();
  with.fly();
  EXPECT_GT(without.kills, 45);
  EXPECT_LT(with.kills, without.kills * 3 / 4);
  EXPECT_GT(with.fell, 20);
}

}  // namespace
}  // namespace eyrie::model::weapon
