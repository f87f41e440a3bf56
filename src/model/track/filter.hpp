// SPDX-License-Identifier: MIT
#pragma once
/// \file  The filter of one track: two-state Kalman filters along and across the line of sight.
///
/// A radar knows range a hundred times better than direction, the eye the other way round, so one
/// gain for all three axes would waste most of what a sensor says. A full six-state covariance is
/// not needed either: errors of one look are uncorrelated along and across the line of sight, and
/// the two axes across are alike. So the covariance is kept for one axis along and one across.
#include <cmath>

#include "core/vec.hpp"
#include "model/track.hpp"
#include "model/track/tracker.hpp"

namespace eyrie::model::track {

/// Covariance of (position, velocity) along one axis, in double precision.
struct AxisState {
  double position = 0;  ///< m^2
  double cross = 0;     ///< m^2/s
  double velocity = 0;  ///< m^2/s^2
};
[[nodiscard]] constexpr AxisState widen(const AxisCovariance& c) {
  return {c.position, c.cross, c.velocity};
}
[[nodiscard]] constexpr AxisCovariance narrow(const AxisState& c) {
  return {static_cast<float>(c.position), static_cast<float>(c.cross),
          static_cast<float>(c.velocity)};
}

/// How much of a residual goes into position and velocity.
struct Gains {
  double position = 0, velocity = 0;
};

/// The covariance `dt` later (s), for constant velocity disturbed by an acceleration of 1-sigma
/// `maneuver` (m/s^2) that is constant within the interval: discrete white noise acceleration,
/// Bar-Shalom, Li & Kirubarajan, Estimation with Applications to Tracking and Navigation, 6.3.2.
[[nodiscard]] constexpr AxisState predicted(const AxisState& c, double dt, double maneuver) {
  const double dt2 = dt * dt, q = maneuver * maneuver;
  return {c.position + 2 * dt * c.cross + dt2 * c.velocity + q * dt2 * dt2 / 4,
          c.cross + dt * c.velocity + q * dt2 * dt / 2, c.velocity + q * dt2};
}

/// Kalman gains for a measured position with that variance (m^2); `c` becomes the covariance after.
constexpr Gains update_position(AxisState& c, double variance) {
  const double total = c.position + variance;
  const Gains gains{c.position / total, c.cross / total};
  c = {(1 - gains.position) * c.position, (1 - gains.position) * c.cross,
       c.velocity - gains.velocity * c.cross};
  return gains;
}

/// Kalman gains for a measured velocity with that variance (m^2/s^2).
constexpr Gains update_velocity(AxisState& c, double variance) {
  const double total = c.velocity + variance;
  const Gains gains{c.cross / total, c.velocity / total};
  c = {c.position - gains.position * c.cross, (1 - gains.velocity) * c.cross,
       (1 - gains.velocity) * c.velocity};
  return gains;
}

/// Where a track is believed to be at some time, with the covariance it then has.
struct Prediction {
  Vec3 position{};  ///< m
  Vec3 velocity{};  ///< m/s
  AxisState along, across;
};

/// Carries a track on to `time` (s). When the line of sight from the ownship has turned meanwhile,
/// the uncertainty along and across it mix: the diagonal of the turned covariance, which keeps its
/// trace. `ownship` is where the owner is at `time`.
[[nodiscard]] Prediction predict(const Track& track, const Tracker& tracker, const Ownship& ownship,
                                 double time);

/// Distance of a contact from a prediction in standard deviations, squared, with the contact's own
/// error in it (Mahalanobis distance).
[[nodiscard]] double deviations_of(const Prediction& prediction, const Contact& contact);

/// A track after one more contact at `time` (s).
void filter(Track& track, const Prediction& prediction, const Contact& contact, double time);

/// A new track from one contact: no speed but what the contact says, and a covariance that knows
/// it.
[[nodiscard]] Track first_track(const Tracker& tracker, const Contact& contact, double time);

/// Sets the two sigmas from the covariances, carried on to `time`.
void refresh_sigmas(Track& track, const Tracker& tracker, double time);

}  // namespace eyrie::model::track
