// SPDX-License-Identifier: MIT
#pragma once
/// \file  How a missile flies: lines of sight, guidance, forces, and the fuze at the end.
#include <algorithm>

#include "model/environment.hpp"
#include "model/weapon/missile.hpp"

namespace eyrie::model::weapon {

/// Geometry of a relative position and velocity; rates are exact for the instant.
struct LineOfSight {
  Vec3 direction{1, 0, 0};  ///< unit vector from the observer to the other
  Vec3 rate;                ///< rad/s, angular velocity of `direction`, perpendicular to it
  double range = 0;         ///< m
  double closing = 0;       ///< m/s, positive when the range shrinks
};

/// `relative_position` and `relative_velocity` are other minus observer, m and m/s, any one frame.
/// rate = r x v / r^2 (Zarchan, Tactical and Strategic Missile Guidance, 6th ed., ch. 2). At no
/// distance the direction is the x axis and nothing turns.
[[nodiscard]] inline LineOfSight line_of_sight(const Vec3& relative_position,
                                               const Vec3& relative_velocity) {
  const Vec3& r = relative_position;
  const Vec3& v = relative_velocity;
  const double range2 = norm2(r);
  if (!(range2 > 1e-12))
    return {};
  const double range = std::sqrt(range2);
  const double a = 1 / range, b = 1 / range2;
  // built in place: copies of freshly written vectors stall the processor
  return {.direction = {a * r.x, a * r.y, a * r.z},
          .rate = {b * (r.y * v.z - r.z * v.y), b * (r.z * v.x - r.x * v.z),
                   b * (r.x * v.y - r.y * v.x)},
          .range = range,
          .closing = -a * dot(r, v)};
}

/// Proportional navigation: the acceleration (m/s^2) perpendicular to the line of sight that turns
/// it back, N times a speed times its rate. With the closing speed it is true proportional
/// navigation (Zarchan, eq. 2.1: n_c = N' V_c dl/dt), with the own speed the pure form.
[[nodiscard]] inline Vec3 proportional_navigation(double gain, double speed,
                                                  const LineOfSight& los) {
  return gain * speed * cross(los.rate, los.direction);
}

/// The part of `v` perpendicular to the unit vector `axis`.
[[nodiscard]] constexpr Vec3 perpendicular(const Vec3& v, const Vec3& axis) {
  return v - dot(v, axis) * axis;
}

/// `v` shortened to the length `limit` if it is longer.
[[nodiscard]] inline Vec3 limited(const Vec3& v, double limit) {
  const double length2 = norm2(v);
  return length2 > limit * limit ? v * (limit / std::sqrt(length2)) : v;
}

/// m/s^2, what to ask of the autopilot of a missile that flies with `velocity` (m/s):
/// true proportional navigation (Zarchan, eq. 2.1), where a target that closes more slowly than
/// half the missile's own speed is taken to close with that, because the closing speed is small or
/// negative at first after a launch far off boresight;
/// plus a turn towards the target as long as it is more than 45 degrees off the flight path;
/// plus what holds the missile up against gravity.
[[nodiscard]] Vec3 steer(const MissileGuidance& guidance, const LineOfSight& los,
                         const Vec3& velocity, const Vec3& down);

/// Where to aim when the target is believed `relative_position` away (m): a distant target is aimed
/// above by the loft angle, and by less and less up to the end range. `altitude` is the missile's,
/// m; the ceiling holds for the place aimed at.
[[nodiscard]] Vec3 lofted(const Loft& loft, const Vec3& relative_position, const Vec3& down,
                          double altitude);

/// What flying changes.
struct Flyout {
  Vec3 position{};  ///< m
  Vec3 velocity{};  ///< m/s over the ground
  Vec3 lift{};      ///< m/s^2, achieved aerodynamic acceleration across the flight path
};

/// What the air gives and takes at one moment.
struct FlyoutForces {
  double along = 0;       ///< m/s^2, thrust less drag at no lift
  double lift_limit = 0;  ///< m/s^2, the greatest acceleration across the flight path
  double induced = 0;     ///< 1/(m/s^2): drag deceleration per lift acceleration squared
};

/// s, of the autopilot at `speed` (m/s through the air). The natural frequency of an airframe,
/// sqrt(q S d C_m_alpha / I), grows with the root of the dynamic pressure, and so with the
/// equivalent airspeed; an autopilot is no faster (Zarchan, Tactical and Strategic Missile
/// Guidance, ch. 22, not seen). Down to guidance.lag_speed the lag is as given, below it grows.
[[nodiscard]] double autopilot_lag(const MissileGuidance& guidance, const Air& air, double speed);

/// Forces at `speed` (m/s through the air) and `age` (s since launch).
[[nodiscard]] FlyoutForces flyout_forces(const MissileType& type, const Air& air, double speed,
                                         double age);

/// One step of `dt` s. `wanted` (m/s^2) is what guidance asks for; its part along the flight path
/// is ignored, the rest is limited by load factor and greatest lift and follows with the
/// autopilot's lag. `wind` is the velocity of the air, `down` the unit vector of gravity.
void fly(const MissileType& type, const Air& air, const Vec3& wind, const Vec3& down, double age,
         double dt, const Vec3& wanted, Flyout& state);

/// The nearest point of a relative motion.
struct ClosestApproach {
  double time = 0;      ///< s, after the instant that the positions are given for
  double distance = 0;  ///< m
  Vec3 separation;      ///< m, other minus own at that time
};

/// Exact for linear motion over [begin, end] (s): the minimum of |r + v t| lies at
/// t = -(r . v) / (v . v), clamped to the interval.
[[nodiscard]] inline ClosestApproach closest_approach(const Vec3& relative_position,
                                                      const Vec3& relative_velocity, double begin,
                                                      double end) {
  const double speed2 = norm2(relative_velocity);
  const double free = speed2 > 1e-12 ? -dot(relative_position, relative_velocity) / speed2 : begin;
  const double time = std::clamp(free, begin, end);
  const Vec3 separation = relative_position + time * relative_velocity;
  return {.time = time, .distance = norm(separation), .separation = separation};
}

/// The closest approach in the step of `dt` s that has just been made, from where both are now
/// (relative position, m) and how they move (relative velocity, m/s): time in [-dt, 0]. `passing`
/// if they have come closest in this step and now part; the step before may have ended a hair
/// earlier, because velocities change from step to step.
struct Passage {
  ClosestApproach nearest;
  bool passing = false;
};
[[nodiscard]] inline Passage passage(const Vec3& relative_position, const Vec3& relative_velocity,
                                     double dt) {
  Passage result{.nearest = closest_approach(relative_position, relative_velocity, -dt, 0)};
  const double now = dot(relative_position, relative_velocity);
  const double before = now - 1.5 * dt * norm2(relative_velocity);
  result.passing = now >= 0 && before <= 0;
  return result;
}

/// The probability that the warhead kills at a miss distance (m): the diffuse Gaussian damage
/// function exp(-miss^2 / (2 b^2)) with b^2 = lethal_radius^2 / 2, scaled by the reliability, so
/// that the lethal area 2 pi b^2 is that of a disk of the lethal radius. Washburn & Kress, Combat
/// Modeling (2009), ch. 2; Driels, Weaponeering, has it as the circular Carleton function.
[[nodiscard]] inline double kill_probability(const Warhead& warhead, double miss) {
  const double x = miss / warhead.lethal_radius;
  return warhead.best_kill * math::exp(-x * x);
}

}  // namespace eyrie::model::weapon
