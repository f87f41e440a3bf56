// SPDX-License-Identifier: MIT
#include "model/weapon/engagement.hpp"

#include <gtest/gtest.h>

#include "core/angle.hpp"
#include "model/weapon/flyout.hpp"
#include "support/model/missiles.hpp"

namespace eyrie::model::weapon {
namespace {

using test::kAtmosphere;
using test::kDown;
using test::medium_range;

LaunchSituation shooting_level(double altitude, double aspect) {
  return {.shooter_altitude = altitude,
          .target_altitude = altitude,
          .shooter_speed = 300,
          .target_speed = 300,
          .aspect = aspect};
}

TEST(Engagement, HitsATargetThatKeepsItsCourse) {
  for (const double aspect : {0.0, 0.5, 1.2, 2.0, kPi}) {
    const EngagementResult r =
        engage(medium_range(), kAtmosphere,
               {.situation = shooting_level(8000, aspect), .range = 10e3, .longest_step = 0.02});
    EXPECT_LT(r.miss, 1) << aspect;
    EXPECT_TRUE(r.success(medium_range())) << aspect;
  }
}

TEST(Engagement, HitsATargetThatTurnsAwayFromCloseBy) {
  const EngagementResult r =
      engage(medium_range(), kAtmosphere,
             {.situation = shooting_level(8000, 0.3), .range = 12e3, .escape = Escape::run});
  EXPECT_TRUE(r.success(medium_range()));
}

/// m, the longest range at which a target is reached that runs when the missile is so near.
double reach(double warned) {
  Engagement e{.situation = shooting_level(9000, 0), .escape = Escape::run, .warned = warned};
  e.situation.shooter_speed = e.situation.target_speed = 270;
  double good = 5e3, bad = 100e3;
  while (bad > 1.01 * good) {
    e.range = std::sqrt(good * bad);
    (engage(medium_range(), kAtmosphere, e).success(medium_range()) ? good : bad) = e.range;
  }
  return good;
}

TEST(Engagement, ReachesFartherWhoIsWarnedLater) {
  const double at_launch = reach(1e9), by_seeker = reach(14e3), late = reach(8e3);
  // who turns away when he hears the seeker: why a shot from 1.4 times r_ne is half lost
  EXPECT_GT(by_seeker, 1.15 * at_launch);
  EXPECT_LT(by_seeker, 1.6 * at_launch);
  EXPECT_GT(late, 1.03 * by_seeker);
  EXPECT_LT(late, 0.8 * reach(0)) << "who never hears of it is reached at r_max";
}

TEST(Engagement, FailsOutOfReach) {
  const EngagementResult r =
      engage(medium_range(), kAtmosphere, {.situation = shooting_level(8000, kPi), .range = 60e3});
  EXPECT_FALSE(r.success(medium_range()));
}

TEST(Engagement, FailsBeforeTheWarheadIsArmed) {
  const EngagementResult r =
      engage(medium_range(), kAtmosphere, {.situation = shooting_level(8000, 0), .range = 400});
  EXPECT_FALSE(r.armed);
  EXPECT_FALSE(r.success(medium_range()));
}

TEST(Engagement, StaysWithinTheLoadFactor) {
  LaunchSituation s = shooting_level(2000, 1.2);
  s.off_boresight = 1;
  const EngagementResult r =
      engage(medium_range(), kAtmosphere, {.situation = s, .range = 6e3, .escape = Escape::run});
  const double limit = medium_range().aero.greatest_load_factor * kGravity;
  EXPECT_GT(r.greatest_lift, 0.2 * limit);
  EXPECT_LE(r.greatest_lift, limit * (1 + 1e-12));
}

TEST(Engagement, ClimbsWhenItLofts) {
  const Engagement far{.situation = shooting_level(8000, 0), .range = 50e3};
  MissileType direct = medium_range();
  direct.guidance.loft.reset();
  const EngagementResult lofted = engage(medium_range(), kAtmosphere, far);
  const EngagementResult flat = engage(direct, kAtmosphere, far);
  EXPECT_GT(lofted.greatest_altitude, 9000);
  EXPECT_LT(flat.greatest_altitude, 8100);
  EXPECT_GT(lofted.speed, flat.speed);
}

TEST(Engagement, LoftsNoMissileThatHomes) {
  MissileType seeing = medium_range(), direct = medium_range();
  seeing.guidance.loft->end_range = 1e3;
  seeing.guidance.loft->angle = radians(30);
  direct.guidance.loft.reset();
  // 10 km: the seeker sees it from the start
  const Engagement near{.situation = shooting_level(8000, 0), .range = 10e3};
  EXPECT_EQ(engage(seeing, kAtmosphere, near).greatest_altitude,
            engage(direct, kAtmosphere, near).greatest_altitude);
}

TEST(Engagement, FliesAlmostTheSameInLongSteps) {
  Engagement e{.situation = shooting_level(9000, 0.4), .range = 35e3};
  const EngagementResult coarse = engage(medium_range(), kAtmosphere, e);
  e.longest_step = 0.02;
  const EngagementResult fine = engage(medium_range(), kAtmosphere, e);
  EXPECT_NEAR(coarse.time, fine.time, 0.02 * fine.time);
  EXPECT_NEAR(coarse.speed, fine.speed, 0.03 * fine.speed);
}

TEST(Autopilot, MissesAManeuverAsASingleLagDoes) {
  // a target that begins to turn x time constants T before the meeting, gain 4: the miss is
  // n T^2 x^2 exp(-x) |1/2 - x/6| (Zarchan, Tactical and Strategic Missile Guidance, ch. 3, closed
  // form of the single-lag guidance system), nothing at x = 3
  MissileType type = medium_range();
  type.guidance.navigation_gain = 4;
  type.guidance.autopilot_lag = 0.5;
  type.guidance.lag_speed.reset();
  type.aero.greatest_load_factor = 100;
  type.aero.greatest_lift = Table1::constant(900);
  type.aero.drag_power_off = Table1::constant(1e-9);
  type.aero.induced_drag = Table1::constant(0);
  const auto miss = [&](double x, double lag) {
    constexpr double kStep = 2e-4, kTurn = 5;
    type.guidance.autopilot_lag = lag;
    const double flight = x * lag;
    Vec3 place{1300 * flight, 0, -8000}, velocity{-300, 0, 0};
    Flyout missile{.position = {0, 0, -8000}, .velocity = {1000, 0, 0}, .lift = {0, 0, -kGravity}};
    double nearest = 1e9;
    for (double t = 0; t < flight + 0.05; t += kStep) {
      const LineOfSight los = line_of_sight(place - missile.position, velocity - missile.velocity);
      fly(type, kAtmosphere.at(8000), {}, kDown, 100, kStep,
          steer(type.guidance, los, missile.velocity, kDown), missile);
      velocity.y += kTurn * kStep;
      place += kStep * velocity;
      nearest = std::min(nearest, norm(place - missile.position));
    }
    return nearest / (kTurn * lag * lag);
  };
  for (const double x : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0}) {
    EXPECT_NEAR(miss(x, 0.5), x * x * std::exp(-x) * std::fabs(0.5 - x / 6), 0.025) << x;
    EXPECT_NEAR(miss(x, 0.25), miss(x, 0.5), 0.025) << "with the square of the time constant";
  }
}

TEST(Noise, MissesAsASingleLagDoes) {
  // the response of the miss to where the target appears x lags before they meet is with gain 4
  // exp(-x) (4 - 6 x + 2 x^2 - x^3/6) (adjoint of the single-lag guidance system, Zarchan, Tactical
  // and Strategic Missile Guidance, ch. 3 and 6); its square makes 93/32 under white glint, and
  // 5/16 under a white angle, which x^2 weighs. The filter's lag makes up to 6 % of the difference
  const NoisyApproach ideal;
  const double step = ideal.step, lag = ideal.lag;
  EXPECT_NEAR(spread_of_miss({.errors = {.angle_noise = 1e-3}}) /
                  (1e-3 * ideal.closing * std::sqrt(step * lag)),
              std::sqrt(5.0 / 16), 0.1 * std::sqrt(5.0 / 16));
  const SeekerType white{.angle_noise = 0, .glint = 3, .glint_time = 1e-3};
  EXPECT_NEAR(spread_of_miss({.errors = white}) / (3 * std::sqrt(step / lag)), std::sqrt(93.0 / 32),
              0.15);
  EXPECT_NEAR(spread_of_miss({.errors = white, .gain = 3}) / (3 * std::sqrt(step / lag)),
              std::sqrt(33.0 / 16), 0.15);
  // glint that wanders with the autopilot's own time constant
  const SeekerType slow{.angle_noise = 0, .glint = 3, .glint_time = lag};
  EXPECT_NEAR(spread_of_miss({.errors = slow}) / 3, std::sqrt(147.0 / 128), 0.1);
}

TEST(Autopilot, AnswersLaterAtLowDynamicPressure) {
  MissileGuidance guidance{.autopilot_lag = 0.1, .lag_speed = 400};
  const Air sea = kAtmosphere.at(0), high = kAtmosphere.at(12e3);
  EXPECT_DOUBLE_EQ(autopilot_lag(guidance, sea, 800), 0.1);
  EXPECT_NEAR(autopilot_lag(guidance, sea, 200), 0.2, 1e-12);
  EXPECT_NEAR(autopilot_lag(guidance, high, 400), 0.1 * std::sqrt(sea.density / high.density),
              1e-6);
  guidance.lag_speed.reset();
  EXPECT_DOUBLE_EQ(autopilot_lag(guidance, high, 100), 0.1);
}

}  // namespace
}  // namespace eyrie::model::weapon
