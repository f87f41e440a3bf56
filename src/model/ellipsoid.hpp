// SPDX-License-Identifier: MIT
#pragma once
/// \file  WGS-84, and where a point lies above it, for one point or for several side by side.
#include "model/frames.hpp"

namespace eyrie {
namespace ellipsoid {

// NIMA TR8350.2, 3rd ed., table 3.1
inline constexpr double kSemiMajor = 6378137;
inline constexpr double kFlattening = 1 / 298.257223563;
inline constexpr double kAxisRatio = 1 - kFlattening;
inline constexpr double kSemiMinor = kSemiMajor * kAxisRatio;
inline constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);
inline constexpr double kSecondEccentricity2 = kEccentricity2 / (kAxisRatio * kAxisRatio);

inline constexpr double kOnAxis = 0x1p-10;  // metres from the Earth's axis

template <class Real>
struct Meridian {
  Real sin_lat, cos_lat, altitude;
};

/// Geodetic latitude and height of a point at some distance from the Earth's axis and above the
/// equator. One step of B. R. Bowring, "Transformation from spatial to geographical coordinates",
/// Survey Review 23 (1976), with the angles kept as sine and cosine.
template <class Real>
Meridian<Real> meridian_of(const Real& from_axis, const Real& z) {
  // parametric latitude of the point where the ellipsoid is met on the way to the centre
  const Real flat = kAxisRatio * from_axis;
  const Real per = 1 / math::sqrt(flat * flat + z * z);
  const Real sin_beta = z * per, cos_beta = flat * per;

  const Real up = z + kSecondEccentricity2 * kSemiMinor * (sin_beta * sin_beta * sin_beta);
  const Real out = from_axis - kEccentricity2 * kSemiMajor * (cos_beta * cos_beta * cos_beta);
  const Real scale = 1 / math::sqrt(up * up + out * out);
  const Real sin_lat = up * scale, cos_lat = out * scale;

  // this form has no first-order error in latitude, and no pole
  const Real altitude = from_axis * cos_lat + z * sin_lat -
                        kSemiMajor * math::sqrt(1 - kEccentricity2 * sin_lat * sin_lat);
  return {sin_lat, cos_lat, altitude};
}

template <class Real>
Real distance_from_axis(const Vec3Of<Real>& ecef) {
  return math::sqrt(ecef.x * ecef.x + ecef.y * ecef.y);
}

}  // namespace ellipsoid

template <class Real>
VerticalOf<Real> Reference::vertical_at(const Vec3Of<Real>& local) const {
  const Vec3Of<Real> origin{origin_ecef_.x, origin_ecef_.y, origin_ecef_.z};
  const Vec3Of<Real> ecef = origin + to_ecef_ * local;
  const Real from_axis = ellipsoid::distance_from_axis(ecef);
  const ellipsoid::Meridian<Real> place = ellipsoid::meridian_of(from_axis, ecef.z);

  // the east axis is level: what the reference's row_y is at its own longitude
  const auto off_axis = from_axis > ellipsoid::kOnAxis;
  const Vec3& east = from_ecef_.row_y;
  const Vec3Of<Real> east_ecef{math::select(off_axis, -ecef.y / from_axis, east.x),
                               math::select(off_axis, ecef.x / from_axis, east.y),
                               math::select(off_axis, 0, east.z)};
  const Vec3Of<Real> down_ecef{-place.cos_lat * east_ecef.y, place.cos_lat * east_ecef.x,
                               -place.sin_lat};

  const Vec3Of<Real> to_east = from_ecef_ * east_ecef, down = from_ecef_ * down_ecef;
  return {.north = cross(to_east, down), .east = to_east, .down = down, .altitude = place.altitude};
}

}  // namespace eyrie
