// SPDX-License-Identifier: MIT
#include "pilot/behavior/release_weapon.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;
using model::weapon::ZoneRange;

const std::string kRelease = "{release_weapon: {vote: 60, zone: 1.4, patience: 8 s}}";

/// A hostile ahead, coming closer, at a share of a range of the medium missile's zone.
Desk at_share(double share, ZoneRange of = ZoneRange::r_ne) {
  Desk desk;
  desk.track({60e3, 0, 0});
  double range = 60e3;
  for (int i = 0; i < 20; ++i) {  // the zone hardly depends on the range: this converges at once
    const State s = desk.state();
    const model::weapon::EmploymentZone zone = s.zone(kMedium, s.seen[0]);
    range = zone.range_at(share, of);
    desk.tracks.tracks[0].position = desk.own.position + Vec3{range, 0, 0};
  }
  return desk;
}

TEST(ReleaseWeapon, ShootsInsideTheZone) {
  const Desk desk = at_share(1.35);
  const Decided d = decide(kRelease, desk);
  ASSERT_EQ(d.status, kRunning);
  EXPECT_EQ(d.action().release, (Release{TrackId{1}, kMedium}));
  EXPECT_EQ(d.action().target, TrackId{1});
  EXPECT_EQ(d.proposal.vote, 60);
  EXPECT_FALSE(d.action().heading.has_value());
}

TEST(ReleaseWeapon, ShootsAtAShareOfTheRangeThatItIsTold) {
  for (const auto& [of, range] : names_of(ZoneRange{})) {
    const std::string release = "{release_weapon: {zone: 0.9, of: " + std::string(of) + "}}";
    EXPECT_EQ(decide(release, at_share(0.88, range)).status, kRunning) << of;
    EXPECT_EQ(decide(release, at_share(0.92, range)).status, kFailure) << of;
  }
}

TEST(ReleaseWeapon, ShootsNoEarlierThanItsParameterSays) {
  EXPECT_EQ(decide(kRelease, at_share(1.45)).status, kFailure);
  EXPECT_EQ(decide("{release_weapon: {zone: 2}}", at_share(1.95)).status, kRunning);
  EXPECT_EQ(decide("{release_weapon: {zone: 1.5}}", at_share(1.45)).status, kRunning);
  EXPECT_EQ(decide("{release_weapon: {zone: 1.5}}", at_share(1.55)).status, kFailure);
  EXPECT_EQ(decide("{release_weapon: {zone: 1}}", at_share(1.05)).status, kFailure);
  EXPECT_EQ(decide("{release_weapon: {zone: 1}}", at_share(0.95)).status, kRunning);
  EXPECT_EQ(decide("{release_weapon: {zone: 0.8}}", at_share(0.85)).status, kFailure);
  EXPECT_EQ(decide("{release_weapon: {zone: 0.8}}", at_share(0.75)).status, kRunning);
}

TEST(ReleaseWeapon, TakesTheMissileWithTheShortestReachThatWillDo) {
  Desk desk;
  desk.track({3000, 0, 0}, 0, 250);  // close astern of him
  const Decided d = decide(kRelease, desk);
  ASSERT_EQ(d.status, kRunning);
  EXPECT_EQ(d.action().release->store, kShort);
}

TEST(ReleaseWeapon, DoesNotShootInsideTheLeastRange) {
  Desk desk;
  desk.track({150, 0, 0});
  EXPECT_EQ(decide("{release_weapon: {zone: 2}}", desk).status, kFailure);
}

TEST(ReleaseWeapon, NeedsTheTargetNearTheNose) {
  Desk desk = at_share(0.7);
  desk.own = model::test::flying(desk.own.position, 0.6, 250);
  EXPECT_EQ(decide("{release_weapon: {off_boresight: 0.7 rad}}", desk).status, kRunning);
  EXPECT_EQ(decide("{release_weapon: {off_boresight: 0.5 rad}}", desk).status, kFailure);
}

TEST(ReleaseWeapon, NeedsAFreshTrack) {
  Desk desk = at_share(1.2);
  desk.tracks.tracks[0].time -= 5;
  EXPECT_EQ(decide("{release_weapon: {max_age: 6 s}}", desk).status, kRunning);
  EXPECT_EQ(decide("{release_weapon: {max_age: 4 s}}", desk).status, kFailure);
}

