// SPDX-License-Identifier: MIT
#include "pilot/gunnery.hpp"

#include <gtest/gtest.h>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

TEST(GunSight, PointsAheadOfACrossingTarget) {
  Desk desk;
  desk.track({800, 0, 0}, kPi / 2, 200);  // to the right
  const State s = desk.state();
  const auto sight = s.gun_sight(s.seen[0]);
  ASSERT_TRUE(sight);
  const double bearing = bearing_of(sight->aim);
  // 200 m/s across over 0.7 s or so of flight, from 800 m, while the shooter closes at 250 m/s
  EXPECT_GT(bearing, 0.15);
  EXPECT_LT(bearing, 0.35);
  EXPECT_NEAR(sight->off_nose, angle_between(sight->aim, nose_of(s.own)), 1e-12);
  EXPECT_NEAR(sight->range, 800, 1e-9);
}

TEST(GunSight, PointsAtATargetThatFliesAheadButForTheDropOfTheRounds) {
  Desk desk;
  desk.track({600, 0, 0}, 0, 250);
  const State s = desk.state();
  const auto sight = s.gun_sight(s.seen[0]);
  ASSERT_TRUE(sight);
  EXPECT_NEAR(bearing_of(sight->aim), 0, 1e-9);
  EXPECT_GT(elevation_of(sight->aim), 1e-3);
  EXPECT_LT(elevation_of(sight->aim), 0.01);
}

TEST(GunSight, IsLedByItsWayWhileTheAutopilotClosesAnError) {
  Desk desk;
  desk.track({800, 0, 0}, 6 * kDegree, 250);
  const auto led = [&] {
    const State s = desk.state();
    const Sight& sight = *s.gun_sight(s.seen[0]);
    return angle_between(bearing_of(sight.aim), bearing_of(ahead_of_sight(s, s.seen[0], sight)));
  };
  const double aim_time = desk.state().airframe().autopilot.aim_time;
  const double across = 250 * std::sin(6 * kDegree);
  EXPECT_NEAR(led(), aim_time * across / 800, 1e-4);
  // who crosses faster than the nose can follow is led by what the wing gives
  desk.tracks.tracks[0].velocity = {0, -400, 0};
  EXPECT_NEAR(led(), -aim_time * 7 * model::kGravity / 250, 1e-3);
  // and who stands in the line of sight not at all
  desk.tracks.tracks[0].velocity = desk.own.velocity;
  EXPECT_NEAR(led(), 0, 1e-12);
}

TEST(FriendInLine, SeesMatesAndFriendlyTracks) {
  Desk desk;
  const auto in_line = [&](double range) {
    return friend_in_line(desk.state(),
                          {.direction = {1, 0, 0}, .to = range, .half_angle = radians(5)});
  };
  EXPECT_FALSE(in_line(5000));
  desk.track({2000, 100, 0}, 0, 250, model::Identity::friendly);
  EXPECT_TRUE(in_line(5000));
  EXPECT_FALSE(in_line(1900)) << "behind the target";
  desk.tracks.tracks[0].position.y += 200;
  EXPECT_FALSE(in_line(5000)) << "beside the line";
  desk.tracks.tracks[0] = {};
  desk.tracks.count = 0;
  desk.in_flight(2, 2);
  desk.datalink.members[0].position = desk.own.position + Vec3{1500, 0, 50};
  EXPECT_TRUE(in_line(5000));
  desk.lose(1);
  EXPECT_FALSE(in_line(5000));
}

TEST(FriendInLine, CountsNeitherHostilesNorTheOwnship) {
  Desk desk;
  desk.in_flight(1, 1);
  desk.track({2000, 0, 0});
  EXPECT_FALSE(
      friend_in_line(desk.state(), {.direction = {1, 0, 0}, .to = 5000, .half_angle = radians(5)}));
  EXPECT_FALSE(friend_near(desk.state(), {2000, 0, 0}, 1000));
}

TEST(FriendInLine, BeginsWhereItIsTold) {
  Desk desk;
  desk.track({2000, 0, 0}, 0, 250, model::Identity::friendly);
  const auto in_line = [&](double from) {
    return friend_in_line(
        desk.state(), {.direction = {1, 0, 0}, .from = from, .to = 5000, .half_angle = radians(5)});
  };
  EXPECT_TRUE(in_line(1900));
  EXPECT_FALSE(in_line(2100));
}

TEST(FriendNear, SeesMatesAndFriendlyTracksAroundAPlace) {
  Desk desk;
  desk.track({2000, 0, 0}, 0, 250, model::Identity::friendly);
  EXPECT_TRUE(friend_near(desk.state(), {2000, 900, 0}, 1000));
  EXPECT_FALSE(friend_near(desk.state(), {2000, 1100, 0}, 1000));
  desk.in_flight(2, 2);
  desk.datalink.members[0].position = desk.own.position + Vec3{8000, 0, 0};
  EXPECT_TRUE(friend_near(desk.state(), {8000, 0, 900}, 1000));
  desk.lose(1);
  EXPECT_FALSE(friend_near(desk.state(), {8000, 0, 900}, 1000));
}

TEST(TimeOfFlight, IsLongerForATargetThatRuns) {
  Desk desk;
  desk.track({20e3, 0, 0}, kPi, 250);
  desk.track({20e3, 0, 0}, 0, 250);
  const State s = desk.state();
  const model::MissileType& missile = library().missiles[kMedium];
  const double head_on = time_of_flight(s, s.seen[0], missile);
  const double tail = time_of_flight(s, s.seen[1], missile);
  EXPECT_GT(tail, 1.5 * head_on);
  // 20 km at 250 m/s, half the speed gain and 250 m/s of the target
  EXPECT_NEAR(head_on, 20e3 / (500 + missile.motor.ideal_speed_gain() / 2), 1e-9);
  EXPECT_GT(head_on, 15);
  EXPECT_LT(head_on, 30);
  EXPECT_LE(tail, missile.greatest_time);
  // all three are carried along
  desk.models = &windy_library();
  desk.own.velocity.x += 60;
  for (model::Track& track : std::span(desk.tracks.tracks).first(2))
    track.velocity.x += 60;
  const State carried = desk.state();
  EXPECT_NEAR(time_of_flight(carried, carried.seen[0], missile), head_on, 1e-9);
  EXPECT_NEAR(time_of_flight(carried, carried.seen[1], missile), tail, 1e-9);
}

TEST(FPole, IsTheRangeLessWhatBothFly) {
  Desk desk;
  desk.track({30e3, 0, 0}, kPi, 200);
  const State s = desk.state();
  const model::MissileType& missile = library().missiles[kMedium];
  const double time = time_of_flight(s, s.seen[0], missile);
  EXPECT_NEAR(f_pole(s, s.seen[0], missile), 30e3 - 450 * time, 1e-6);
}

}  // namespace
}  // namespace eyrie::pilot
