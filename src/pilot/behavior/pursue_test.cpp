// SPDX-License-Identifier: MIT
#include "pilot/behavior/pursue.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "pilot/gunnery.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

TEST(Pursue, FailsWithoutAHostile) {
  Desk desk;
  EXPECT_EQ(decide("pursue", desk).status, kFailure);
  desk.track({30e3, 0, 0}, kPi, 250, model::Identity::unknown);
  desk.track({30e3, 0, 0}, kPi, 250, model::Identity::friendly);
  EXPECT_EQ(decide("pursue", desk).status, kFailure);
}

TEST(Pursue, FliesTheCollisionCourse) {
  Desk desk;
  desk.track({30e3, 0, 0}, kPi / 2, 200);  // crosses to the right
  const Decided d = decide("{pursue: {vote: 40, mode: intercept, speed: 290 m/s}}", desk);
  EXPECT_EQ(d.status, kRunning);
  EXPECT_NEAR(std::sin(*d.action().heading), 200.0 / 250.0, 1e-9);  // equal way to the east
  EXPECT_EQ(d.action().speed, 290);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::hold);
  EXPECT_EQ(d.action().target, TrackId{1});
  EXPECT_EQ(d.proposal.vote, 40);
}

TEST(Pursue, KeepsANearTargetWhereAMissileMayLeave) {
  const std::string tree = "{pursue: {mode: intercept, near_lead: 20 deg, level_range: 8 km}}";
  for (const double side : {-1.0, 1.0}) {
    Desk desk;
    desk.track({9e3, 0, 0}, side * kPi / 2, 200);
    const double course = std::asin(200.0 / 250.0);
    EXPECT_NEAR(angle_between(0, *decide(tree, desk).action().heading), side * course, 0.01);
    desk.tracks.tracks[0].position.x = 7e3;
    EXPECT_NEAR(angle_between(0, *decide(tree, desk).action().heading), side * 20 * kDegree, 1e-9);
    desk.stores = {};
    EXPECT_NEAR(angle_between(0, *decide(tree, desk).action().heading), side * course, 0.01)
        << "with the gun alone it goes there first";
  }
}

TEST(Pursue, GoesStraightAtATargetThatItCannotCatch) {
  Desk desk;
  desk.track({20e3, 20e3, 0}, kPi / 2, 600);
  EXPECT_NEAR(*decide("pursue", desk).action().heading, kPi / 4, 1e-9);
}

TEST(Pursue, KeepsItsAltitudeUntilTheTargetIsNear) {
  Desk desk;
  desk.track({30e3, 0, 3000});
  const std::string tree = "{pursue: {altitude: 9000 m, level_range: 20 km}}";
  EXPECT_EQ(*decide(tree, desk).action().altitude, 9000);
  desk.tracks.tracks[0].position.x = 19e3;
  EXPECT_NEAR(*decide(tree, desk).action().altitude, 5000, 50);
}

TEST(Pursue, FollowsNobodyIntoTheGround) {
  Desk desk;
  desk.track({5000, 0, 7900});
  EXPECT_EQ(*decide("{pursue: {floor: 600 m}}", desk).action().altitude, 600);
}

TEST(Pursue, HandsAFollowedTargetToTheAutopilot) {
  Desk desk;
  desk.track({9000, 0, 0}, 0, 240).time -= 2;
  const Decided d = decide("{pursue: {mode: follow, behind: 2 km}}", desk);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::follow);
  ASSERT_TRUE(d.action().follow.has_value());
  EXPECT_NEAR(d.action().follow->position.x, 9000 + 2 * 240, 1e-6);
  EXPECT_EQ(d.action().follow->offset, (Vec3{-2000, 0, 0}));
  EXPECT_EQ(d.action().follow->time, desk.time);
}

TEST(Pursue, FollowsWhoStandsFromWhereItIs) {
  for (const double east : {-9000.0, 9000.0})
    for (const double zero : {0.0, -0.0}) {
      Desk desk;
      desk.track({9000, east, 0}).velocity = {zero, zero, zero};
      const double heading = *decide("{pursue: {mode: follow}}", desk).action().heading;
      EXPECT_NEAR(angle_between(0, heading), std::copysign(kPi / 4, east), 0.01);
    }
}

TEST(Pursue, CranksToTheSideOfItsNoseWhileItsMissileFlies) {
  for (const double side : {-1.0, 1.0}) {
    Desk desk;
    desk.own = model::test::flying(desk.own.position, side * 0.1, 250);
    desk.track({30e3, 0, 0});
    const std::string tree = "{pursue: {crank: 50 deg}}";
    EXPECT_NEAR(angle_between(0, *decide(tree, desk).action().heading), 0, 1e-6);
    desk.agent.shots[2] = {.until = desk.time + 5, .track = TrackId{1}, .store = kMedium};
    EXPECT_NEAR(angle_between(0, *decide(tree, desk).action().heading), side * 50 * kDegree, 1e-9);
    desk.time += 5;
    EXPECT_NEAR(angle_between(0, *decide(tree, desk).action().heading), 0, 1e-6);
  }
}

