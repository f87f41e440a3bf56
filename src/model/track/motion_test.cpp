// SPDX-License-Identifier: MIT
#include "model/track/motion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace eyrie::model::track {
namespace {

Transition turn(const Motion& motion, double dt) {
  return interval(motion, dt).turning;
}

std::array<double, 6> numbers(const AxisState& c) {
  return {c.position,    c.cross, c.velocity, c.position_acceleration, c.velocity_acceleration,
          c.acceleration};
}

/// Looking in between must not change what is expected at the end.
RC_GTEST_PROP(Transition, SaysTheSameOverTwoHalvesAsOverTheWhole, ()) {
  const double dt = *rc::gen::inRange(1, 2000) / 100.0;
  const Motion motion;
  const AxisState start{300 * 300, 4000, 60 * 60};
  AxisState begun = start;
  begun.acceleration = 20 * 20;
  for (const auto model : {straight_on, turn}) {
    const AxisState& from = model == turn ? begun : start;
    const Transition half = model(motion, dt / 2), whole = model(motion, dt);
    const auto once = numbers(predicted(from, whole));
    const auto twice = numbers(predicted(predicted(from, half), half));
    const auto noise = numbers(whole.noise);
    // the short form is good to two parts in a hundred of what it adds
    const double slack = whole.dt < 0.2 ? 0.02 : 1e-3;
    for (std::size_t i = 0; i < once.size(); ++i)
      RC_ASSERT(std::fabs(once[i] - twice[i]) <= slack * noise[i] + 1e-6 * std::fabs(once[i]));
  }
}

TEST(Transition, HasThePublishedNoiseOfSingersModel) {
  // an interval of 1 s, memory 20 s, 1 m/s2: the example of singerProcessNoise in the reference of
  // MATLAB's Sensor Fusion and Tracking Toolbox
  const AxisState noise = turn({.maneuver = 1, .maneuver_memory = 20}, 1).noise;
  const std::array<double, 6> published{0.0049, 0.0121, 0.0321, 0.0159, 0.0476, 0.0952};
  for (std::size_t i = 0; i < published.size(); ++i)
    EXPECT_NEAR(numbers(noise)[i], published[i], 5e-5) << i;
}

TEST(Transition, KeepsTheAccelerationOfATurnAsStrongAsItIs) {
  const Motion motion{.maneuver = 30, .maneuver_memory = 5};
  AxisState c{.acceleration = 30 * 30};
  for (int i = 0; i < 100; ++i)
    c = predicted(c, turn(motion, 0.7));
  EXPECT_NEAR(c.acceleration, 900, 1e-6);
}

TEST(Transition, IsWhiteNoiseWhenTheAccelerationForgetsAtOnce) {
  // Singer's model tends to white noise of spectral density 2 sigma^2 memory (Singer, 1970)
  const Motion motion{.maneuver = 30, .maneuver_memory = 0.1};
  const AxisState noise = predicted({}, turn(motion, 50));
  const double q = 2 * 900 * 0.1;
  EXPECT_NEAR(noise.velocity / (q * 50), 1, 0.01);
  EXPECT_NEAR(noise.position / (q * 50 * 50 * 50 / 3), 1, 0.01);
}

TEST(Interval, ChangesBetweenStraightAndTurnAsAMarkovChainDoes) {
  const Motion motion{.straight_time = 60, .turn_time = 10};
  const Interval a = interval(motion, 3), b = interval(motion, 5), whole = interval(motion, 8);
  // Chapman-Kolmogorov
  EXPECT_NEAR(whole.begins, a.begins * (1 - b.ends) + (1 - a.begins) * b.begins, 1e-12);
  EXPECT_NEAR(whole.ends, a.ends * (1 - b.begins) + (1 - a.ends) * b.ends, 1e-12);
  // one in a minute, and in the long run as often as turns are long
  EXPECT_NEAR(interval(motion, 1e-3).begins * 60, 1e-3, 1e-6);
  EXPECT_NEAR(interval(motion, 1e4).begins, 10.0 / 70, 1e-12);
}

AxisState covariance(double sigma, double speed_sigma, double correlation) {
  return {sigma * sigma, correlation * sigma * speed_sigma, speed_sigma * speed_sigma};
}

TEST(Intersection, LearnsNothingFromItsOwnEcho) {
  const AxisState own = covariance(300, 20, 0.6);
  const Intersection same = intersect(own, own);
  EXPECT_FALSE(same.worth_it);
  EXPECT_EQ(numbers(same.covariance), numbers(own));
  EXPECT_EQ(same.position_position, 0);
}

TEST(Intersection, TakesOverWhatIsBetterInEveryWay) {
  const AxisState own = covariance(300, 20, 0.6), good = covariance(30, 2, 0.6);
  EXPECT_FALSE(intersect(good, own).worth_it) << "a worse one of the same shape teaches nothing";
  const Intersection taken = intersect(own, good);
  EXPECT_TRUE(taken.worth_it);
  EXPECT_NEAR(taken.covariance.position, good.position, 1e-6);
  EXPECT_NEAR(taken.position_position, 1, 1e-9);
  EXPECT_NEAR(taken.velocity_velocity, 1, 1e-9);
  EXPECT_NEAR(taken.position_velocity, 0, 1e-9);
}

TEST(Intersection, TakesThePositionOfOneAndTheVelocityOfTheOther) {
  const Intersection both = intersect(covariance(20, 200, 0), covariance(400, 10, 0));
  EXPECT_TRUE(both.worth_it);
  EXPECT_LT(both.covariance.position, 2.1 * 20 * 20);
  EXPECT_LT(both.covariance.velocity, 2.1 * 10 * 10);
}

/// Whatever two estimates have in common, the joint one is no better than it says: the true
/// covariance of the joint error is below the claimed one in every direction.
RC_GTEST_PROP(Intersection, NeverClaimsMoreThanItKnows, ()) {
  const auto in = [](int low, int high) { return double(*rc::gen::inRange(low, high)); };
  const AxisState a = covariance(in(10, 900), in(1, 200), in(-90, 91) / 100);
  const AxisState b = covariance(in(10, 900), in(1, 200), in(-90, 91) / 100);
  const Intersection joint = intersect(a, b);

  // the strongest correlation of both errors there is, in a direction of choice: b's error is
  // L_b R L_a^-1 times that of a, with a rotation R
  const double turned = in(0, 628) / 100, c = std::cos(turned), s = std::sin(turned);
  const auto root = [](const AxisState& x) {
    const double p = std::sqrt(x.position), v = x.cross / p;
    return std::array{p, v, std::sqrt(x.velocity - v * v)};  // lower triangular: p, v, rest
  };
  const auto ra = root(a), rb = root(b);
  double claimed[3] = {joint.covariance.position, joint.covariance.cross,
                       joint.covariance.velocity};
  // error = (I - G) e_a + G e_b, e_a = L_a u, e_b = L_b R u
  const double g[4] = {joint.position_position, joint.position_velocity, joint.velocity_position,
                       joint.velocity_velocity};
  double error[4];
  for (int k = 0; k < 2; ++k) {
    const double u0 = k == 0, u1 = k == 1;
    const double ap = ra[0] * u0, av = ra[1] * u0 + ra[2] * u1;
    const double t0 = c * u0 - s * u1, t1 = s * u0 + c * u1;
    const double bp = rb[0] * t0, bv = rb[1] * t0 + rb[2] * t1;
    error[k] = ap + g[0] * (bp - ap) + g[1] * (bv - av);
    error[2 + k] = av + g[2] * (bp - ap) + g[3] * (bv - av);
  }
  const double pp = error[0] * error[0] + error[1] * error[1];
  const double pv = error[0] * error[2] + error[1] * error[3];
  const double vv = error[2] * error[2] + error[3] * error[3];
  const double slack = 1 + 1e-9;
  RC_ASSERT(pp <= claimed[0] * slack && vv <= claimed[2] * slack);
  const double rest =
      (claimed[0] * slack - pp) * (claimed[2] * slack - vv) - std::pow(claimed[1] - pv, 2);
  RC_ASSERT(rest >= -1e-6 * claimed[0] * claimed[2]);

  const auto determinant = [](const AxisState& x) {
    return x.position * x.velocity - x.cross * x.cross;
  };
  RC_ASSERT(determinant(joint.covariance) <=
            std::min(determinant(a), determinant(b) / 0.9) * (1 + 1e-9));
}

TEST(Intersection, LetsTheAccelerationFollow) {
  const AxisState own{300 * 300, 3000, 60 * 60, 2000, 500, 400};
  const Intersection joint = intersect(own, covariance(30, 5, 0));
  // perfectly known position and velocity leave the part of the acceleration that they do not
  // explain, and what is learned can only make it smaller
  EXPECT_LT(joint.covariance.acceleration, own.acceleration);
  const double det = own.position * own.velocity - own.cross * own.cross;
  const double explained =
      (own.velocity * 2000 * 2000 - 2 * own.cross * 2000 * 500 + own.position * 500 * 500) / det;
  EXPECT_GE(joint.covariance.acceleration, own.acceleration - explained);
}

}  // namespace
}  // namespace eyrie::model::track
