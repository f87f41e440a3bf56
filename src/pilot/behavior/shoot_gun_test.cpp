// SPDX-License-Identifier: MIT
#include "pilot/behavior/shoot_gun.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

const std::string kGun = "{shoot_gun: {vote: 55, range: 900 m, tolerance: 2 deg}}";

/// Right behind a hostile, who flies on.
Desk astern(double range = 500) {
  Desk desk;
  desk.track({range, 0, 0}, 0, 250);
  return desk;
}

TEST(ShootGun, FiresWithTheNoseOnTheLeadPoint) {
  const Decided d = decide(kGun, astern());
  EXPECT_EQ(d.status, kRunning);
  EXPECT_EQ(d.action().trigger, true);
  EXPECT_EQ(d.action().target, TrackId{1});
  EXPECT_EQ(d.proposal.vote, 55);
}

TEST(ShootGun, FiresNoFartherThanItsRangeAndTheReachOfTheGun) {
  const std::string near = "{shoot_gun: {range: 400 m, tolerance: 2 deg}}";
  EXPECT_EQ(decide(near, astern(399)).status, kRunning);
  EXPECT_EQ(decide(near, astern(401)).status, kFailure);
  const double reach = library().guns[0].greatest_range;
  ASSERT_LT(reach, 900);
  EXPECT_EQ(decide(kGun, astern(reach - 1)).status, kRunning);
  EXPECT_EQ(decide(kGun, astern(reach + 1)).status, kFailure);
}

TEST(ShootGun, LeadsATargetThatCrosses) {
  Desk desk;
  desk.track({600, 0, 0}, kPi / 2, 150);  // to the right
  EXPECT_EQ(decide(kGun, desk).status, kFailure);
  // 600 m take the round 0.5 s or so relative to the shooter: 150 m/s make 7 to 9 degrees
  desk.own = model::test::flying(desk.own.position, 0.135, 250);
  EXPECT_EQ(decide("{shoot_gun: {tolerance: 4 deg}}", desk).status, kRunning);
}

TEST(ShootGun, HasNothingToShootWithoutRoundsOrGun) {
  Desk desk = astern();
  desk.gun.rounds = 0;
  EXPECT_EQ(decide(kGun, desk).status, kFailure);
}

TEST(ShootGun, FiresAtNobodyWhoIsOutOfSight) {
  Desk desk = astern();
  model::Track& he = desk.tracks.tracks[0];
  he.time -= 1.9;
  he.position -= 1.9 * he.velocity;  // believed where he was
  EXPECT_EQ(decide(kGun, desk).status, kRunning);
  he.time -= 0.2;
  he.position -= 0.2 * he.velocity;
  EXPECT_EQ(decide(kGun, desk).status, kFailure) << "a mate may be there by now";
}

TEST(ShootGun, FiresInBursts) {
  Pilot pilot("{shoot_gun: {burst: 1 s, pause: 0.5 s}}");
  Desk desk = astern();
  std::string told;
  for (int i = 0; i < 31; ++i) {
    told += *pilot.decide(desk).action().trigger ? '#' : '.';
    desk.time += 0.1;
    desk.tracks.tracks[0].time = desk.time;
  }
  EXPECT_EQ(told, "##########.....##########.....#");
}

TEST(ShootGun, HoldsFireWhileAMateIsInTheLine) {
  Desk desk = astern();
  desk.in_flight(2, 1);
  desk.datalink.members[1].position = desk.own.position + Vec3{300, 5, 0};
  EXPECT_EQ(decide(kGun, desk).status, kFailure);
  desk.datalink.members[1].position = desk.own.position + Vec3{300, 100, 0};
  EXPECT_EQ(decide(kGun, desk).status, kRunning);
}

TEST(ShootGun, HoldsFireWhileAFriendlyTrackIsInTheLine) {
  Desk desk = astern();
  desk.track({700, 10, 0}, 0, 250, model::Identity::friendly);
  EXPECT_EQ(decide(kGun, desk).status, kFailure);
}

RC_GTEST_PROP(ShootGun, NeverFiresAtAnybodyButAConfirmedHostile, ()) {
  Desk desk;
  const int count = *rc::gen::inRange(1, 6);
  for (int i = 0; i < count; ++i) {
    model::Track& t =
        desk.track({double(*rc::gen::inRange(100, 900)), double(*rc::gen::inRange(-5, 6)),
                    double(*rc::gen::inRange(-5, 6))},
                   0, 250);
    t.identity = static_cast<model::Identity>(*rc::gen::inRange(0, 3));
    t.confirmed = *rc::gen::inRange<std::uint8_t>(0, 2);
  }
  const Decided d = decide("{shoot_gun: {clear_cone: 0 rad, tolerance: 5 deg}}", desk);
  RC_CLASSIFY(d.status == kRunning, "fires");
  if (!d.action().trigger.value_or(false))
    return;
  const model::Track* track = model::find(desk.tracks, *d.action().target);
  RC_ASSERT(track != nullptr);
  RC_ASSERT(track->confirmed == 1);
  RC_ASSERT(track->identity == model::Identity::hostile);
}

}  // namespace
}  // namespace eyrie::pilot
