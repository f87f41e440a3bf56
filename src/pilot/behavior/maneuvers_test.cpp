// SPDX-License-Identifier: MIT
#include "pilot/behavior/maneuvers.hpp"

#include <gtest/gtest.h>

#include "pilot/gunnery.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

double heading_of(const Decided& d) {
  return angle_between(0, *d.action().heading);
}

TEST(Maneuvers, NeedATarget) {
  const Desk desk;
  for (const char* one :
       {"lead_pursuit", "pure_pursuit", "lag_pursuit", "high_yo_yo", "low_yo_yo", "merge_turn",
        "extend", "reacquire", "jink", "avoid_collision", "snapshot"})
    EXPECT_EQ(decide(one, desk).status, kFailure) << one;
}

TEST(PursuitCurves, PointAheadAtAndBehind) {
  Desk desk;
  desk.track({3000, 0, 0}, kPi / 2, 200);  // crosses to the right
  const Decided lead = decide("lead_pursuit", desk), pure = decide("pure_pursuit", desk),
                lag = decide("{lag_pursuit: {lag: 3 s}}", desk);
  EXPECT_NEAR(std::sin(heading_of(lead)), 200.0 / 250, 1e-9);  // where the paths meet
  EXPECT_NEAR(heading_of(pure), 0, 1e-9);
  EXPECT_NEAR(heading_of(lag), -std::atan2(600, 3000), 1e-9);  // 3 s of his way behind him
  for (const Decided& d : {lead, pure, lag}) {
    EXPECT_EQ(d.status, kRunning);
    EXPECT_EQ(d.action().mode, model::AutopilotMode::aim);
    EXPECT_EQ(d.action().target, TrackId{1});
  }
}

TEST(PursuitCurves, PointUpAndDown) {
  Desk desk;
  desk.track({1000, 0, -1000}, 0, 250);
  EXPECT_NEAR(*decide("pure_pursuit", desk).action().climb, kPi / 4, 1e-9);
}

TEST(LeadPursuit, AimsTheGunWhenNearAndPaysForTheLastDegrees) {
  Desk desk;
  desk.track({800, 0, 0}, 20 * kDegree, 240);
  const State s = desk.state();
  const auto sight = s.gun_sight(s.seen[0]);
  ASSERT_TRUE(sight.has_value());
  desk.own.speed = 150;  // slow: the energy would not allow it
  const Decided d = decide("{lead_pursuit: {gun_range: 1 km, cash_in: 40 deg}}", desk);
  EXPECT_NEAR(*d.action().load_factor, 9, 1e-9);
  EXPECT_LT(*decide("{lead_pursuit: {gun_range: 1 km, cash_in: 0 deg}}", desk).action().load_factor,
            4);
}

TEST(Snapshot, WaitsForWhomTheNoseCannotFollowAndFiresAsHePasses) {
  Desk desk;
  model::Track& he = desk.track({500, -400, 0}, kPi / 2, 300);  // crosses to the right
  Pilot pilot("{snapshot: {wait: 1 s, ahead: 0.2 s}}");
  const model::GunType& gun = desk.state().library.guns[0];
  double first = -1, last = -1, passed = -1;
  for (int i = 0; i < 60; ++i) {
    const double time = desk.time;
    const State now = desk.state();
    const double off = now.gun_sight(now.seen[0])->off_nose;
    const Decided d = pilot.decide(desk);
    if (d.status == kRunning && d.action().trigger.value_or(false)) {
      first = first < 0 ? time : first;
      last = time;
    }
    if (off < gun.aim_cone && passed < 0)
      passed = time;
    desk.time += 0.02;
    he.position += 0.02 * (he.velocity - desk.own.velocity);  // seen from an ownship that stays
    he.time = desk.time;
  }
  ASSERT_GT(passed, 0);
  EXPECT_GT(first, passed - 0.25) << "not long before";
  EXPECT_LE(first, passed - 0.1);
  EXPECT_GE(last, passed);
  EXPECT_LT(last, passed + 0.25);
}

TEST(Snapshot, LeavesASteadyTargetAlone) {
  Desk desk;
  desk.track({500, 0, 0}, 0, 240);
  EXPECT_EQ(decide("snapshot", desk).status, kFailure) << "shoot_gun can follow him";
  desk.tracks.tracks[0].velocity = {0, 300, 0};
  EXPECT_EQ(decide("snapshot", desk).status, kFailure) << "he has passed already";
  desk.tracks.tracks[0].position = desk.own.position + Vec3{500, -300, 0};
  EXPECT_EQ(decide("snapshot", desk).status, kRunning);
  EXPECT_EQ(decide("{snapshot: {within: 400 m}}", desk).status, kFailure);
  EXPECT_EQ(decide("{snapshot: {max_age: 1 s}}", desk).status, kRunning);
  desk.tracks.tracks[0].time -= 1.1;
  desk.tracks.tracks[0].position -= 1.1 * desk.tracks.tracks[0].velocity;  // still seems to pass
  EXPECT_EQ(decide("{snapshot: {max_age: 1 s}}", desk).status, kFailure) << "out of sight";
  EXPECT_EQ(decide("snapshot", desk).status, kRunning);
  desk.gun.rounds = 0;
  EXPECT_EQ(decide("snapshot", desk).status, kFailure);
}