TEST(ReleaseWeapon, FailsWithoutMissiles) {
  Desk desk = at_share(1.2);
  desk.stores = {};
  EXPECT_EQ(decide(kRelease, desk).status, kFailure);
}

TEST(ReleaseWeapon, WaitsWhileAReleaseIsUnderWay) {
  Desk desk = at_share(1.2);
  model::weapon::begin_release(desk.stores, kMedium, library().missiles[kMedium], TrackId{1},
                               desk.time);
  EXPECT_EQ(decide("{release_weapon: {ripple: 4}}", desk).status, kFailure);
}

TEST(ReleaseWeapon, ShootsFastEnoughWhereTheTargetCanEscape) {
  const std::string fast = "{release_weapon: {zone: 2, least_mach: 0.85}}";
  Desk desk = at_share(1.6);
  desk.own.mach = 0.84;
  const Decided slow = decide(fast, desk);
  EXPECT_EQ(slow.status, kFailure);
  desk.own.mach = 0.86;
  EXPECT_EQ(decide(fast, desk).status, kRunning);
  desk = at_share(0.9);
  desk.own.mach = 0.5;
  EXPECT_EQ(decide(fast, desk).status, kRunning) << "it can not escape";
}

TEST(ReleaseWeapon, KeepsItsFPole) {
  const Desk desk = at_share(1.6);
  const State s = desk.state();
  const double pole = f_pole(s, s.seen[0], library().missiles[kMedium]);
  EXPECT_GT(pole, 0);
  EXPECT_LT(pole, s.seen[0].range);
  const auto at = [](double f_pole) {
    return "{release_weapon: {zone: 2, least_f_pole: " + std::to_string(f_pole) + " m}}";
  };
  EXPECT_EQ(decide(at(pole - 1), desk).status, kRunning);
  EXPECT_EQ(decide(at(pole + 1), desk).status, kFailure);
  EXPECT_EQ(decide(at(50e3), at_share(0.9)).status, kRunning) << "it can not escape";
}

TEST(ReleaseWeapon, LetsItsMissilesArriveBeforeTheNextOne) {
  Desk desk = at_share(1.2);
  desk.agent.shots[0] = {
      .since = desk.time - 5, .until = desk.time + 10, .track = TrackId{1}, .store = kMedium};
  EXPECT_EQ(decide("{release_weapon: {ripple: 1}}", desk).status, kFailure);
  EXPECT_EQ(decide("{release_weapon: {ripple: 2, ripple_interval: 4 s}}", desk).status, kRunning);
  EXPECT_EQ(decide("{release_weapon: {ripple: 2, ripple_interval: 6 s}}", desk).status, kFailure);
}

TEST(ReleaseWeapon, LooksWhatItsMissileDidBeforeTheNextOne) {
  Desk desk = at_share(1.2);
  desk.agent.shots[0] = {.until = desk.time, .track = TrackId{1}, .store = kMedium};
  const std::string look = "{release_weapon: {assess: 4 s}}";
  // who is dead is not seen again
  desk.time += 2.9;
  EXPECT_EQ(decide(look, desk).status, kFailure);
  desk.time += 1;
  desk.tracks.tracks[0].time = desk.tracks.tracks[0].sensed_time = desk.time;
  EXPECT_EQ(decide(look, desk).status, kFailure) << "a look 3.9 s later may be of before the hit";
  desk.time += 0.1;
  desk.tracks.tracks[0].time = desk.time;
  EXPECT_EQ(decide(look, desk).status, kFailure) << "a mate may have carried the track on";
  desk.tracks.tracks[0].sensed_time = desk.time;
  EXPECT_EQ(decide(look, desk).status, kRunning);
}

TEST(ReleaseWeapon, LooksWhatAMatesMissileDid) {
  Desk desk = at_share(1.2);
  desk.in_flight(4, 2);
  Pilot pilot("{release_weapon: {assess: 4 s}}");
  desk.tracks.tracks[0].shot_by = 1U << 3;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.tracks.tracks[0].shot_by = 0;
  for (const double wait : {3.9, 0.1}) {
    desk.time += wait;
    desk.tracks.tracks[0].time = desk.tracks.tracks[0].sensed_time = desk.time;
    for (model::Mate& mate : desk.datalink.members)
      mate.time = desk.time;
    EXPECT_EQ(pilot.decide(desk).status, wait < 1 ? kRunning : kFailure);
  }
}

