// SPDX-License-Identifier: MIT
// The eyes and the missile warnings of the sensor system.
#include <gtest/gtest.h>

#include "model/track/track_file.hpp"
#include "support/model/air_war.hpp"

namespace eyrie::model::sensor {
namespace {

using test::AirWar;
using test::flying;

using test::kHigh;
using test::kMile;

TEST(Watch, SeesAndRecognizesAnAircraftNearBy) {
  AirWar war;
  war.models.radars = {};
  war.models.radars.add("weak", {.reference_range = 1, .reference_rcs = 1e4});
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({500, 1500, kHigh - 500}, 0, 250));
  war.build();
  war.fly(20);
  const Track* track = war.track_of(eagle, bogey);
  ASSERT_NE(track, nullptr);
  EXPECT_EQ(track->sources, kFromVisual);
  EXPECT_EQ(track->identity, Identity::hostile);
  EXPECT_LT(norm(position_at(*track, 20) - war.row(war.aircraft.kinematics, bogey).position), 500);
}

TEST(Watch, WarnsOfAMissileByEarAndByEye) {
  AirWar war;
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId mate = war.add(Side::red, flying({30 * kMile, 20e3, kHigh}, 0, 250));
  war.build();
  const PlayerId missile =
      war.launch(mate, Side::red, flying({9000, 0, kHigh - 300}, kPi, 800), eagle);
  war.fly(0.2);
  EXPECT_EQ(war.row(war.aircraft.threats, eagle).count, 0u) << "silent and far";
  Emission& e = war.world->rows(war.missiles.emission)[0];
  e = {.position = {9000, 0, kHigh - 300},
       .boresight = {-1, 0, 0},
       .cos_half_angle = 0.99,
       .figure = emission_figure(15e3, 5),
       .kind = EmissionKind::missile_seeker,
       .side = Side::red};
  war.fly(1);
  const Threats* threats = &war.row(war.aircraft.threats, eagle);
  ASSERT_EQ(threats->count, 1u);
  EXPECT_EQ(threats->missiles[0].sources & kThreatFromRwr, kThreatFromRwr);
  EXPECT_EQ(war.told(EventKind::missile_warning, eagle, missile), 1);
  EXPECT_EQ(war.row(war.aircraft.rwr, eagle).warnings[0].kind, EmissionKind::missile_seeker);
  war.fly(6);
  threats = &war.row(war.aircraft.threats, eagle);
  EXPECT_EQ(threats->missiles[0].sources, kThreatFromRwr | kThreatFromSight);
  EXPECT_EQ(war.told(EventKind::missile_warning, eagle, missile), 1) << "still the same one";
}

/// Threats that a pilot with perfect eyes makes out of one missile of that side in 3 s.
std::uint32_t threats_of(Side side, const Kinematics& missile) {
  AirWar war;
  war.models.visuals = {};
  war.models.visuals.add("eagle-eyed", {.search = 1e8, .cued_search = 1e8});
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({30 * kMile, 0, kHigh}, 0, 250));
  war.build();
  war.launch(side == Side::red ? bogey : eagle, side, missile, eagle);
  war.fly(3);
  return war.row(war.aircraft.threats, eagle).count;
}

TEST(Watch, IsNotAlarmedByMissilesOfItsOwnSideOrThatFlyAway) {
  const Kinematics coming = flying({6000, 0, kHigh}, kPi, 800);
  EXPECT_EQ(threats_of(Side::red, coming), 1u);
  EXPECT_EQ(threats_of(Side::blue, coming), 0u);
  EXPECT_EQ(threats_of(Side::red, flying({3000, 500, kHigh}, 0, 800)), 0u);
  EXPECT_EQ(threats_of(Side::red, flying({6000, -2000, kHigh}, kPi / 2, 800)), 0u) << "crossing";
}

TEST(Watch, LosesAMissileWhoseMotorHasBurntOutWhileItIsFar) {
  AirWar war;
  war.models.visuals = {};
  war.models.visuals.add("eagle-eyed", {.search = 1e8, .cued_search = 1e8});
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({30 * kMile, 0, kHigh}, 0, 250));
  war.build();
  war.launch(bogey, Side::red, flying({14e3, 0, kHigh}, kPi, 800), eagle);
  war.fly(8.5);  // it has burnt for 5 s, and is 5 km away
  const Threats& threats = war.row(war.aircraft.threats, eagle);
  ASSERT_EQ(threats.count, 1u);
  EXPECT_GT(threats.missiles[0].position_time, 4);
  EXPECT_LE(threats.missiles[0].position_time, 5);
}

TEST(Watch, KeepsItsEyesOnWhatItHasSeen) {
  AirWar war;
  war.models.visuals = {};
  war.models.visuals.add("alert", {.search = 140e3});
  war.models.radars = {};
  war.models.radars.add("weak", {.reference_range = 1, .reference_rcs = 1e4});
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({2500, 3000, kHigh}, 0, 250));
  war.build();
  war.fly(60);
  ASSERT_NE(war.track_of(eagle, bogey), nullptr);
  const double seen_for = 60 - war.track_of(eagle, bogey)->first_time;
  EXPECT_GT(war.track_of(eagle, bogey)->hits, 0.85 * 2 * seen_for) << "two looks a second";
}

TEST(Watch, TakesNobodyForAnEnemyWhereAMateSaysHeIs) {
  AirWar war;
  war.models.visuals = {};
  war.models.visuals.add("alert", {.cued_search = 1e8});
  war.models.radars = {};
  war.models.radars.add("weak", {.reference_range = 1, .reference_rcs = 1e4});
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId mate = war.add(Side::blue, flying({9e3, 0, kHigh}, 0, 250));
  war.build();
  war.fly(2);

  // what is left of an enemy who was there: a stale track beside the mate
  const auto place = war.row(war.aircraft.kinematics, mate).position + Vec3{1500, 0, 0};
  Contact enemy{.position = place,
                .line = {1, 0, 0},
                .range = 10.5e3,
                .sigma_along = 500,
                .sigma_across = 500};
  Track stale = track::first_track(war.models.trackers[0], enemy, 2);
  stale.velocity = {250, 0, 0};
  stale.confirmed = 1;
  stale.identity = Identity::hostile;
  stale.id = TrackId{77};
  TrackFile& file = war.row(war.aircraft.tracks, eagle);
  file.tracks[file.count++] = stale;
  for (int second = 3; second < 20; ++second) {
    war.fly(second);
    const Track* enemies = find(war.row(war.aircraft.tracks, eagle), stale.id);
    EXPECT_TRUE(enemies == nullptr || enemies->seen_time < 0) << second;
  }
  EXPECT_EQ(find(war.row(war.aircraft.tracks, eagle), stale.id), nullptr) << "nobody fed it";
  const Track* friends = war.track_of(eagle, mate);
  ASSERT_NE(friends, nullptr);
  EXPECT_EQ(friends->identity, Identity::friendly) << "too far to be recognized";
}

}  // namespace
}  // namespace eyrie::model::sensor
