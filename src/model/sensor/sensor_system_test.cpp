// SPDX-License-Identifier: MIT
#include "model/sensor/sensor_system.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/model/air_war.hpp"

namespace eyrie::model::sensor {
namespace {

using test::AirWar;
using test::flying;

using test::kHigh;
using test::kMile;

TEST(SensorSystem, FindsConfirmsAndIdentifiesWhoComesHeadOn) {
  AirWar war;
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({40 * kMile, 2000, kHigh}, kPi, 250));
  war.build();
  war.fly(30);
  const Track* track = war.track_of(eagle, bogey);
  ASSERT_NE(track, nullptr);
  EXPECT_EQ(track->confirmed, 1);
  EXPECT_EQ(track->identity, Identity::hostile);
  EXPECT_EQ(track->sources, kFromRadar);
  const Kinematics& truth = war.row(war.aircraft.kinematics, bogey);
  EXPECT_LT(norm(position_at(*track, 30) - truth.position),
            4 * static_cast<double>(track->position_sigma));
  EXPECT_NEAR(track->velocity.x, truth.velocity.x, 30);
  EXPECT_EQ(war.tracks(eagle).count, 1u);
  EXPECT_EQ(war.told(EventKind::contact, eagle, bogey), 1);
  EXPECT_EQ(war.told(EventKind::identified, eagle, bogey), 1);
}

TEST(SensorSystem, WarnsOfASearchRadarOnceAndOfALockOnceMore) {
  AirWar war;
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({40 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  war.fly(30);
  EXPECT_EQ(war.told(EventKind::rwr_warning, eagle, bogey), 1);
  const RwrState& rwr = war.row(war.aircraft.rwr, eagle);
  ASSERT_EQ(rwr.count, 1u);
  EXPECT_EQ(rwr.warnings[0].kind, EmissionKind::search);
  EXPECT_LT(std::fabs(rwr.warnings[0].bearing), radians(45));

  Request& request = war.row(war.aircraft.request, bogey);
  ASSERT_NE(war.track_of(bogey, eagle), nullptr);
  request.target = war.track_of(bogey, eagle)->id;
  request.radar_lock = 1;
  war.fly(5);
  EXPECT_EQ(war.row(war.aircraft.radar, bogey).mode, RadarMode::track);
  EXPECT_EQ(war.row(war.aircraft.radar, bogey).locked, eagle);
  EXPECT_EQ(war.row(war.aircraft.emission, bogey).dwell, eagle);
  EXPECT_EQ(war.told(EventKind::rwr_warning, eagle, bogey), 2);
  EXPECT_EQ(war.row(war.aircraft.rwr, eagle).warnings[0].kind, EmissionKind::track);
}

TEST(SensorSystem, ALockIsHeardWithinHalfABeamWidthOfItsMiddle) {
  AirWar war;
  const PlayerId eagle1 = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId eagle2 = war.add(Side::blue, flying({0, 1300, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({25 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  war.fly(12);
  Request& request = war.row(war.aircraft.request, bogey);
  request.target = war.track_of(bogey, eagle1)->id;
  request.radar_lock = 1;
  war.fly(3);
  ASSERT_EQ(war.row(war.aircraft.radar, bogey).locked, eagle1);
  EXPECT_EQ(war.row(war.aircraft.rwr, eagle1).warnings[0].kind, EmissionKind::track);
  // 1.9 degrees aside, of a beam of 3
  EXPECT_NE(war.row(war.aircraft.rwr, eagle2).warnings[0].kind, EmissionKind::track);
}

TEST(SensorSystem, ASearchIsHeardWhereItScansAndNotAbove) {
  AirWar war;
  const PlayerId level = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId low = war.add(Side::blue, flying({0, 9000, kHigh + 1500}, 0, 250));
  const PlayerId above = war.add(Side::blue, flying({0, 0, kHigh - 6000}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({30e3, 0, kHigh}, kPi, 250));
  war.build();
  war.fly(8);
  EXPECT_EQ(war.told(EventKind::rwr_warning, level, bogey), 1);
  EXPECT_EQ(war.told(EventKind::rwr_warning, low, bogey), 1);
  EXPECT_EQ(war.told(EventKind::rwr_warning, above, bogey), 0) << "11 degrees, of a scan of 5";
  EXPECT_EQ(war.track_of(bogey, above), nullptr);
}

TEST(SensorSystem, ALockSeesNobodyElseAndSeesItsTargetBetter) {
  AirWar war;
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId one = war.add(Side::red, flying({30 * kMile, 0, kHigh}, kPi, 250));
  const PlayerId two = war.add(Side::red, flying({30 * kMile, 9000, kHigh}, kPi, 250));
  war.build();
  war.fly(12);
  ASSERT_NE(war.track_of(eagle, one), nullptr);
  ASSERT_NE(war.track_of(eagle, two), nullptr);
  const float before = war.track_of(eagle, one)->position_sigma;
  Request& request = war.row(war.aircraft.request, eagle);
  request.target = war.track_of(eagle, one)->id;
  request.radar_lock = 1;
  war.fly(20);
  EXPECT_EQ(war.track_of(eagle, two), nullptr) << "nobody looked there";
  EXPECT_EQ(war.told(EventKind::track_lost, eagle, two), 1);
  ASSERT_NE(war.track_of(eagle, one), nullptr);
  EXPECT_EQ(war.track_of(eagle, one)->id, request.target);
  EXPECT_LT(war.track_of(eagle, one)->position_sigma, before / 3);

  request.radar_lock = 0;
  war.fly(8);
  EXPECT_NE(war.track_of(eagle, two), nullptr) << "searching again";
}

TEST(SensorSystem, ALockTakesTheDesignatedOneOfTwoNeighbours) {
  for (const int wanted : {0, 1}) {
    AirWar war;
    const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
    const PlayerId one = war.add(Side::red, flying({25 * kMile, 0, kHigh}, kPi, 250));
    const PlayerId two = war.add(Side::red, flying({25 * kMile, 2500, kHigh}, kPi, 250));
    war.build();
    war.fly(16);
    const PlayerId target = wanted == 0 ? one : two;
    ASSERT_NE(war.track_of(eagle, target), nullptr);
    war.row(war.aircraft.request, eagle).target = war.track_of(eagle, target)->id;
    war.row(war.aircraft.request, eagle).radar_lock = 1;
    war.fly(3);
    EXPECT_EQ(war.row(war.aircraft.radar, eagle).locked, target);
  }
}

TEST(SensorSystem, ALockEndsWhenTheTargetLeavesTheGimbal) {
  AirWar war;
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({20 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  war.fly(10);
  Request& request = war.row(war.aircraft.request, eagle);
  ASSERT_NE(war.track_of(eagle, bogey), nullptr);
  request.target = war.track_of(eagle, bogey)->id;
  request.radar_lock = 1;
  war.fly(2);
  ASSERT_EQ(war.row(war.aircraft.radar, eagle).locked, bogey);
  // a crank inside the gimbal keeps it, a turn beyond loses it
  Kinematics& k = war.row(war.aircraft.kinematics, eagle);
  k = flying(k.position, radians(50), 250);
  war.fly(5);
  EXPECT_EQ(war.row(war.aircraft.radar, eagle).locked, bogey);
  k = flying(k.position, radians(75), 250);
  war.fly(3);
  EXPECT_FALSE(war.row(war.aircraft.radar, eagle).locked);
  EXPECT_EQ(war.row(war.aircraft.radar, eagle).mode, RadarMode::search);
}

TEST(SensorSystem, ANarrowScanFollowsTheTargetThroughACrank) {
  const auto track_age = [](bool designate) {
    AirWar war;
    Radar narrow{.scan_half_azimuth = radians(30)};
    war.models.radars = {};
    war.models.radars.add("radar", narrow);
    const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
    const PlayerId bogey = war.add(Side::red, flying({30 * kMile, 0, kHigh}, kPi, 250));
    war.build();
    war.fly(8);
    EXPECT_NE(war.track_of(eagle, bogey), nullptr);
    if (designate)
      war.row(war.aircraft.request, eagle).target = war.track_of(eagle, bogey)->id;
    Kinematics& k = war.row(war.aircraft.kinematics, eagle);
    k = flying(k.position, radians(50), 250);
    war.fly(11);
    const Track* track = war.track_of(eagle, bogey);
    return track != nullptr ? 19 - track->time : 99;
  };
  EXPECT_LT(track_age(true), 5);
  EXPECT_GT(track_age(false), 9);
}

TEST(SensorSystem, LocksANearTargetWithoutBeingAskedIfTheRadarIsMadeSo) {
  AirWar war;
  war.models.radars = {};
  war.models.radars.add("radar", {.lock_range = 10 * kMile});
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({13 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  war.fly(6);
  ASSERT_NE(war.track_of(eagle, bogey), nullptr);
  war.row(war.aircraft.request, eagle).target = war.track_of(eagle, bogey)->id;
  EXPECT_EQ(war.row(war.aircraft.radar, eagle).mode, RadarMode::search);
  war.fly(8);
  EXPECT_EQ(war.row(war.aircraft.radar, eagle).mode, RadarMode::track);
}

TEST(SensorSystem, ASilentRadarNeitherSeesNorIsHeard) {
  AirWar war;
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({40 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  war.row(war.aircraft.request, bogey).radar_off = 1;
  war.fly(20);
  EXPECT_EQ(war.tracks(bogey).count, 0u);
  EXPECT_EQ(war.row(war.aircraft.rwr, eagle).count, 0u);
  EXPECT_NE(war.track_of(eagle, bogey), nullptr);
  EXPECT_EQ(war.row(war.aircraft.rwr, bogey).count, 1u);
}

TEST(SensorSystem, SeesFriendsOnRadarAndHearsThemAnswer) {
  AirWar war;
  war.models.datalinks = {};
  war.models.datalinks.add("silent", {.loss = 1});
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId ahead = war.add(Side::blue, flying({30 * kMile, 0, kHigh}, 0, 250));
  war.build();
  war.fly(10);
  ASSERT_NE(war.track_of(eagle, ahead), nullptr);
  EXPECT_EQ(war.track_of(eagle, ahead)->identity, Identity::friendly);
}

TEST(SensorSystem, RecognizesItsMatesFromTheDatalinkAlone) {
  AirWar war;
  war.models.iffs = {};
  war.models.iffs.add("none", {.range = 0});
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId ahead = war.add(Side::blue, flying({20 * kMile, 0, kHigh}, 0, 250));
  war.build();
  war.fly(15);
  ASSERT_NE(war.track_of(eagle, ahead), nullptr);
  EXPECT_EQ(war.track_of(eagle, ahead)->identity, Identity::friendly);
}

TEST(SensorSystem, SharesATrackThatOnlyTheMateCanSee) {
  AirWar war;
  const PlayerId eagle1 = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  // looks the other way, with the bogey behind it
  const PlayerId eagle2 = war.add(Side::blue, flying({0, 3000, kHigh}, kPi, 250));
  const PlayerId bogey = war.add(Side::red, flying({30 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  war.fly(12);
  ASSERT_NE(war.track_of(eagle1, bogey), nullptr);
  ASSERT_NE(war.track_of(eagle2, bogey), nullptr);
  EXPECT_EQ(war.track_of(eagle2, bogey)->sources, kFromDatalink);
  EXPECT_EQ(war.track_of(eagle2, bogey)->identity, Identity::hostile);

  war.row(war.aircraft.request, eagle1).target = war.track_of(eagle1, bogey)->id;
  war.fly(3);
  EXPECT_EQ(war.track_of(eagle2, bogey)->targeted_by, 0b01);
}

TEST(SensorSystem, BelievesAMateThatIsGoneLostAfterTheTimeoutOnly) {
  AirWar war;
  const PlayerId lead_id = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId wing = war.add(Side::blue, flying({0, 3000, kHigh}, 0, 250));
  war.build();
  war.fly(10);
  datalink::DatalinkState* state = &war.row(war.aircraft.datalink, wing);
  EXPECT_EQ(datalink::living_rank(*state), 2u);
  EXPECT_NEAR(
      norm(position_at(state->members[0], 10) - war.row(war.aircraft.kinematics, lead_id).position),
      0, 1);

  war.world->remove(war.aircraft.table, 0);
  war.world->compact();
  war.fly(4);
  state = &war.row(war.aircraft.datalink, wing);
  EXPECT_EQ(datalink::living_rank(*state), 2u) << "nobody has told it yet";
  war.fly(3);
  state = &war.row(war.aircraft.datalink, wing);
  EXPECT_EQ(datalink::living_rank(*state), 1u);
  EXPECT_EQ(lead(*state)->id, wing);
}

TEST(SensorSystem, GivesPrivilegedPlayersTheTruth) {
  AirWar war;
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250), true);
  const PlayerId mate = war.add(Side::blue, flying({0, 3000, kHigh}, 0, 250), true);
  const PlayerId behind = war.add(Side::red, flying({-100 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  war.fly(1);
  const TrackId name = war.track_of(eagle, behind)->id;
  war.fly(9);
  ASSERT_EQ(war.tracks(eagle).count, 2u);
  const Track* track = war.track_of(eagle, behind);
  EXPECT_EQ(track->id, name);
  EXPECT_EQ(track->identity, Identity::hostile);
  EXPECT_EQ(track->position_sigma, 0.0f);
  EXPECT_NEAR(norm(position_at(*track, 10) - war.row(war.aircraft.kinematics, behind).position), 0,
              1e-6);
  EXPECT_EQ(war.track_of(eagle, mate)->identity, Identity::friendly);
  EXPECT_EQ(war.told(EventKind::contact, eagle, behind), 1);

  war.world->remove(war.aircraft.table, 0);
  war.world->compact();
  war.fly(0.2);
  EXPECT_EQ(datalink::living_rank(war.row(war.aircraft.datalink, mate)), 1u) << "knows at once";
}

TEST(SensorSystem, KeepsTheEnemyInSightOfAPrivilegedPlayerInACrowd) {
  AirWar war;
  const PlayerId eagle = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250), true);
  for (int i = 1; i <= 20; ++i)
    war.add(Side::blue, flying({0, 100.0 * i, kHigh}, 0, 250));
  const PlayerId bogey = war.add(Side::red, flying({50 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  war.fly(1);
  EXPECT_EQ(war.tracks(eagle).count, kMaxTracks);
  ASSERT_NE(war.track_of(eagle, bogey), nullptr);
  EXPECT_EQ(war.track_of(eagle, bogey)->identity, Identity::hostile);
}

TEST(SensorSystem, TellsPrivilegedPlayersOfMissilesAimedAtThemOnly) {
  AirWar war;
  const PlayerId eagle1 = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250), true);
  const PlayerId eagle2 = war.add(Side::blue, flying({0, 3000, kHigh}, 0, 250), true);
  const PlayerId bogey = war.add(Side::red, flying({30 * kMile, 0, kHigh}, kPi, 250));
  war.build();
  const PlayerId missile = war.launch(bogey, Side::red, flying({20e3, 0, kHigh}, kPi, 800), eagle1);
  war.fly(1);
  const Threats& threats = war.row(war.aircraft.threats, eagle1);
  ASSERT_EQ(threats.count, 1u);
  EXPECT_EQ(threats.missiles[0].truth, missile);
  EXPECT_EQ(threats.missiles[0].closing, 1);
  EXPECT_NEAR(threats.missiles[0].range, 20e3 - 1050, 150);
  EXPECT_EQ(war.row(war.aircraft.threats, eagle2).count, 0u);

  // its seeker sweeps over both: the one that is not meant knows better than its receiver
  war.world->rows(war.missiles.emission)[0] = {.position = {20e3, 0, kHigh},
                                               .boresight = {-1, 0, 0},
                                               .cos_half_angle = 0.9,
                                               .figure = emission_figure(30e3, 5),
                                               .dwell = eagle1,
                                               .kind = EmissionKind::missile_seeker,
                                               .side = Side::red};
  war.fly(2);
  EXPECT_EQ(war.row(war.aircraft.rwr, eagle2).warnings[0].kind, EmissionKind::missile_seeker);
  EXPECT_EQ(war.told(EventKind::missile_warning, eagle2, missile), 0);
  EXPECT_EQ(war.told(EventKind::missile_warning, eagle1, missile), 1);
}

TEST(SensorSystem, MatesFindOutOnWhichOfThemASeekerRests) {
  AirWar war;
  const PlayerId eagle1 = war.add(Side::blue, flying({0, 0, kHigh}, 0, 250));
  const PlayerId eagle2 = war.add(Side::blue, flying({0, 500, kHigh}, 0, 250));
  war.build();
  const PlayerId missile = war.launch({}, Side::red, flying({14e3, 0, kHigh}, kPi, 950), eagle1);
  while (war.world->step() < 350) {  // 7 s; it is here in 4.7 s then
    const Vec3 from = war.world->rows(war.missiles.kinematics)[0].position;
    war.world->rows(war.missiles.emission)[0] = {
        .position = from,
        .boresight = normalized(war.row(war.aircraft.kinematics, eagle1).position - from, {}),
        .cos_half_angle = math::cos(radians(6)),
        .figure = emission_figure(14e3, 5),
        .kind = EmissionKind::missile_seeker,
        .side = Side::red};
    war.fly(0.02);
  }
  const InboundMissile mine = war.row(war.aircraft.threats, eagle1).missiles[0];
  const InboundMissile mates = war.row(war.aircraft.threats, eagle2).missiles[0];
  EXPECT_EQ(mine.emitter, missile);
  EXPECT_EQ(mates.emitter, missile);
  EXPECT_EQ(mine.at_mate, 0);
  EXPECT_GT(mates.at_mate, 5);
}

}  // namespace
}  // namespace eyrie::model::sensor