TEST(ReleaseWeapon, ShootsAtASecondTargetWhileTheFirstMissileFlies) {
  Desk desk = at_share(1.2);
  desk.agent.shots[0] = {.until = desk.time + 10, .track = TrackId{77}, .store = kMedium};
  EXPECT_EQ(decide("{release_weapon: {ripple: 1}}", desk).status, kRunning);
}

TEST(ReleaseWeapon, HoldsFireWhileAMatesMissileIsOnItsWay) {
  Desk desk = at_share(1.3);
  desk.in_flight(4, 2);
  desk.tracks.tracks[0].shot_by = 1U << 3;
  EXPECT_EQ(decide(kRelease, desk).status, kFailure);
  EXPECT_EQ(decide("{release_weapon: {one_shooter: false}}", desk).status, kRunning);
  EXPECT_EQ(decide("{release_weapon: {flight_ripple: 2}}", desk).status, kRunning);
  desk.lose(4);
  EXPECT_EQ(decide(kRelease, desk).status, kRunning);
}

TEST(ReleaseWeapon, LeavesTheFirstShotToANearerMateForAWhile) {
  Desk desk = at_share(1.3);
  desk.in_flight(2, 2);
  desk.datalink.members[0].position = desk.own.position + Vec3{4000, 5000, 0};
  desk.tracks.tracks[0].targeted_by = 1;
  Pilot pilot(kRelease);
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  for (const double wait : {7.9, 0.1}) {
    desk.time += wait;
    desk.tracks.tracks[0].time = desk.datalink.members[0].time = desk.time;
    EXPECT_EQ(pilot.decide(desk).status, wait < 1 ? kRunning : kFailure);
  }
}

TEST(ReleaseWeapon, GoesFirstIfItIsNearer) {
  Desk desk = at_share(1.3);
  desk.in_flight(2, 2);
  desk.datalink.members[0].position = desk.own.position - Vec3{5000, 0, 0};
  desk.tracks.tracks[0].targeted_by = 1;
  EXPECT_EQ(decide(kRelease, desk).status, kRunning);
}

TEST(ReleaseWeapon, DoesNotShootAHeatSeekerPastAFriend) {
  Desk desk;
  desk.track({3000, 0, 0}, 0, 250);
  desk.stores.stations[0] = desk.stores.stations[1] = {};  // short-range missiles only
  desk.in_flight(2, 1);
  desk.datalink.members[1].position = desk.own.position + Vec3{1500, 50, 0};
  EXPECT_EQ(decide(kRelease, desk).status, kFailure);
  desk.datalink.members[1].position = desk.own.position + Vec3{1500, 1500, 0};
  EXPECT_EQ(decide(kRelease, desk).status, kRunning);
}

TEST(ReleaseWeapon, DoesNotSendAMissileWhereNobodyKnowsTheTarget) {
  Desk desk = at_share(1.2);
  desk.tracks.tracks[0].position_sigma = 900;
  EXPECT_EQ(decide("{release_weapon: {max_error: 1000 m}}", desk).status, kRunning);
  EXPECT_EQ(decide("{release_weapon: {max_error: 800 m}}", desk).status, kFailure);
}

/// The friend flies with the target, so that only the place of now counts.
Desk friend_at(double share, const Vec3& from_target) {
  Desk desk = at_share(share);
  const model::Track& target = desk.tracks.tracks[0];
  desk.in_flight(2, 1);
  model::Mate& mate = desk.datalink.members[1];
  mate.position = target.position + from_target;
  mate.velocity = {float(target.velocity.x), float(target.velocity.y), float(target.velocity.z)};
  return desk;
}

TEST(ReleaseWeapon, ShootsPastNoMateWhoIsCloseBeforeTheNose) {
  const char* far = "{release_weapon: {zone: 1, clear_turn: 0}}";
  for (const double off : {35.0, 55.0}) {
    Desk desk = friend_at(0.2, {0, 50e3, 0});
    desk.in_flight(2, 1);
    desk.datalink.members[1].position =
        desk.own.position + 800.0 * Vec3{std::cos(off * kDegree), std::sin(off * kDegree), 0};
    EXPECT_EQ(decide(far, desk).status, off < 45 ? kFailure : kRunning) << off;
  }
}

