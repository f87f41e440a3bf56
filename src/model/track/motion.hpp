// SPDX-License-Identifier: MIT
#pragma once
/// \file  How targets move, as a tracker sees it: straight on, or turning. The covariance of one
/// axis under both models. docs/models/tracks.md has the equations.
#include "core/describe.hpp"
#include "model/track.hpp"

namespace eyrie::model::track {

/// Two models of motion and a Markov chain between them. What it says of a target does not depend
/// on how often the target is looked at.
struct Motion {
  double wander = 1.4;         ///< m/s in a second
  double maneuver = 30;        ///< m/s^2
  double maneuver_memory = 5;  ///< s
  double straight_time = 60;   ///< s
  double turn_time = 10;       ///< s

  static constexpr std::string_view type_name = "motion";
  static constexpr std::string_view help = "how a tracker expects its targets to move";
  static constexpr auto params() {
    return Lines{
        param("wander", &Motion::wander, "m/s", range(0, 100),
              "random walk of the velocity of a target that flies straight: so much in one second, "
              "1-sigma per axis"),
        param("maneuver", &Motion::maneuver, "m/s2", range(0, 500),
              "acceleration of a target that turns, 1-sigma per axis"),
        param("maneuver_memory", &Motion::maneuver_memory, "s", range(0.1, 600),
              "time in which the acceleration of a turning target forgets its direction"),
        param("straight_time", &Motion::straight_time, "s", range(0.1, 1e9),
              "mean time that a target flies straight between two turns"),
        param("turn_time", &Motion::turn_time, "s", range(0.1, 1e9), "mean time of a turn")};
  }

  /// Chance that a target turns that nobody has watched yet.
  [[nodiscard]] constexpr double turning() const { return turn_time / (straight_time + turn_time); }
};

/// Zeros in the last three members for a model without acceleration.
using AxisState = CovarianceOf<double>;
[[nodiscard]] constexpr AxisState wide(const AxisCovariance& c) {
  return {c.position, c.cross, c.velocity};
}
[[nodiscard]] constexpr AxisCovariance narrow(const AxisState& c) {
  return {static_cast<float>(c.position), static_cast<float>(c.cross),
          static_cast<float>(c.velocity)};
}
using eyrie::narrow, eyrie::wide;

/// a + weight * b, member by member.
[[nodiscard]] constexpr AxisState plus(const AxisState& a, double weight, const AxisState& b) {
  return {a.position + weight * b.position,
          a.cross + weight * b.cross,
          a.velocity + weight * b.velocity,
          a.position_acceleration + weight * b.position_acceleration,
          a.velocity_acceleration + weight * b.velocity_acceleration,
          a.acceleration + weight * b.acceleration};
}

/// One model over an interval: position += dt v + to_position a, velocity += to_velocity a,
/// acceleration *= kept, and the covariance of what comes on top.
struct Transition {
  double dt = 0;           ///< s
  double to_position = 0;  ///< s^2
  double to_velocity = 0;  ///< s
  double kept = 0;
  AxisState noise;
};

/// Nearly constant velocity, continuous white noise acceleration: Bar-Shalom, Li & Kirubarajan,
/// Estimation with Applications to Tracking and Navigation (2001), eq. 6.2.2-12.
[[nodiscard]] Transition straight_on(const Motion& motion, double dt);

/// Both models over one interval, and the chances to change from one to the other meanwhile.
struct Interval {
  Transition straight, turning;
  double begins = 0;  ///< that a target that flew straight turns at the end
  double ends = 0;    ///< that one that turned flies straight at the end
};
[[nodiscard]] Interval interval(const Motion& motion, double dt);

/// F P F^T + Q.
[[nodiscard]] constexpr AxisState predicted(const AxisState& c, const Transition& t) {
  const double p = c.position + t.dt * c.cross + t.to_position * c.position_acceleration;
  const double pv = c.cross + t.dt * c.velocity + t.to_position * c.velocity_acceleration;
  const double pa =
      c.position_acceleration + t.dt * c.velocity_acceleration + t.to_position * c.acceleration;
  const double va = c.velocity_acceleration + t.to_velocity * c.acceleration;
  return {p + t.dt * pv + t.to_position * pa + t.noise.position,
          pv + t.to_velocity * pa + t.noise.cross,
          c.velocity + t.to_velocity * (c.velocity_acceleration + va) + t.noise.velocity,
          t.kept * pa + t.noise.position_acceleration,
          t.kept * va + t.noise.velocity_acceleration,
          t.kept * t.kept * c.acceleration + t.noise.acceleration};
}

/// The variances of position and of velocity in it.
[[nodiscard]] constexpr double later_position(const AxisState& c, const Transition& t) {
  return c.position + t.dt * (2 * c.cross + t.dt * c.velocity) +
         t.to_position * (2 * (c.position_acceleration + t.dt * c.velocity_acceleration) +
                          t.to_position * c.acceleration) +
         t.noise.position;
}
[[nodiscard]] constexpr double later_velocity(const AxisState& c, const Transition& t) {
  return c.velocity +
         t.to_velocity * (2 * c.velocity_acceleration + t.to_velocity * c.acceleration) +
         t.noise.velocity;
}

/// How much of a residual goes into position, velocity and acceleration.
struct Gains {
  double position = 0, velocity = 0, acceleration = 0;
};

/// Kalman gains for a measured position with that variance (m^2); `c` becomes the covariance after.
constexpr Gains update_position(AxisState& c, double variance) {
  const double total = c.position + variance;
  const Gains gains{c.position / total, c.cross / total, c.position_acceleration / total};
  c = {(1 - gains.position) * c.position,
       (1 - gains.position) * c.cross,
       c.velocity - gains.velocity * c.cross,
       (1 - gains.position) * c.position_acceleration,
       c.velocity_acceleration - gains.velocity * c.position_acceleration,
       c.acceleration - gains.acceleration * c.position_acceleration};
  return gains;
}

/// Kalman gains for a measured velocity with that variance (m^2/s^2).
constexpr Gains update_velocity(AxisState& c, double variance) {
  const double total = c.velocity + variance;
  const Gains gains{c.cross / total, c.velocity / total, c.velocity_acceleration / total};
  c = {c.position - gains.position * c.cross,
       (1 - gains.velocity) * c.cross,
       (1 - gains.velocity) * c.velocity,
       c.position_acceleration - gains.position * c.velocity_acceleration,
       (1 - gains.velocity) * c.velocity_acceleration,
       c.acceleration - gains.acceleration * c.velocity_acceleration};
  return gains;
}

/// Two estimates of one axis made one without knowing how far they depend on each other: covariance
/// intersection, S. J. Julier and J. K. Uhlmann, "A Non-divergent Estimation Algorithm in the
/// Presence of Unknown Correlations", Proc. American Control Conference (1997) 2369. The weight is
/// the one that makes the determinant of the covariance of position and velocity smallest; the
/// acceleration knows of these two what it knew before.
struct Intersection {
  AxisState covariance;   ///< after
  bool worth_it = false;  ///< whether there is anything to be learned: a tenth of the determinant
  /// What position and velocity move for a difference in position and in velocity (theirs - own).
  double position_position = 0, position_velocity = 0;
  double velocity_position = 0, velocity_velocity = 0;
  /// What the acceleration moves for a move of position and velocity.
  double acceleration_position = 0, acceleration_velocity = 0;
};
[[nodiscard]] Intersection intersect(const AxisState& own, const AxisState& theirs);

}  // namespace eyrie::model::track