TEST(HighYoYo, GoesAboveWhomItWouldPass) {
  Desk desk;
  desk.own = model::test::flying(desk.own.position, 0, 300);
  desk.track({800, 300, 0}, 50 * kDegree, 200);  // turns away to the right, slower
  const Decided d = decide("{high_yo_yo: {angle: 35 deg}}", desk);
  ASSERT_EQ(d.status, kRunning);
  EXPECT_NEAR(*d.action().climb, 35 * kDegree, 1e-9);
  // behind where he is: the heading stays inside of pure pursuit's
  EXPECT_LT(heading_of(d), bearing_of({800, 300, 0}));
  EXPECT_EQ(decide("{high_yo_yo: {closing: 200 m/s}}", desk).status, kFailure);
  EXPECT_EQ(decide("{high_yo_yo: {crossing: 60 deg}}", desk).status, kFailure);
  EXPECT_EQ(decide("{high_yo_yo: {within: 500 m}}", desk).status, kFailure);
  desk.tracks.tracks[0].velocity = {-200, 0, 0};  // he comes head-on: a pass is no overshoot
  EXPECT_EQ(decide("high_yo_yo", desk).status, kFailure);
}

TEST(LowYoYo, CutsInsideBelow) {
  Desk desk;
  desk.own = model::test::flying(desk.own.position, 0, 200);
  desk.track({700, 700, 0}, 60 * kDegree, 240);  // ahead to the right, faster
  const Decided d = decide("{low_yo_yo: {angle: 20 deg}}", desk);
  ASSERT_EQ(d.status, kRunning);
  EXPECT_NEAR(*d.action().climb, -20 * kDegree, 1e-9);
  EXPECT_GT(heading_of(d), kPi / 4) << "inside: ahead of him";
  EXPECT_EQ(decide("{low_yo_yo: {off_nose: 50 deg}}", desk).status, kFailure);
  desk.own = model::test::flying(desk.own.position, 0, 400);
  EXPECT_EQ(decide("low_yo_yo", desk).status, kFailure) << "closes fast enough";
}

TEST(MergeTurn, TurnsTowardsHimOnTwoCirclesAndAwayOnOne) {
  for (const double side : {-1.0, 1.0}) {
    Desk desk;  // he has just passed, on that side
    desk.track({-500, side * 200, 0}, kPi, 250);
    const auto turn = [&](const char* circle) {
      return heading_of(decide(std::string("{merge_turn: {circle: ") + circle + "}}", desk));
    };
    EXPECT_NEAR(turn("two"), side * kPi / 2, 1e-6);
    EXPECT_NEAR(turn("one"), -side * kPi / 2, 1e-6);
    EXPECT_NEAR(turn("best"), -side * kPi / 2, 1e-6) << "below corner speed: the small circle";
    desk.own = model::test::flying(desk.own.position, 0, 300);
    EXPECT_NEAR(turn("best"), side * kPi / 2, 1e-6);
  }
}

TEST(MergeTurn, KeepsItsSideUntilHeIsBeforeTheWings) {
  Desk desk;
  model::Track& he = desk.track({-500, 200, 0}, kPi, 250);
  Pilot pilot("{merge_turn: {circle: two}}");
  EXPECT_GT(heading_of(pilot.decide(desk)), 0);
  he.position = desk.own.position + Vec3{-500, -200, 0};  // has crossed behind
  EXPECT_GT(heading_of(pilot.decide(desk)), 0) << "no reversal";
  he.position = desk.own.position + Vec3{500, -200, 0};
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  he.position = desk.own.position + Vec3{-500, -200, 0};
  EXPECT_LT(heading_of(pilot.decide(desk)), 0) << "the next pass is another choice";
}

TEST(MergeTurn, TurnsNoseHighWithSpeedAndNoseLowWithout) {
  for (const double speed : {220.0, 340.0}) {
    Desk desk;
    desk.own = model::test::flying(desk.own.position, 0, speed);
    desk.track({-500, 200, 0}, kPi, 250);
    const double climb = *decide("merge_turn", desk).action().climb;
    EXPECT_NEAR(climb, speed > 280 ? kPi / 4 : -kPi / 4, 0.03) << speed;
  }
}

