// SPDX-License-Identifier: MIT
#include "dis/dead_reckoning.hpp"

#include <gtest/gtest.h>

#include "model/frames.hpp"
#include "model/kinematics.hpp"

namespace eyrie::dis {
namespace {

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}
void expect_near(const Mat3& a, const Mat3& b, double tolerance) {
  expect_near(a.row_x, b.row_x, tolerance);
  expect_near(a.row_y, b.row_y, tolerance);
  expect_near(a.row_z, b.row_z, tolerance);
}

Motion moving() {
  return {.position = {1000, 2000, 3000},
          .velocity = {10, -20, 30},
          .acceleration = {1, 2, -4},
          .attitude = attitude_of({0.3, -0.2, 0.5}),
          .spin = {0, 0, 0.1}};
}

TEST(DeadReckoning, FollowsItsClosedForms) {
  using enum Reckoning;
  const Vec3 straight{1050, 1900, 3150}, bent{1062.5, 1925, 3100};
  for (const auto& [algorithm, place, turns] : {std::tuple(fixed, Vec3{1000, 2000, 3000}, false),
                                                {fpw, straight, false},
                                                {rpw, straight, true},
                                                {rvw, bent, true},
                                                {fvw, bent, false}}) {
    const Motion to = reckon(algorithm, moving(), 5);
    expect_near(to.position, place, 1e-9);
    // half a radian about the body's down axis: nose to the right, down stays
    const Mat3 from = moving().attitude;
    const auto [s, c] = math::sin_cos(turns ? 0.5 : 0);
    expect_near(to.attitude,
                {c * from.row_x + s * from.row_y, c * from.row_y - s * from.row_x, from.row_z},
                1e-12);
  }
  expect_near(reckon(rvw, moving(), 5).velocity, {15, -10, 10}, 1e-12);
  expect_near(reckon(static_cast<Reckoning>(9), moving(), 5).position, {1000, 2000, 3000}, 0);
}

/// A level turn: the place on the circle is (r sin wt, r (1 - cos wt)), and RVW leaves it by
/// v w^2 t^3 / 6 at first.
TEST(DeadReckoning, LeavesACircleWithTheThirdPowerOfTime) {
  const double speed = 250, rate = 0.1, t = 0.5;
  const Motion start{
      .velocity = {speed, 0, 0}, .acceleration = {0, speed * rate, 0}, .spin = {0, 0, rate}};
  const Motion to = reckon(Reckoning::rvw, start, t);
  const auto [s, c] = math::sin_cos(rate * t);
  const Vec3 truth{speed / rate * s, speed / rate * (1 - c), 0};
  EXPECT_NEAR(norm(to.position - truth), speed * rate * rate * t * t * t / 6, 1e-3);
  expect_near(to.attitude.row_x, {c, s, 0}, 1e-12);  // the attitude has no error
}

TEST(DeadReckoning, FindsTheSpinThatItTurnsWith) {
  for (const Vec3 spin : {Vec3{0.3, -0.2, 0.1}, Vec3{0, 0, 3}, Vec3{1e-9, 0, 0}, Vec3{}}) {
    Motion from = moving();
    from.spin = spin;
    const Motion to = reckon(Reckoning::rpw, from, 0.02);
    expect_near(spin_between(from.attitude, to.attitude, 0.02), spin, 1e-9);
  }
}

TEST(Orientation, IsWhatTheEulerAnglesSay) {
  for (const Vec3 euler : {Vec3{}, Vec3{0.3, -0.2, 0.5}, Vec3{-3, 1.5, 3}, Vec3{2, -1.57, -1}})
    expect_near(euler_of(attitude_of(euler)), euler, 1e-9);
  // along the axis of the Earth two of the angles are one
  const Mat3 up = attitude_of({0.4, -kPi / 2, 0.3});
  expect_near(attitude_of(euler_of(up)), up, 1e-9);
}

/// Over a latitude and a longitude the axes north, east and down of the world are known.
TEST(Orientation, IsThatOfAnAircraftOverTheEllipsoid) {
  const double lat = radians(35), lon = radians(-68);
  const Reference earth({lat, lon, 0});
  const auto euler_at = [&](double heading, double pitch, double roll) {
    model::Kinematics k{.north = {1, 0, 0}, .east = {0, 1, 0}, .down = {0, 0, 1}};
    k.heading = heading;
    k.pitch = pitch;
    k.roll = roll;
    const model::Axes body = model::body_axes(k);
    return euler_of({earth.turned_to_ecef(body.forward), earth.turned_to_ecef(body.right),
                     earth.turned_to_ecef(body.down)});
  };
  // north: forward has the azimuth lon + pi in the world, and rises by pi/2 - lat to its axis
  expect_near(euler_at(0, 0, 0), {wrap_pi(lon + kPi), -(kPi / 2 - lat), kPi}, 1e-9);
  // east: forward lies in the equator's plane at lon + pi/2; the right wing points south
  expect_near(euler_at(kPi / 2, 0, 0), {lon + kPi / 2, 0, -(kPi / 2 + lat)}, 1e-9);
  // straight up, belly to the north: forward is the zenith
  expect_near(euler_at(0, kPi / 2, 0), {lon, -lat, 0}, 1e-9);
  // a roll turns about the nose, whatever the rest
  expect_near(euler_at(kPi / 2, 0, 0.3) - euler_at(kPi / 2, 0, 0), {0, 0, 0.3}, 1e-9);
}

TEST(Thresholds, AreMetresAndDegrees) {
  const Thresholds limits;
  const Motion a = moving();
  Motion b = a;
  EXPECT_FALSE(apart(a, b, limits));
  b.position.y += 0.99;
  EXPECT_FALSE(apart(a, b, limits));
  b.position.y += 0.02;
  EXPECT_TRUE(apart(a, b, limits));
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    Motion turning = a;
    turning.spin = radians(1) * axis;
    Motion c = a;
    c.attitude = reckon(Reckoning::rpw, turning, 2.99).attitude;
    EXPECT_FALSE(apart(a, c, limits));
    c.attitude = reckon(Reckoning::rpw, turning, 3.01).attitude;
    EXPECT_TRUE(apart(a, c, limits));
  }
}

}  // namespace
}  // namespace eyrie::dis
