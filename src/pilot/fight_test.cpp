// SPDX-License-Identifier: MIT
#include "pilot/fight.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

TEST(Fight, TellsWhoIsBehindWhom) {
  Desk desk;  // heads north
  desk.track({2000, 0, 0}, 0);
  desk.track({2000, 0, 0}, kPi);
  desk.track({-2000, 0, 0}, 0);
  desk.track({0, 2000, 0}, kPi / 2);
  const State s = desk.state();
  const auto is = [&](std::size_t i, double off_nose, double off_tail, double crossing) {
    const Angles a = s.angles(s.seen[i]);
    EXPECT_NEAR(a.off_nose, off_nose * kDegree, 1e-9) << i;
    EXPECT_NEAR(a.off_tail, off_tail * kDegree, 1e-9) << i;
    EXPECT_NEAR(a.crossing, crossing * kDegree, 1e-9) << i;
  };
  is(0, 0, 0, 0);      // right behind him
  is(1, 0, 180, 180);  // he comes head-on
  is(2, 180, 180, 0);  // he is right behind
  is(3, 90, 0, 90);    // abeam, and he leaves
}

TEST(Fight, TellsWhoIsBehindWhomByTheMotionThroughTheAir) {
  Desk desk;
  desk.models = &windy_library();
  desk.own.velocity.x += 60;
  desk.own.heading = kPi / 2;
  desk.track({0, 2000, 0}, kPi / 2).velocity.x += 60;  // drifts as the own aircraft does
  const State s = desk.state();
  EXPECT_NEAR(s.angles(s.seen[0]).crossing, 0, 1e-9);
  EXPECT_NEAR(s.angles(s.seen[0]).off_tail, 0, 1e-9);
}

TEST(Fight, PullsWhatTheEnergyAllows) {
  Desk desk;  // 4 g sustained, 7 g available, corner speed 280 m/s
  const double slowest = 180;
  const auto load = [&](double speed, double most) {
    desk.own.speed = speed;
    return load_for_energy(desk.state(), slowest, most);
  };
  EXPECT_NEAR(load(300, 9), 7, 1e-6);
  EXPECT_NEAR(load(280, 9), 7, 1e-6);
  EXPECT_NEAR(load(230, 9), 5.5, 1e-6) << "half way";
  EXPECT_NEAR(load(180, 9), 4, 1e-6) << "what holds the speed";
  EXPECT_NEAR(load(162, 9), 2, 1e-6) << "lets it come back";
  EXPECT_NEAR(load(100, 9), 2, 1e-6);
  EXPECT_NEAR(load(300, 3), 3, 1e-6);
  desk.own.speed = 162;
  EXPECT_EQ(load_for_energy(desk.state(), 0, 9), 9) << "whatever it costs";
}

TEST(Fight, PutsSpeedIntoHeightAndTakesItBack) {
  Desk desk;
  const auto slope = [&](double speed, double altitude) {
    desk.own.speed = speed;
    desk.own.altitude = altitude;
    return slope_for_energy(desk.state(), 1000);
  };
  EXPECT_NEAR(slope(280, 8000), 0, 1e-6);
  EXPECT_NEAR(slope(280 * 1.1, 8000), kPi / 8, 1e-6);
  EXPECT_NEAR(slope(280 * 1.5, 8000), kPi / 4, 1e-6);
  EXPECT_NEAR(slope(280 * 0.9, 8000), -kPi / 8, 1e-6);
  EXPECT_EQ(slope(200, 1000), 0) << "no height left to take";
}

RC_GTEST_PROP(Fight, RaisesADirectionByTheAngle, ()) {
  const auto number = [] { return *rc::gen::inRange(-100, 100) / 10.0; };
  const Vec3 direction{number() + 0.05, number(), number()};
  const double elevation = elevation_of(direction);
  const double angle = *rc::gen::inRange(-80, 81) * kDegree;
  RC_PRE(std::fabs(elevation + angle) < 89 * kDegree);
  const Vec3 up = raised(direction, angle);
  RC_ASSERT(std::fabs(norm(up) - 1) < 1e-12);
  RC_ASSERT(std::fabs(elevation_of(up) - (elevation + angle)) < 1e-9);
  RC_ASSERT(std::fabs(angle_between(bearing_of(direction), bearing_of(up))) < 1e-9);
}

TEST(Fight, DivesNoSteeperThanItCanPullOutOf) {
  Desk desk;
  desk.flying.energy.available = 6.25F;  // of which it counts on four fifths
  Action action;
  const auto climb = [&](double altitude) {
    desk.own.altitude = altitude;
    aim(desk.state(), {1, 0, 1}, {5, 7, 250, 1000}, action);
    return *action.climb;
  };
  EXPECT_NEAR(climb(8000), -45 * kDegree, 1e-9);
  EXPECT_EQ(action.mode, model::AutopilotMode::aim);
  EXPECT_EQ(climb(1000), 0);
  EXPECT_NEAR(climb(990), 10.0 / (5 * 250), 1e-9) << "from below it climbs back";
  // the arc of a pull-out at 4 g more than level costs V2 (1 - cos c) / 4 g of height
  const double radius = 250.0 * 250.0 / (4 * model::kGravity);
  EXPECT_NEAR(climb(1000 + radius * (1 - std::cos(20 * kDegree))), -20 * kDegree, 1e-9);
}

}  // namespace
}  // namespace eyrie::pilot
