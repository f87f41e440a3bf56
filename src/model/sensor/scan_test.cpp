// SPDX-License-Identifier: MIT
// A radar that is jammed: what it still sees, and what it makes of the jamming.
#include <gtest/gtest.h>

#include <cmath>

#include "model/jamming.hpp"
#include "support/model/air_war.hpp"

namespace eyrie::model::sensor {
namespace {

using test::AirWar;
using test::flying;
using test::kHigh;
using test::kMile;

/// An eagle that looks north at a bogey `range` (m) ahead, which keeps its distance.
struct JammedWar : AirWar {
  PlayerId eagle, bogey;
  explicit JammedWar(double range, std::vector<PlayerId*> others = {}) {
    AircraftType jamming = models.aircraft[0];
    jamming.index.jammer = models.jammers.add("jammer", {.power = 1e3, .bandwidth = 500e6});
    models.aircraft.add("jammer", jamming);
    eagle = add(Side::blue, flying({0, 0, kHigh}, 0, 250));
    bogey = add(Side::red, flying({range, 0, kHigh}, 0, 250));
    for (PlayerId* other : others)
      *other = add(Side::red, flying({100 * kMile, 60 * kMile, kHigh}, 0, 250));
  }
  void give_jammer(PlayerId who) { row(aircraft.fit, who).type = 1; }
};

/// m, where the bogey is found as often as at the reference range without its jammer: tail on, 8
/// m^2.
double burns_through() {
  const Radar radar;
  return burn_through(radar.reference_range * std::pow(8 / radar.reference_rcs, 0.25),
                      jamming_to_noise(1e3 / 500e6, radar.beam_width, 1));
}

TEST(JammedRadar, SeesADirectionBeyondBurnThroughAndAnEchoInside) {
  for (const double share : {0.5, 6.0}) {
    JammedWar war(share * burns_through());
    war.build();
    war.give_jammer(war.bogey);
    war.fly(60);
    const Track* track = war.track_of(war.eagle, war.bogey);
    ASSERT_NE(track, nullptr) << share;
    const Kinematics &own = war.row(war.aircraft.kinematics, war.eagle),
                     &other = war.row(war.aircraft.kinematics, war.bogey);
    const Vec3 sight = position_at(*track, 60) - own.position;
    const double off =
        norm(cross(normalized(sight, {}), normalized(other.position - own.position, {})));
    EXPECT_LT(off, radians(1.5)) << share;
    EXPECT_EQ(track->confirmed, 1);
    if (share < 1)
      EXPECT_LT(track->position_sigma, 500) << "the radar has its range";
    else
      EXPECT_GT(track->position_sigma, 5e3) << "nobody knows how far it is";
  }
}

TEST(JammedRadar, LooksThroughItsSideLobesAtAJammerBesideTheTarget) {
  // 30 degrees aside, 117 nmi away: too far to be seen, and out of the main beam
  for (const bool jams : {false, true}) {
    PlayerId standoff;
    JammedWar war(75 * kMile, {&standoff});
    war.models.jammers.add("strong", {.power = 1e7, .bandwidth = 500e6});
    AircraftType strong = war.models.aircraft[0];
    strong.index.jammer = 1;
    war.models.aircraft.add("standoff", strong);
    war.build();
    if (jams)
      war.row(war.aircraft.fit, standoff).type = 2;
    war.fly(60);
    EXPECT_EQ(war.track_of(war.eagle, war.bogey) == nullptr, jams);
  }
}

TEST(JammedRadar, IsNotJammedByItsOwnSide) {
  JammedWar war(40 * kMile);
  war.build();
  war.give_jammer(war.eagle);
  war.give_jammer(war.bogey);
  war.row(war.aircraft.fit, war.bogey).side = Side::blue;
  war.fly(30);
  ASSERT_NE(war.track_of(war.eagle, war.bogey), nullptr);
  EXPECT_LT(war.track_of(war.eagle, war.bogey)->position_sigma, 2000);
}

TEST(JammedRadar, KeepsALockOnTheStrobe) {
  JammedWar war(30 * kMile);
  war.build();
  war.fly(20);
  ASSERT_NE(war.track_of(war.eagle, war.bogey), nullptr);
  Request& request = war.row(war.aircraft.request, war.eagle);
  request.target = war.track_of(war.eagle, war.bogey)->id;
  request.radar_lock = 1;
  war.fly(6);
  ASSERT_EQ(war.row(war.aircraft.radar, war.eagle).locked, war.bogey);
  const float before = war.track_of(war.eagle, war.bogey)->position_sigma;
  war.give_jammer(war.bogey);
  war.fly(20);
  EXPECT_EQ(war.row(war.aircraft.radar, war.eagle).mode, RadarMode::track);
  const Track* track = war.track_of(war.eagle, war.bogey);
  ASSERT_NE(track, nullptr) << "and the track goes on by its direction";
  EXPECT_EQ(track->id, request.target);
  EXPECT_GT(track->position_sigma, 2 * before) << "but its range is no longer measured";
}

TEST(Jammer, MayWaitUntilARadarTracksIt) {
  JammedWar war(20 * kMile);
  war.models.jammers = {};
  war.models.jammers.add("careful", {.power = 1e3, .bandwidth = 500e6, .when_tracked = true});
  war.build();
  war.give_jammer(war.bogey);
  war.fly(20);
  EXPECT_EQ(war.row(war.aircraft.emission, war.bogey).jamming, 0);
  ASSERT_NE(war.track_of(war.eagle, war.bogey), nullptr);
  war.row(war.aircraft.request, war.eagle).target = war.track_of(war.eagle, war.bogey)->id;
  war.row(war.aircraft.request, war.eagle).radar_lock = 1;
  war.fly(8);
  EXPECT_EQ(war.row(war.aircraft.emission, war.bogey).jamming, 1e3 / 500e6);
}

}  // namespace
}  // namespace eyrie::model::sensor
