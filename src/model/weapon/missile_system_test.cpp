// SPDX-License-Identifier: MIT
#include "model/weapon/systems.hpp"

#include <gtest/gtest.h>

#include "model/track/track_file.hpp"
#include "support/model/firing_range.hpp"
#include "support/no_allocation.hpp"

namespace eyrie::model::weapon {
namespace {

using test::kMedium;
using test::kShort;
using test::Range;
using E = EventKind;

/// Blue at the origin northbound, red `distance` north of it and southbound, both 8 km up.
struct Duel {
  explicit Duel(double distance, std::uint64_t seed = 1, Library library = Range::standard())
      : range(seed, std::move(library)),
        blue(range.add({0, 0, -8000}, 0, 280)),
        red(range.add({distance, 0, -8000}, kPi, 280, Side::red)) {}
  /// Steps with blue's track of red kept fresh.
  void run(double seconds) {
    const double end = range.time() + seconds - 1e-9;
    while (range.time() < end) {
      if (range.alive(blue) && range.alive(red))
        range.track(blue, red);
      range.step();
    }
  }
  MissileState& missile() { return range.world().rows(range.missiles().state)[0]; }
  Kinematics& missile_kinematics() { return range.world().rows(range.missiles().kinematics)[0]; }

  Range range;
  PlayerId blue, red;
};

/// A library whose warheads always kill and whose seekers measure without noise.
Library certain(const std::function<void(MissileType&)>& change = [](MissileType&) {}) {
  Library library = Range::standard();
  Library result;
  for (std::size_t i = 0; i < library.missiles.size(); ++i) {
    MissileType type = library.missiles[i];
    type.warhead.best_kill = 1;
    type.warhead.lethal_radius = 1e3;
    type.seeker.angle_noise = type.seeker.glint = 0;
    type.seeker.range_noise = type.seeker.closing_noise = 0;
    change(type);
    result.missiles.add(library.missiles.name(i), type);
  }
  result.guns.add("gun", library.guns[0]);
  result.aircraft.add("fighter", library.aircraft[0]);
  return result;
}

TEST(MissileSystem, FliesAShotFromReleaseToKill) {
  Duel duel(40e3, 1, certain());
  duel.range.shoot(duel.blue, duel.red, kMedium);
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  duel.run(60);

  const Range& range = duel.range;
  ASSERT_EQ(range.count(E::release), 1u);
  ASSERT_EQ(range.count(E::launch), 1u);
  ASSERT_EQ(range.count(E::seeker_active), 1u);
  ASSERT_EQ(range.count(E::seeker_acquired), 1u);
  ASSERT_EQ(range.count(E::detonation), 1u);
  ASSERT_EQ(range.count(E::hit), 1u);
  ASSERT_EQ(range.count(E::kill), 1u);
  const sim::Event launch = range.all(E::launch)[0];
  EXPECT_EQ(launch.detail, duel.blue.value);
  EXPECT_EQ(launch.whom, duel.red);
  EXPECT_LT(range.all(E::detonation)[0].values[0], 1) << "noise-free miss";
  const sim::Event kill = range.all(E::kill)[0];
  EXPECT_EQ(kill.who, duel.blue);
  EXPECT_EQ(kill.whom, duel.red);
  EXPECT_EQ(kill.detail, launch.who.value);
  EXPECT_FALSE(range.alive(duel.red));
  EXPECT_EQ(range.in_flight(), 0u);
}

TEST(MissileSystem, DoesNotFuzeOnWhoHasJustReleasedIt) {
  Duel duel(40e3, 1, certain([](MissileType& type) { type.warhead.arming_time = 0; }));
  duel.range.shoot(duel.blue, duel.red, kMedium);
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  duel.run(60);
  ASSERT_EQ(duel.range.count(E::detonation), 1U);
  EXPECT_EQ(duel.range.all(E::detonation)[0].whom, duel.red);
}

TEST(MissileSystem, MeetsItsTargetHoweverFastItIs) {
  Duel duel(40e3, 1, certain([](MissileType& type) {
              type.warhead.fuze_range = 50;
              type.motor.mass = Table1({0, 8}, {30, 10});
              type.motor.thrust = Table1({0, 8}, {120e3, 120e3});
            }));
  duel.range.shoot(duel.blue, duel.red, kMedium);
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  double fastest = 0;
  while (duel.range.count(E::detonation) + duel.range.count(E::timeout) == 0) {
    duel.run(0.02);
    if (duel.range.in_flight() > 0)
      fastest = std::max(fastest, duel.missile_kinematics().speed);
  }
  EXPECT_GT(fastest, 5000);
  EXPECT_EQ(duel.range.count(E::detonation), 1U);
}

TEST(MissileSystem, InheritsPlaceAndSpeedAndFallsClearOfTheAircraft) {
  Duel duel(40e3);
  duel.range.shoot(duel.blue, duel.red, kMedium);
  while (duel.range.in_flight() == 0)
    duel.run(0.02);
  const Kinematics shooter = duel.range.row(duel.range.aircraft().kinematics, duel.blue);
  EXPECT_LT(norm(duel.missile_kinematics().position - shooter.position), 1e-9);
  const Vec3 away = duel.missile_kinematics().velocity - shooter.velocity;
  EXPECT_NEAR(dot(away, shooter.down), 6, 1e-9);
  EXPECT_EQ(duel.missile().shooter, duel.blue);
  EXPECT_EQ(duel.missile().intended, duel.red);
  // straight on until it is clear
  const double heading = duel.missile_kinematics().heading;
  while (duel.range.time() - duel.missile().launch_time < 0.6) {
    duel.run(0.02);
    EXPECT_NEAR(duel.missile_kinematics().heading, heading, 1e-6);
    EXPECT_EQ(duel.missile().lift, Vec3{});
  }
}

TEST(MissileSystem, LosesItsLinkWhenTheShooterDies) {
  Duel duel(60e3);
  duel.range.shoot(duel.blue, duel.red, kMedium);
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  duel.run(5);
  const double heard = duel.missile().target_time;
  EXPECT_GT(heard, duel.range.time() - 1.1);
  const auto row = duel.range.world().row(duel.range.aircraft().table, duel.blue);
  duel.range.world().remove(duel.range.aircraft().table, *row);
  duel.range.world().compact();
  duel.run(5);
  ASSERT_EQ(duel.range.in_flight(), 1u);
  EXPECT_LT(duel.missile().target_time, heard + 1.1);
  // it goes on to where the target must be, and finds it there
  duel.run(60);
  EXPECT_EQ(duel.range.count(E::seeker_acquired), 1u);
}

TEST(MissileSystem, LosesItsLinkWhenTheShooterLosesTheTrack) {
  Duel duel(60e3);
  duel.range.shoot(duel.blue, duel.red, kMedium);
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  duel.run(3);
  const double heard = duel.missile().target_time;
  duel.range.row(duel.range.aircraft().tracks, duel.blue).count = 0;
  duel.range.run(5);
  EXPECT_EQ(duel.missile().target_time, heard);
}

TEST(MissileSystem, FollowsItsTrackIntoTheOneThatItIsMergedWith) {
  Duel duel(60e3);
  Request& request = duel.range.row(duel.range.aircraft().request, duel.blue);
  duel.range.shoot(duel.blue, duel.red, kMedium);
  TrackFile& file = duel.range.row(duel.range.aircraft().tracks, duel.blue);
  request.shoot_at = file.tracks[0].id = TrackId{7};
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  duel.run(3);
  ASSERT_EQ(duel.missile().track, TrackId{7});
  for (const std::uint32_t older : {6, 5, 4, 3}) {
    file.tracks[0].along.position = file.tracks[0].across.position = 100;
    file.tracks[1] = file.tracks[0];
    file.tracks[0].id = TrackId{older};
    file.count = 2;
    track::TrackNewsList news;
    const track::Tracker tracker;
    track::upkeep(file, {tracker, {}, duel.range.time(), 3, news});
    ASSERT_EQ(file.count, 1u);
    duel.run(2);
    EXPECT_GT(duel.missile().target_time, duel.range.time() - 1.1) << older;
  }
}

TEST(MissileSystem, DestroysItselfWhenItFindsNobody) {
  Duel duel(30e3);
  duel.range.shoot(duel.blue, duel.red, kMedium);
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  duel.run(1);
  const auto row = duel.range.world().row(duel.range.aircraft().table, duel.red);
  duel.range.world().remove(duel.range.aircraft().table, *row);
  duel.range.world().compact();
  duel.range.row(duel.range.aircraft().tracks, duel.blue).count = 0;
  duel.range.run(60);
  ASSERT_EQ(duel.range.count(E::timeout), 1u);
  EXPECT_EQ(duel.range.all(E::timeout)[0].values[0], float(MissileEnd::lost));
  EXPECT_EQ(duel.range.in_flight(), 0u);
}

TEST(MissileSystem, SaysWhyAMissileEnds) {
  const MissileType type = certain().missiles[kMedium];
  Kinematics k{.altitude = 5000, .speed = 600};
  MissileState state{.launch_time = 100};
  EXPECT_EQ(end_of(type, k, state, 110), MissileEnd::none);
  k.altitude = -1;
  EXPECT_EQ(end_of(type, k, state, 110), MissileEnd::ground);
  k.altitude = 5000;
  k.speed = type.least_speed - 1;
  EXPECT_EQ(end_of(type, k, state, 110), MissileEnd::speed);
  EXPECT_EQ(end_of(type, k, state, 101), MissileEnd::none) << "the motor still burns";
  k.speed = 600;
  EXPECT_EQ(end_of(type, k, state, 100 + type.greatest_time + 1), MissileEnd::time);
  state.active = 1;
  state.sight_time = 110;
  EXPECT_EQ(end_of(type, k, state, 110 + type.seeker.memory - 0.1), MissileEnd::none);
  EXPECT_EQ(end_of(type, k, state, 110 + type.seeker.memory + 0.1), MissileEnd::lost);
}

TEST(MissileSystem, LetsTwoMissilesFlyAtOneTarget) {
  Duel duel(30e3, 1, certain());
  const PlayerId wingman = duel.range.add({0, 2000, -8000}, 0, 280);
  duel.range.shoot(duel.blue, duel.red, kMedium);
  duel.range.shoot(wingman, duel.red, kMedium);
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  duel.range.hold_fire(wingman);
  duel.run(0.5);
  EXPECT_EQ(duel.range.in_flight(), 2u);
  duel.run(60);
  // both may hit, one is credited, none is left over
  EXPECT_EQ(duel.range.count(E::kill), 1u);
  EXPECT_EQ(duel.range.count(E::detonation) + duel.range.count(E::timeout), 2u);
  EXPECT_EQ(duel.range.in_flight(), 0u);
}

TEST(MissileSystem, KillsWithTheProbabilityOfItsMissDistance) {
  int kills = 0, shots = 0;
  double expected = 0, miss2 = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Duel duel(12e3, seed);
    duel.range.shoot(duel.blue, duel.red, kMedium);
    duel.run(0.1);
    duel.range.hold_fire(duel.blue);
    duel.run(25);
    for (const sim::Event& event : duel.range.all(E::detonation)) {
      ++shots;
      expected += static_cast<double>(event.values[1]);
      miss2 += static_cast<double>(event.values[0] * event.values[0]);
    }
    kills += int(duel.range.count(E::kill));
  }
  EXPECT_GE(shots, 54) << "who misses by more than the fuze sees is none";
  // glint of 2.2 m that wanders in 0.1 s, through filter and autopilot (0.1 s twice, 0.15 s): 1.3
  // of it along each of two axes by the adjoint, and 0.74 to kill
  EXPECT_NEAR(std::sqrt(miss2 / (2 * shots)), 1.3 * 2.2, 0.6);
  EXPECT_NEAR(expected / 60, 0.74, 0.06);
  EXPECT_NEAR(kills, expected, 4 * std::sqrt(60 * 0.74 * 0.26));
}

TEST(MissileSystem, RadiatesOnlyWhileItsRadarSeekerIsActive) {
  Duel duel(40e3, 1, certain());
  duel.range.shoot(duel.blue, duel.red, kMedium);
  duel.run(0.1);
  duel.range.hold_fire(duel.blue);
  duel.run(2);
  const auto emission = [&] { return duel.range.world().rows(duel.range.missiles().emission)[0]; };
  EXPECT_EQ(emission().kind, EmissionKind::none);
  duel.range.run(60, [&] { return duel.range.count(E::seeker_acquired) > 0; });
  duel.run(0.1);
  EXPECT_EQ(emission().kind, EmissionKind::missile_seeker);
  EXPECT_EQ(emission().dwell, duel.red);
  EXPECT_GT(emission().figure, 1e6);
  const Vec3 to_red = duel.range.row(duel.range.aircraft().kinematics, duel.red).position -
                      duel.missile_kinematics().position;
  EXPECT_LT(angle_between(emission().boresight, to_red), 0.01);
}

TEST(MissileSystem, KeepsAnInfraredMissileSilent) {
  Duel duel(2500, 1, certain());
  duel.range.row(duel.range.aircraft().propulsion, duel.red).throttle = 2;
  duel.range.shoot(duel.blue, duel.red, kShort);
  duel.run(0.5);
  ASSERT_EQ(duel.range.in_flight(), 1u);
  EXPECT_EQ(duel.range.world().rows(duel.range.missiles().emission)[0].kind, EmissionKind::none);
  duel.range.hold_fire(duel.blue);
  duel.run(20);
  EXPECT_EQ(duel.range.count(E::kill), 1u);
}

TEST(MissileSystem, AllocatesNothingFromReleaseToKill) {
  Duel duel(30e3, 1, certain());
  duel.range.shoot(duel.blue, duel.red, kMedium);
  {
    const NoAllocation guard;
    duel.range.run(0.1);
    duel.range.hold_fire(duel.blue);
    duel.range.run(40);
  }
  EXPECT_EQ(duel.range.count(E::kill), 1u);
}

TEST(MissileSystem, GivesTheSameBitsForTheSameSeed) {
  const auto hash = [](std::uint64_t seed) {
    Duel duel(35e3, seed);
    duel.range.shoot(duel.blue, duel.red, kMedium);
    duel.run(26);
    return duel.range.world().hash();
  };
  EXPECT_EQ(hash(1), hash(1));
  EXPECT_NE(hash(1), hash(2));
}

TEST(MissileSystem, FliesTheMirrorImageOfAMirroredScene) {
  const auto flown = [](double side) {
    Range range;
    const PlayerId blue = range.add({0, 0, -8000}, 0, 280);
    const PlayerId red = range.add({18e3, side * 5000, -7000}, side * 2.5, 280, Side::red);
    range.shoot(blue, red, kMedium);
    range.run(0.1);
    range.hold_fire(blue);
    range.run(15);
    EXPECT_EQ(range.count(E::seeker_acquired), 1u);
    return range.world().rows(range.missiles().kinematics)[0];
  };
  const Kinematics right = flown(1), left = flown(-1);
  EXPECT_GT(norm(right.position), 8e3);
  EXPECT_EQ(left.position, (Vec3{right.position.x, -right.position.y, right.position.z}));
  EXPECT_EQ(left.velocity, (Vec3{right.velocity.x, -right.velocity.y, right.velocity.z}));
  EXPECT_EQ(left.heading, -right.heading);
}

TEST(MissileSystem, RefusesALookRateThatDoesNotFitTheStep) {
  Library library;
  MissileType type;
  type.seeker.look_rate = 33;
  library.missiles.add("odd", type);
  sim::SchemaBuilder schema;
  const auto aircraft = AircraftColumns::define(schema, 1);
  const auto missiles = MissileColumns::define(schema, 1);
  EXPECT_THROW(MissileSystem(aircraft, missiles, std::make_shared<Library>(library), 0.02),
               std::logic_error);
}

}  // namespace
}  // namespace eyrie::model::weapon
