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
  const DecoyNow late = *decoy_at(d, thrown(Dispense::chaff), kDownward, 15);
  EXPECT_NEAR(late.position.x, 250 * d.chaff_slowing, 1e-3);
  EXPECT_LT(norm(late.velocity), 1e-3);
  EXPECT_NEAR(late.signature, d.chaff_section, 0.01);
  EXPECT_NEAR(decoy_at(d, thrown(Dispense::chaff), kDownward, 10 + d.chaff_bloom)->signature,
              d.chaff_section * (1 - std::exp(-1)), 1e-9);
  EXPECT_FALSE(decoy_at(d, thrown(Dispense::chaff), kDownward, 10 + d.chaff_life + 0.01));
}

TEST(DecoyAt, LetsAFlareFallTowardsItsTerminalSpeed) {
  Dispenser d;
  d.flare_life = 100;
  const DecoyNow late = *decoy_at(d, thrown(Dispense::flares), kDownward, 60);
  EXPECT_NEAR(late.velocity.z, kGravity * d.flare_slowing, 1e-6);
  // the closed form is the integral of its own velocity
  double z = 0, x = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto v =
        decoy_at(d, thrown(Dispense::flares), kDownward, 10 + (i + 0.5) * 0.001)->velocity;
    z += 0.001 * v.z;
    x += 0.001 * v.x;
  }
  const DecoyNow five = *decoy_at(d, thrown(Dispense::flares), kDownward, 15);
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

/// A missile of a kind at an aircraft that crosses, above it, or comes; with or without decoys from
/// 3 s before it would be there. Kills of so many shots.
struct Shots {
  test::Store store = kMedium;
  double heading = kPi / 2;
  double range = 8000;
  bool throws = false;
  int shots = 60;
  int kills = 0, fell = 0;

  void fly() {
    for (int seed = 1; seed <= shots; ++seed) {
      Library library = Range::standard();
      AircraftType type;
      type.stations = {{"medium", 1}, {"short", 1}};
      type.index.gun = 0;
      type.index.dispenser = library.dispensers.add("dispenser", {});
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
    }
  }
};

TEST(Chaff, SavesWhoFliesOnTheBeamAndNobodyElse) {
  Shots beam, beam_chaff{.throws = true}, hot{.heading = kPi},
      hot_chaff{.heading = kPi, .throws = true};
  for (Shots* s : {&beam, &beam_chaff, &hot, &hot_chaff})
    s->fly();
  EXPECT_GT(beam.kills, 32);
  EXPECT_LT(beam_chaff.kills, beam.kills / 2);
  EXPECT_GT(beam_chaff.fell, 40);
  EXPECT_EQ(hot_chaff.fell, 0) << "its own speed tells it from a cloud that stands in the air";
  EXPECT_EQ(hot_chaff.kills, hot.kills);
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