TEST(Reacquire, TurnsToWhereALostTargetMustBe) {
  Desk desk;
  desk.track({0, 3000, 0}, 0, 200);
  Pilot pilot("{reacquire: {memory: 10 s, extrapolated: 5 s}}");
  EXPECT_EQ(pilot.decide(desk).status, kFailure) << "he is known";
  desk.tracks.count = 0;
  desk.time += 3;
  EXPECT_NEAR(heading_of(pilot.decide(desk)), std::atan2(3000, 600), 1e-9);
  desk.time += 6;
  EXPECT_NEAR(heading_of(pilot.decide(desk)), std::atan2(3000, 1000), 1e-9);
  desk.time += 1.5;
  EXPECT_EQ(pilot.decide(desk).status, kFailure) << "long ago";
}

TEST(Reacquire, LooksForWhoTracksIfToldTo) {
  Desk desk;
  desk.rwr.count = 1;
  desk.rwr.warnings[0] = {.bearing = 2.5, .kind = model::EmissionKind::track};
  EXPECT_EQ(decide("reacquire", desk).status, kFailure);
  EXPECT_NEAR(heading_of(decide("{reacquire: {radar: true}}", desk)), 2.5, 1e-9);
  desk.rwr.warnings[0].kind = model::EmissionKind::search;
  EXPECT_EQ(decide("{reacquire: {radar: true}}", desk).status, kFailure) << "he looks at everybody";
  desk.rwr.warnings[0].kind = model::EmissionKind::track;
  desk.track({0, 3000, 0}, 0, 200);
  EXPECT_EQ(decide("{reacquire: {radar: true}}", desk).status, kFailure) << "the target is known";
}

TEST(Reacquire, CountsFromWhenTheTargetWasSensedLast) {
  Desk desk;
  desk.track({0, 3000, 0}, 0, 200);
  Pilot pilot("{reacquire: {memory: 20 s, extrapolated: 5 s}}");
  for (int second = 0; second < 12; ++second, desk.time += 1)  // nobody tells of him any more
    EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.tracks.count = 0;
  EXPECT_NEAR(heading_of(pilot.decide(desk)), std::atan2(3000, 1000), 1e-9);
  desk.time += 8.5;
  EXPECT_EQ(pilot.decide(desk).status, kFailure) << "20 s ago";
}

TEST(Jink, LeavesThePlaneOfAGunBehindOneWayAndTheOther) {
  Desk desk;
  desk.track({-600, 0, 0}, 0, 250);  // right behind, his nose here
  Pilot pilot("{jink: {period: 2 s}}");
  const Decided first = pilot.decide(desk);
  ASSERT_EQ(first.status, kRunning);
  EXPECT_NEAR(std::fabs(heading_of(first)), kPi / 2, 0.01) << "across his line of fire";
  EXPECT_NEAR(std::fabs(*first.action().climb), kPi / 4, 0.01);
  desk.time += 2.1;
  EXPECT_NEAR(*pilot.decide(desk).action().climb, -*first.action().climb, 1e-6);
  desk.tracks.tracks[0].velocity = {0, 250, 0};
  EXPECT_EQ(pilot.decide(desk).status, kFailure) << "his nose is elsewhere";
}

TEST(Extend, RunsAwayUnloaded) {
  Desk desk;
  desk.track({-3000, 100, 0}, 0, 250);
  const Decided d = decide("{extend: {dive: 10 deg}}", desk);
  EXPECT_NEAR(heading_of(d), -std::atan2(100, 3000), 1e-9);
  EXPECT_NEAR(*d.action().climb, -10 * kDegree, 1e-9);
  EXPECT_EQ(*d.action().load_factor, 1);
  desk.tracks.tracks[0].position = desk.own.position + Vec3{3000, 0, 0};
  EXPECT_GT(*decide("extend", desk).action().load_factor, 1) << "first it turns";
}

TEST(AvoidCollision, TurnsAwayFromWhereTheOtherWillPass) {
  Desk desk;
  desk.track({1000, 30, 0}, kPi, 250, model::Identity::friendly);  // head-on, a little right
  const Decided d = decide("{avoid_collision: {miss: 150 m, warning: 4 s}}", desk);
  ASSERT_EQ(d.status, kRunning);
  EXPECT_LT(heading_of(d), 0) << "to the left";
  desk.tracks.tracks[0].position.y = 0;
  EXPECT_GT(heading_of(decide("{avoid_collision: {miss: 150 m, warning: 4 s}}", desk)), 0)
      << "straight on: both to the right";
  desk.tracks.tracks[0].position.y = 200;
  EXPECT_EQ(decide("{avoid_collision: {miss: 150 m}}", desk).status, kFailure);
  desk.tracks.tracks[0].position = desk.own.position + Vec3{3000, 0, 0};
  EXPECT_EQ(decide("{avoid_collision: {warning: 4 s}}", desk).status, kFailure) << "6 s away";
}

