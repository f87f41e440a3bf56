// SPDX-License-Identifier: MIT
#pragma once
/// \file  Directions and places as a pilot sees them, and where each rank of a formation flies.
#include "core/describe.hpp"
#include "model/kinematics.hpp"

namespace eyrie::pilot {

/// Spacing from one place of the wall to the next; the defaults are the paper's.
struct Formation {
  double abreast = si(6000, "ft");  ///< m to the side
  double behind = si(1000, "ft");   ///< m back
  double below = si(500, "ft");     ///< m down

  static constexpr std::string_view type_name = "formation";
  static constexpr std::string_view help = "the wall formation: spacing from one place to the next";
  static constexpr auto params() {
    using F = Formation;
    return Lines{
        param("abreast", &F::abreast, "m", range(50, 50e3), "to the side of the lead, per place"),
        param("behind", &F::behind, "m", range(-50e3, 50e3), "behind the lead, per place"),
        param("below", &F::below, "m", range(-5e3, 5e3), "below the lead, per place")};
  }
};

/// Where a rank stands, in m forward, right and down of the lead's heading. Rank 2 is the first
/// place on the left (the paper's eagle2), 3 and 4 the first and second on the right, 5 the second
/// on the left, 6 the third on the right and so on outwards. Rank 1 is the lead itself.
[[nodiscard]] constexpr Vec3 formation_offset(const Formation& formation, std::uint32_t rank) {
  if (rank <= 1)
    return {};
  constexpr int kPlaces[] = {-1, 1, 2, -2, 3, -3, 4};
  const int place = kPlaces[(rank - 2) % 7];
  const double out = place < 0 ? -place : place;
  return {-out * formation.behind, place * formation.abreast, out * formation.below};
}

using eyrie::from_ned, eyrie::to_ned;

/// True bearing in (-pi, pi] of a NED vector; 0 if it has no horizontal part.
[[nodiscard]] inline double bearing_of(const Vec3& ned) {
  return wrap_pi(math::atan2(ned.y, ned.x));
}
/// Angle above the horizontal, rad in [-pi/2, pi/2].
[[nodiscard]] inline double elevation_of(const Vec3& ned) {
  return math::atan2(-ned.z, std::sqrt(ned.x * ned.x + ned.y * ned.y));
}

/// Both, in hardly more time than one.
[[nodiscard]] inline model::Bearing direction_of(const Vec3& ned) {
  using Two = math::Lanes<2>;
  const double level = std::sqrt(ned.x * ned.x + ned.y * ned.y);
  const Two angles = math::atan2(Two(Two::Vector{ned.y, -ned.z}), Two(Two::Vector{ned.x, level}));
  return {.azimuth = wrap_pi(angles.v[0]), .elevation = angles.v[1]};
}

/// m above the ellipsoid of a place `ned` metres away from the ownship. The Earth curves away below
/// the tangent plane by d2 / 2R: 0.5 m at 2.5 km, 970 m at 60 nmi.
[[nodiscard]] inline double altitude_of(const model::Kinematics& own, const Vec3& ned) {
  return own.altitude - ned.z + (ned.x * ned.x + ned.y * ned.y) / (2 * model::kEarthRadius);
}

/// Unit vector of the nose in NED axes; the velocity through the air points there too.
[[nodiscard]] inline Vec3 nose_of(const model::Kinematics& own) {
  const auto heading = math::sin_cos(own.heading);
  const auto pitch = math::sin_cos(own.pitch);
  return {pitch.cos * heading.cos, pitch.cos * heading.sin, -pitch.sin};
}

/// Seconds until something that moves at `speed` from the origin, straight, can be where something
/// that starts at `offset` and keeps `velocity` will be; nothing if it can never be there.
/// The collision triangle |offset + velocity t| = speed t: Shneydor, Missile Guidance and Pursuit
/// (1998), ch. 4, parallel navigation. The smaller positive root of
/// (v2 - speed2) t2 + 2 (offset . v) t + offset2 = 0, in the form that never cancels.
[[nodiscard]] inline std::optional<double> time_to_meet(const Vec3& offset, const Vec3& velocity,
                                                        double speed) {
  const double a = norm2(velocity) - speed * speed;
  const double b = dot(offset, velocity);
  const double c = norm2(offset);
  const double square = b * b - a * c;
  if (!(square >= 0))
    return std::nullopt;
  const double divisor = std::sqrt(square) - b;
  if (!(divisor > 1e-9 * (1 + std::fabs(b))))
    return std::nullopt;
  return c / divisor;
}

}  // namespace eyrie::pilot
