// SPDX-License-Identifier: MIT
#pragma once
/// \file  How contacts become tracks: which contact belongs to which track, and the filter.
/// docs/models/tracks.md has the equations.
#include "core/describe.hpp"
#include "model/track.hpp"

namespace eyrie::model::track {

/// The tracker in the mission computer: const, shared, one for all sensors of an aircraft.
struct Tracker {
  double rate = 10;  ///< Hz
  double gate = 4;
  double max_gate = si(5, "km");  ///< m
  std::uint32_t confirm_hits = 2;
  double maneuver = 20;        ///< m/s^2
  double initial_speed = 250;  ///< m/s
  double coast_time = 12;      ///< s
  double tentative_time = 6;   ///< s
  double merge_gate = 2;
  double glance_time = 0.2;  ///< s

  static constexpr std::string_view type_name = "tracker";
  static constexpr std::string_view help = "association, filter and life of tracks";
  static constexpr auto params() {
    return std::tuple{
        param(
            "rate", &Tracker::rate, "Hz", range(0.1, 100),
            "how often the tracks are looked after, the datalink is read and the beam is steered"),
        param("gate", &Tracker::gate, range(1, 10),
              "a contact belongs to a track within so many standard deviations"),
        param("max_gate", &Tracker::max_gate, "m", range(1, 1e5),
              "and, but for the error of its range, never farther away than this"),
        param("confirm_hits", &Tracker::confirm_hits, range(1, 255),
              "contacts after which a track is believed"),
        param("maneuver", &Tracker::maneuver, "m/s2", range(0, 500),
              "acceleration that a target may have, 1-sigma per axis"),
        param("initial_speed", &Tracker::initial_speed, "m/s", range(1, 2000),
              "speed that a new target may have, 1-sigma per axis"),
        param("coast_time", &Tracker::coast_time, "s", range(0.1, 600),
              "a confirmed track is dropped so long after its last update"),
        param("tentative_time", &Tracker::tentative_time, "s", range(0.1, 600),
              "a tentative track is dropped so long after its last update"),
        param("merge_gate", &Tracker::merge_gate, range(0, 10),
              "tracks closer than so many standard deviations are one"),
        param("glance_time", &Tracker::glance_time, "s", range(0, 60),
              "two tracks that the eyes last saw so far apart in time may be one aircraft")};
  }
};

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

/// m^2: no track is farther than that from a contact of its target. An eye judges a direction well
/// and a range badly, so what the contact does not know along its line comes on top.
[[nodiscard]] inline double reach2(const Tracker& tracker, const Contact& contact) {
  const double reach = tracker.max_gate + tracker.gate * contact.sigma_along;
  return reach * reach;
}

inline constexpr std::size_t kMaxContacts = 32;

/// Marks a contact that belongs to no track.
inline constexpr std::uint8_t kNoTrack = 255;

/// For each contact the index of its track, or kNoTrack. A pair must lie within the gates; of all
/// pairs the closest one (in standard deviations) is taken first, then the closest of the rest, so
/// each contact and each track is used at most once. Of equal pairs the older track and then the
/// earlier contact goes first. This greedy global nearest neighbor is the common choice where
/// targets are farther apart than the errors (Blackman & Popoli, Design and Analysis of Modern
/// Tracking Systems, sec. 6.4). At most kMaxContacts contacts and kMaxTracks predictions.
[[nodiscard]] std::array<std::uint8_t, kMaxContacts> associate(const Tracker& tracker,
                                                               std::span<const Prediction> tracks,
                                                               std::span<const Contact> contacts);

}  // namespace eyrie::model::track