TEST(AvoidCollision, TurnsBackOnlyWhenNobodyHasComeTooNearForAWhile) {
  Desk desk;
  desk.track({1000, 30, 0}, kPi, 250);
  Pilot pilot("{avoid_collision: {miss: 150 m, recovery: 1.5 s}}");
  const double away = *pilot.decide(desk).action().heading;
  desk.tracks = {};
  desk.own.heading = 0.2;  // it has begun to turn
  for (const double later : {0.1, 0.7, 1.4}) {
    desk.time = 100 + later;
    const Decided d = pilot.decide(desk);
    ASSERT_EQ(d.status, kRunning) << later;
    EXPECT_EQ(*d.action().heading, away) << later;
  }
  desk.time = 101.6;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.time = 100.5;
  EXPECT_EQ(pilot.decide(desk).status, kFailure) << "it is over, not asleep";
}

TEST(AvoidCollision, KnowsTheMatesByDatalink) {
  Desk desk;
  desk.in_flight(2, 1);
  desk.datalink.members[1].position = desk.own.position + Vec3{0, 60, 0};
  EXPECT_EQ(decide("{avoid_collision: {miss: 100 m}}", desk).status, kRunning);
}

TEST(AvoidCollision, BelievesAMateMoreThanAGlanceAtHim) {
  Desk desk;
  desk.in_flight(2, 1);
  desk.datalink.members[1].position = desk.own.position + Vec3{0, 1900, 0};
  // the eye has him at two thirds of the range and coming
  model::Track& seen = desk.track({0, 1260, 0}, -kPi / 2, 320, model::Identity::friendly);
  seen.velocity.x = 250;
  seen.position_sigma = 250;
  EXPECT_EQ(decide("{avoid_collision: {warning: 6 s, miss: 900 m}}", desk).status, kFailure);
  desk.lose(2);
  EXPECT_EQ(decide("{avoid_collision: {warning: 6 s, miss: 900 m}}", desk).status, kRunning);
}

TEST(AvoidCollision, SeesWhoComesBehindAMateWhoIsNear) {
  Desk desk;
  const std::string tree = "{avoid_collision: {miss: 300 m, warning: 6 s}}";
  desk.track({200, 60, 0}, 0, 250, model::Identity::friendly);  // flies the same way
  EXPECT_LT(heading_of(decide(tree, desk)), 0) << "away from him";
  desk.track({2000, -60, 0}, kPi, 250);  // head-on, a little left
  EXPECT_GT(heading_of(decide(tree, desk)), 0) << "away from who comes";
  desk.tracks.tracks[1].position = desk.own.position + Vec3{-2000, -60, 0};  // and is past
  EXPECT_LT(heading_of(decide(tree, desk)), 0);
}

TEST(AvoidCollision, TurnsAwayFromWhereAMateAbreastIs) {
  const std::string tree = "{avoid_collision: {miss: 300 m, warning: 6 s}}";
  Desk desk;
  model::Track& mate = desk.track({0, 250, 0}, 0, 250, model::Identity::friendly);
  for (const double closing : {-5, 5, 30, 60, 120}) {  // in 50 s to 2 s, and a mate who leaves
    for (const double ahead : {-60.0, 0.0, 60.0}) {    // and passes behind, or before
      mate.velocity = {250 + ahead, -closing, 0};
      EXPECT_LT(heading_of(decide(tree, desk)), 0) << closing << " m/s, " << ahead;
      mate.position = desk.own.position + Vec3{0, -250, 0};
      mate.velocity.y = closing;
      EXPECT_GT(heading_of(decide(tree, desk)), 0) << closing << " m/s, " << ahead;
      mate.position = desk.own.position + Vec3{0, 250, 0};
    }
  }
}

TEST(AvoidCollision, TurnsGentlyFromWhoComesNoNearerUntilHeIsSomewhatFartherAway) {
  Pilot pilot("{avoid_collision: {miss: 300 m, warning: 6 s, recovery: 0 s}}");
  Desk desk;
  model::Track& mate = desk.track({0, 310, 0}, 0, 250, model::Identity::friendly);
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  for (const double range : {290, 100, 350}) {
    mate.position = desk.own.position + Vec3{0, range, 0};
    EXPECT_NEAR(heading_of(pilot.decide(desk)), -std::atan(1 - range / 360), 1e-9) << range;
  }
  mate.position = desk.own.position + Vec3{0, 370, 0};
  desk.time += 0.1;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
}

TEST(AvoidCollision, TurnsTheOtherWayThanWhoComesFromBehind) {
  Desk desk;
  desk.track({-200, 0, 0}, 0, 350, model::Identity::friendly);
  EXPECT_LT(heading_of(decide("{avoid_collision: {miss: 300 m}}", desk)), 0)
      << "he sees me ahead and turns right";
}

}  // namespace
}  // namespace eyrie::pilot
