// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a player knows of others: a contact, which is one look of one sensor before any
/// filter, and a track, a filtered estimate built from contacts.
#include <algorithm>

#include "core/field.hpp"

namespace eyrie::model {

enum class Identity : std::uint8_t { unknown, friendly, hostile };
constexpr auto names_of(Identity) {
  return names_from_zero<Identity>("unknown", "friendly", "hostile");
}

/// Which sensors have contributed to a track, as bits.
enum TrackSource : std::uint8_t {
  kFromRadar = 1,
  kFromVisual = 2,
  kFromDatalink = 4,
  kFromTruth = 8,  ///< privileged state
  kFromInfrared = 16,
};

/// Uncertainty of position and velocity along one axis: the covariance of a two-state filter.
struct AxisCovariance {
  float position = 0;  ///< m^2
  float cross = 0;     ///< m^2/s
  float velocity = 0;  ///< m^2/s^2

  static constexpr auto fields() {
    return field_list(field("position", &AxisCovariance::position, "m2"),
                      field("cross", &AxisCovariance::cross),
                      field("velocity", &AxisCovariance::velocity));
  }
};

/// The same with the acceleration as a third state.
template <class Real>
struct CovarianceOf {
  Real position = 0;               ///< m^2
  Real cross = 0;                  ///< m^2/s, position with velocity
  Real velocity = 0;               ///< m^2/s^2
  Real position_acceleration = 0;  ///< m^2/s^2
  Real velocity_acceleration = 0;  ///< m^2/s^3
  Real acceleration = 0;           ///< m^2/s^4

  template <class To>
  [[nodiscard]] constexpr CovarianceOf<To> as() const {
    return {static_cast<To>(position),
            static_cast<To>(cross),
            static_cast<To>(velocity),
            static_cast<To>(position_acceleration),
            static_cast<To>(velocity_acceleration),
            static_cast<To>(acceleration)};
  }
  static constexpr auto fields() {
    using C = CovarianceOf;
    return field_list(field("position", &C::position, "m2"), field("cross", &C::cross),
                      field("velocity", &C::velocity),
                      field("position_acceleration", &C::position_acceleration),
                      field("velocity_acceleration", &C::velocity_acceleration),
                      field("acceleration", &C::acceleration));
  }
};
using TurningCovariance = CovarianceOf<float>;

/// What a track would be if its target were turning, beside what it would be if it flew straight.
struct Turning {
  TurningCovariance along{};   ///< along the line of sight
  TurningCovariance across{};  ///< each of the two axes across it
  Vec3f position{};            ///< m, from where the target would be if it flew straight
  Vec3f velocity{};            ///< m/s, likewise
  Vec3f acceleration{};        ///< m/s^2
  float probability = 0;       ///< that the target turns

  static constexpr auto fields() {
    return field_list(field("along", &Turning::along), field("across", &Turning::across),
                      field("position", &Turning::position, "m"),
                      field("velocity", &Turning::velocity, "m/s"),
                      field("acceleration", &Turning::acceleration, "m/s2"),
                      field("probability", &Turning::probability));
  }
};

/// What one player believes about one other. Position and velocity are in the local frame and hold
/// at `time`; position_at() carries them on. They are the mean over straight flight and turn. The
/// covariances hold at `time` too, the two sigmas at the last upkeep: they grow while nobody sees
/// the target.
struct Track {
  Vec3 position{};           ///< m, at `time`
  Vec3 velocity{};           ///< m/s
  double time = 0;           ///< s, of the last update
  double first_time = 0;     ///< s, of the first contact
  double sensed_time = 0;    ///< s, last contact by an own sensor; before the run if there is none
  double seen_time = 0;      ///< s, last contact by eye; before the run if there is none
  AxisCovariance along{};    ///< along the line of sight, if the target flies straight
  AxisCovariance across{};   ///< each of the two axes across it, likewise
  Turning turning{};         ///< and what if it turns
  float position_sigma = 0;  ///< m, 1-sigma along the worst axis
  float velocity_sigma = 0;  ///< m/s, 1-sigma along the worst axis
  TrackId id{};              ///< names the track in its owner's list; never reused there
  PlayerId truth{};          ///< who the last contact came from: for scoring and debrief only
  Identity identity = Identity::unknown;
  std::uint8_t sources = 0;      ///< sources ever seen, bits of TrackSource
  std::uint8_t fresh = 0;        ///< sources that updated it at `time`
  std::uint8_t hits = 0;         ///< contacts so far, saturating
  std::uint8_t confirmed = 0;    ///< 1 once enough contacts were associated
  std::uint8_t unanswered = 0;   ///< interrogations in a row without a reply, saturating
  std::uint8_t targeted_by = 0;  ///< bit i: member i of the flight said that this is its target
  std::uint8_t shot_by = 0;      ///< bit i: member i of the flight said it has a missile on its way
  std::array<TrackId, 2> absorbed{};  ///< the last two that were merged into it, the last one first

