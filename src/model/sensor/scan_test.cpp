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

TEST(JammedRadar, ShowsNobodyBeyondItsScale) {
  for (const double scale : {20.0, 60.0}) {
    JammedWar war(47 * kMile);
    Radar radar = war.models.radars[0];
    radar.instrumented_range = scale * kMile;
    war.models.radars = {};
    war.models.radars.add("radar", radar);
    war.build();
    war.give_jammer(war.bogey);
    war.fly(60);
    EXPECT_EQ(war.track_of(war.eagle, war.bogey) != nullptr, scale > 47) << scale;
  }
}

TEST(JammedRadar, HearsTheLoudestOfMoreThanItCanTellApart) {
  // the one that matters is born before 40 faint ones, or behind them
  for (const bool last : {false, true}) {
    std::vector<PlayerId> ids(41);
    std::vector<PlayerId*> others;
    for (PlayerId& id : ids)
      others.push_back(&id);
    JammedWar war(75 * kMile, others);
    AircraftType faint = war.models.aircraft[0], strong = faint;
    faint.index.jammer = war.models.jammers.add("faint", {.power = 1e-6, .bandwidth = 500e6});
    strong.index.jammer = war.models.jammers.add("strong", {.power = 1e7, .bandwidth = 500e6});
    war.models.aircraft.add("faint", faint);
    war.models.aircraft.add("strong", strong);
    war.build();
    for (const PlayerId id : ids)
      war.row(war.aircraft.fit, id).type = id == (last ? ids.back() : ids.front()) ? 3 : 2;
    war.fly(60);
    EXPECT_EQ(war.track_of(war.eagle, war.bogey), nullptr) << last;
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

/// An eagle that has locked a bogey 20 nmi ahead, whose repeater pulls from 28 s to 36 s.
struct PulledWar : JammedWar {
  explicit PulledWar(const PullOff& pull) : JammedWar(20 * kMile) {
    models.jammers = {};
    models.jammers.add("deceiver", {.pull_off = pull});
    build();
    give_jammer(bogey);
    fly(20);
    lock_anew();
  }
  RadarState& radar() { return row(aircraft.radar, eagle); }
  /// The latest of the bogey.
  const Track& latest() {
    const Track* found = track_of(eagle, bogey);
    for (const Track& track : tracks(eagle).tracks)
      if (track.truth == bogey && track.sensed_time > found->sensed_time)
        found = &track;
    return *found;
  }
  void lock_anew() {
    row(aircraft.request, eagle).target = latest().id;
    row(aircraft.request, eagle).radar_lock = 1;
  }
  /// m beyond the bogey, and m/s faster away than it, that the latest track is.
  std::pair<double, double> pulled() {
    const Kinematics& other = row(aircraft.kinematics, bogey);
    return {latest().position.x + (time() - latest().time) * latest().velocity.x - other.position.x,
            latest().velocity.x - other.velocity.x};
  }
  double time() { return static_cast<double>(world->step()) * 0.02; }
};
constexpr PullOff kPull{.acceleration = 20, .walk_time = 8, .pause_time = 20};

TEST(PulledRadar, FollowsTheFalseEchoLosesTheLockWhenThatStopsAndAcquiresAnew) {
  PulledWar war(kPull);
  war.fly(7.9);
  ASSERT_EQ(war.radar().locked, war.bogey);
  EXPECT_EQ(war.radar().pulled, 0);
  EXPECT_NEAR(war.pulled().first, 0, 100);
  war.fly(8);
  EXPECT_EQ(war.radar().locked, war.bogey) << "as it believes";
  EXPECT_NEAR(war.radar().pulled, 7.9, 0.2);
  EXPECT_NEAR(war.pulled().first, 20 * 7.9 * 7.9 / 2, 60);
  EXPECT_NEAR(war.pulled().second, 20 * 7.9, 20);
  war.fly(3);
  EXPECT_EQ(war.radar().mode, RadarMode::search) << "its memory is 2 s";
  war.fly(4);
  war.lock_anew();
  war.fly(2);
  EXPECT_EQ(war.radar().mode, RadarMode::track);
  EXPECT_EQ(war.radar().locked, war.bogey);
  EXPECT_EQ(war.radar().pulled, 0);
  EXPECT_NEAR(war.pulled().first, 0, 100);
}

TEST(PulledRadar, RestsOnTheEchoOfATargetThatOutshinesItsRepeater) {
  for (const double gain : {50.0, 52.0}) {  // 7.2 and 11.3 m^2; the tail has 8
    PullOff pull = kPull;
    pull.gain = gain;
    PulledWar war(pull);
    war.fly(15.9);
    EXPECT_EQ(war.radar().pulled > 0, gain > 51) << gain;
    war.fly(3);
    EXPECT_EQ(war.radar().mode == RadarMode::track, gain < 51) << gain;
  }
}

TEST(PulledRadar, RestsOnTheEchoIfThatIsPulledFasterThanItsGatesCanFollow) {
  // from one look to the next 0.2 s: a filter of 3 m/s and 9 g, so 103 m/s^2
  for (const double acceleration : {95.0, 110.0}) {
    PullOff pull = kPull;
    pull.acceleration = acceleration;
    PulledWar war(pull);
    war.fly(15.9);
    EXPECT_EQ(war.radar().pulled > 7, acceleration < 100) << acceleration;
  }
}

TEST(PulledRadar, IsNotPulledByItsOwnSide) {
  PulledWar war(kPull);
  war.row(war.aircraft.fit, war.bogey).side = Side::blue;
  war.fly(15.9);
  EXPECT_EQ(war.radar().pulled, 0);
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
