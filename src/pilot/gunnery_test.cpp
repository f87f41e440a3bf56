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

}  // namespace
}  // namespace eyrie::pilot