  /// Whether that is its name, or was that of one that was merged into it.
  [[nodiscard]] constexpr bool named(TrackId name) const {
    return name && (id == name || absorbed[0] == name || absorbed[1] == name);
  }

  static constexpr auto fields() {
    return field_list(
        field("position", &Track::position, "m"), field("velocity", &Track::velocity, "m/s"),
        field("time", &Track::time, "s"), field("first_time", &Track::first_time, "s"),
        field("sensed_time", &Track::sensed_time, "s"), field("seen_time", &Track::seen_time, "s"),
        field("along", &Track::along), field("across", &Track::across),
        field("turning", &Track::turning), field("position_sigma", &Track::position_sigma, "m"),
        field("velocity_sigma", &Track::velocity_sigma, "m/s"), field("id", &Track::id),
        field("truth", &Track::truth), field("identity", &Track::identity),
        field("sources", &Track::sources), field("fresh", &Track::fresh),
        field("hits", &Track::hits), field("confirmed", &Track::confirmed),
        field("unanswered", &Track::unanswered), field("targeted_by", &Track::targeted_by),
        field("shot_by", &Track::shot_by), field("absorbed", &Track::absorbed));
  }
};

/// Takes out of a list in a row what is `gone`, in order; the places behind it become empty.
template <class T, std::size_t N>
constexpr void drop_if(std::array<T, N>& items, std::uint32_t& count, const auto& gone) {
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < count; ++i)
    if (!gone(items[i]))
      items[kept++] = items[i];
  std::fill(items.begin() + kept, items.begin() + count, T{});
  count = kept;
}

inline constexpr std::size_t kMaxTracks = 16;

/// A time before any run: "never".
inline constexpr double kNever = -1e9;

/// The track file of one player, ordered by track id (age).
struct TrackFile {
  std::array<Track, kMaxTracks> tracks{};
  std::uint32_t count = 0;
  std::uint32_t next_id = 1;

  static constexpr auto fields() {
    return field_list(field("tracks", &TrackFile::tracks), field("count", &TrackFile::count),
                      field("next_id", &TrackFile::next_id));
  }
};

/// Where the target is believed to be at `time` (s), at constant velocity.
[[nodiscard]] constexpr Vec3 position_at(const Track& track, double time) {
  return track.position + (time - track.time) * track.velocity;
}

/// The track of that id, or that one with which it was merged; or null.
[[nodiscard]] constexpr const Track* find(const TrackFile& file, TrackId id) {
  for (std::uint32_t i = 0; i < file.count; ++i)
    if (file.tracks[i].named(id))
      return &file.tracks[i];
  return nullptr;
}

/// Who looks: what the trackers need to know about the own aircraft.
struct Ownship {
  Vec3 position{};  ///< m, local frame
  Vec3 velocity{};  ///< m/s, local frame
};

/// One measurement of one other player, in the local frame, with the errors of the sensor in it.
struct Contact {
  Vec3 position{};          ///< m
  Vec3 line{};              ///< unit vector from the sensor to `position`
  double range = 0;         ///< m
  double speed_along = 0;   ///< m/s, of the target over the ground along `line`; needs sigma_speed
  double sigma_along = 0;   ///< m, 1-sigma along the line
  double sigma_across = 0;  ///< m, 1-sigma in each direction across it
  double sigma_speed = 0;   ///< m/s, 1-sigma of speed_along; 0 if the sensor does not measure it
  PlayerId truth{};         ///< where the echo or the light came from
  TrackSource source = kFromRadar;
  Identity identity = Identity::unknown;  ///< if the look itself told
  bool interrogated = false;              ///< asked by IFF in this look; `identity` has the reply
  bool mate = false;                      ///< stands where one of the flight says it is
  bool bearing_only = false;  ///< `range` is a guess, and what goes with it; sigma_across / range
                              ///< is the error of the direction, rad
};

}  // namespace eyrie::model