TEST(ReleaseWeapon, LeavesATargetAloneWhileAFriendIsBesideIt) {
  const char* far = "{release_weapon: {clear_radius: 1 nmi, clear_cone: 0, clear_turn: 0}}";
  const char* near = "{release_weapon: {clear_radius: 1400 m, clear_cone: 0, clear_turn: 0}}";
  EXPECT_EQ(decide(far, friend_at(0.2, {0, 1500, 0})).status, kFailure);
  EXPECT_EQ(decide(near, friend_at(0.2, {0, 1500, 0})).status, kRunning);
  EXPECT_EQ(decide(far, friend_at(0.2, {0, 1900, 0})).status, kRunning);
}

TEST(ReleaseWeapon, KeepsAwayFromFriendsByTheErrorOfTheTrackToo) {
  Desk desk = friend_at(0.2, {0, 2500, 0});
  const char* release = "{release_weapon: {clear_radius: 1 nmi, clear_cone: 0, clear_turn: 0}}";
  EXPECT_EQ(decide(release, desk).status, kRunning);
  desk.tracks.tracks[0].position_sigma = 400;
  EXPECT_EQ(decide(release, desk).status, kFailure);
}

TEST(ReleaseWeapon, MindsAFriendWhereTheActiveSeekerWillLook) {
  const std::string release = "{release_weapon: {zone: 2, clear_turn: 1}}";
  Desk desk = at_share(1.9);
  const double range = desk.tracks.tracks[0].position.x;
  const double switches_on = library().missiles[kMedium].seeker.activation_range;
  ASSERT_GT(range, switches_on + 15e3);
  desk.in_flight(2, 1);
  model::Mate& mate = desk.datalink.members[1];
  EXPECT_EQ(decide(release, desk).status, kRunning) << "abreast: the missile leaves him behind";
  mate.position = desk.own.position + Vec3{0.4 * range, 300, 0};
  EXPECT_EQ(decide(release, desk).status, kFailure) << "he flies where the seeker will look";
  mate.position = desk.own.position + Vec3{4000, 300, 0};
  EXPECT_EQ(decide(release, desk).status, kRunning) << "it passes him blind";
  mate.position = desk.own.position + Vec3{0.4 * range, 16e3, 0};
  EXPECT_EQ(decide(release, desk).status, kRunning) << "he stays beside the cone";
  mate.position = desk.own.position + Vec3{0.6 * range, 16e3, 0};
  mate.velocity = {0, -400, 0};
  EXPECT_EQ(decide(release, desk).status, kFailure) << "he will be in it then";
}

/// Ahead and mostly in reach; any identity, confirmed or not.
void any_track(Desk& desk) {
  model::Track& t = desk.track({*rc::gen::inRange(2, 30) * 1e3, *rc::gen::inRange(-9, 10) * 1e3,
                                *rc::gen::inRange(-2, 3) * 1e3},
                               *rc::gen::inRange(0, 628) / 100.0);
  t.identity = static_cast<model::Identity>(*rc::gen::inRange(0, 3));
  t.confirmed = *rc::gen::inRange<std::uint8_t>(0, 2);
  t.targeted_by = *rc::gen::arbitrary<std::uint8_t>();
}

RC_GTEST_PROP(ReleaseWeapon, NeverShootsAtAnybodyButAConfirmedHostile, ()) {
  Desk desk;
  for (int i = *rc::gen::inRange(1, 10); i > 0; --i)
    any_track(desk);
  desk.agent.target = TrackId{*rc::gen::inRange(0U, 10U)};
  const Decided d = decide("{release_weapon: {zone: 2, off_boresight: 3 rad}}", desk);
  RC_CLASSIFY(d.status == kRunning, "shoots");
  if (!d.action().release)
    return;
  const model::Track* track = model::find(desk.tracks, d.action().release->track);
  RC_ASSERT(track != nullptr);
  RC_ASSERT(track->confirmed == 1);
  RC_ASSERT(track->identity == model::Identity::hostile);
}

}  // namespace
}  // namespace eyrie::pilot