TEST(Pursue, AimsTheGunWhenItIsNear) {
  Desk desk;
  desk.track({800, 0, -100}, kPi / 2, 200);
  const State s = desk.state();
  const auto sight = s.gun_sight(s.seen[0]);
  ASSERT_TRUE(sight.has_value());
  const Decided d = decide("{pursue: {mode: lead, gun_range: 1 km}}", desk);
  EXPECT_NEAR(*d.action().heading, bearing_of(ahead_of_sight(s, s.seen[0], *sight)), 1e-12);
  EXPECT_GT(*d.action().altitude, 8000);
  // without a gun in reach it is an intercept
  EXPECT_EQ(decide("{pursue: {mode: lead, gun_range: 500 m}}", desk).action().heading,
            decide("{pursue: {mode: intercept}}", desk).action().heading);
}

TEST(Pursue, KeepsItsOvertakeAndItsDistanceFromMatesWhileItAimsTheGun) {
  Desk desk;
  desk.track({800, 100, 0}, 0, 200);
  const std::string tree = "{pursue: {mode: lead, speed: 300 m/s, overtake: 30 m/s}}";
  const Decided aims = decide(tree, desk);
  EXPECT_EQ(aims.action().mode, model::AutopilotMode::aim);
  EXPECT_NEAR(*aims.action().speed, 230, 1e-9);
  desk.in_flight(2, 2);
  desk.datalink.members[0].position = desk.own.position + Vec3{50, 0, 20};
  const Decided clears = decide(tree, desk);
  EXPECT_EQ(clears.action().mode, model::AutopilotMode::hold);
  EXPECT_GT(*clears.action().altitude, desk.own.altitude + si(400, "ft"));
}

TEST(Pursue, SlowsDownBehindASlowTargetIfToldTo) {
  Desk desk;
  desk.track({3000, 0, 0}, 0, 200);
  EXPECT_EQ(*decide("{pursue: {speed: 300 m/s}}", desk).action().speed, 300);
  EXPECT_NEAR(*decide("{pursue: {speed: 300 m/s, overtake: 30 m/s}}", desk).action().speed, 230,
              1e-9);
  desk.models = &windy_library();  // from behind: he flies 200 m/s over the ground, 140 in the air
  EXPECT_NEAR(*decide("{pursue: {speed: 250 m/s, overtake: 30 m/s}}", desk).action().speed, 170,
              1e-9);
}

TEST(Pursue, StaysClearOfAMateOfABetterRank) {
  Desk desk;
  desk.track({20e3, 0, 0});
  desk.in_flight(2, 2);
  const std::string tree = "{pursue: {separation: 200 m}}";
  const double alone = *decide(tree, desk).action().altitude;
  desk.datalink.members[0].position = desk.own.position + Vec3{50, 0, 20};  // just below
  EXPECT_NEAR(*decide(tree, desk).action().altitude, alone + 200, 1e-9);
  desk.datalink.members[0].position = desk.own.position + Vec3{50, 0, -20};
  EXPECT_NEAR(*decide(tree, desk).action().altitude, alone - 200, 1e-9);
}

TEST(Pursue, RollsOutInsteadOfTurningBackForAnErrorOfTheTrack) {
  Desk desk;
  desk.track({60e3, 0, 0}, 0, 100);
  desk.command.mode = model::AutopilotMode::hold;
  const auto heading = [&](double commanded, double own) {
    desk.command.heading = commanded * kDegree;
    desk.own.heading = own * kDegree;
    return wrap_pi(*decide("{pursue: {dead_band: 10 deg}}", desk).action().heading) / kDegree;
  };
  EXPECT_NEAR(heading(8, 2), 8, 1e-9) << "north, but for what is no reason to turn";
  EXPECT_NEAR(heading(20, 5), 5, 1e-9) << "the turn to the right is ended, none to the left begun";
  EXPECT_NEAR(heading(40, 25), 0, 1e-9);
}

RC_GTEST_PROP(Pursue, MeetsATargetThatKeepsItsCourse, ()) {
  Desk desk;
  desk.track({double(*rc::gen::inRange(-50, 51)) * 1000 + 500,
              double(*rc::gen::inRange(-50, 51)) * 1000, 0},
             *rc::gen::inRange(0, 628) / 100.0, 200);
  const State state = desk.state();
  const Seen& seen = state.seen[0];
  const double heading =
      *decide("{pursue: {dead_band: 0, near_lead: 90 deg}}", desk).action().heading;
  const auto time = time_to_meet(seen.ned, state.velocity_of(seen), 250);
  RC_ASSERT(time.has_value());  // it is the faster one
  const Vec3 there = *time * 250 * Vec3{std::cos(heading), std::sin(heading), 0};
  RC_ASSERT(norm(there - (seen.ned + *time * state.velocity_of(seen))) < 1e-6 * (1 + norm(there)));
}

TEST(Pursue, LeadsATargetAsFarAsItsVelocityIsKnown) {
  Desk desk;
  desk.track({40e3, 0, 0}, kPi / 2, 200);  // crosses to the right
  const double known = *decide("pursue", desk).action().heading;
  EXPECT_NEAR(std::sin(known), 200.0 / 250, 1e-3);
  desk.tracks.tracks[0].velocity_sigma = 31.25;  // an eighth of the own speed
  EXPECT_NEAR(std::sin(*decide("pursue", desk).action().heading), 100.0 / 250, 1e-3);
  desk.tracks.tracks[0].velocity_sigma = 1000;
  EXPECT_NEAR(*decide("pursue", desk).action().heading, 0, 0.01);
}

}  // namespace
}  // namespace eyrie::pilot
