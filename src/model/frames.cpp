// SPDX-License-Identifier: MIT
#include "model/frames.hpp"

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/Geocentric.hpp>

#include "core/assert.hpp"

namespace eyrie {
namespace {

// WGS-84: NIMA TR8350.2, 3rd ed., table 3.1
constexpr double kSemiMajor = 6378137;
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kAxisRatio = 1 - kFlattening;
constexpr double kSemiMinor = kSemiMajor * kAxisRatio;
constexpr double kEccentricity2 = kFlattening * (2 - kFlattening);
constexpr double kSecondEccentricity2 = kEccentricity2 / (kAxisRatio * kAxisRatio);

constexpr double kGrid = 0x1p-10;    // metres
constexpr double kOnAxis = 0x1p-10;  // metres from the Earth's axis

double snap(double metres) {
  return std::nearbyint(metres / kGrid) * kGrid;
}

Vec3 ecef_of(const Geodetic& place) {
  const auto [sin_lat, cos_lat] = math::sin_cos(place.latitude);
  const auto [sin_lon, cos_lon] = math::sin_cos(place.longitude);
  const double normal = kSemiMajor / std::sqrt(1 - kEccentricity2 * sin_lat * sin_lat);
  const double from_axis = (normal + place.altitude) * cos_lat;
  return {from_axis * cos_lon, from_axis * sin_lon,
          (normal * (kAxisRatio * kAxisRatio) + place.altitude) * sin_lat};
}

struct Meridian {
  double sin_lat, cos_lat, altitude;
};

/// Geodetic latitude and height of a point at some distance from the Earth's axis and above the
/// equator. One step of B. R. Bowring, "Transformation from spatial to geographical coordinates",
/// Survey Review 23 (1976), with the angles kept as sine and cosine.
Meridian meridian_of(double from_axis, double z) {
  // parametric latitude of the point where the ellipsoid is met on the way to the centre
  const double flat = kAxisRatio * from_axis;
  const double per = 1 / std::sqrt(flat * flat + z * z);
  const double sin_beta = z * per, cos_beta = flat * per;

  const double up = z + kSecondEccentricity2 * kSemiMinor * (sin_beta * sin_beta * sin_beta);
  const double out = from_axis - kEccentricity2 * kSemiMajor * (cos_beta * cos_beta * cos_beta);
  const double scale = 1 / std::sqrt(up * up + out * out);
  const double sin_lat = up * scale, cos_lat = out * scale;

  // this form has no first-order error in latitude, and no pole
  const double altitude = from_axis * cos_lat + z * sin_lat -
                          kSemiMajor * std::sqrt(1 - kEccentricity2 * sin_lat * sin_lat);
  return {sin_lat, cos_lat, altitude};
}

double distance_from_axis(const Vec3& ecef) {
  return std::sqrt(ecef.x * ecef.x + ecef.y * ecef.y);
}

}  // namespace

Reference::Reference(const Geodetic& origin) : origin_(origin) {
  EYRIE_THROW_UNLESS(std::fabs(origin.latitude) <= kPi / 2, "latitude is in [-90, 90] deg");
  EYRIE_THROW_UNLESS(std::fabs(origin.longitude) <= kTau, "longitude is in [-360, 360] deg");
  EYRIE_THROW_UNLESS(origin.altitude >= -10e3 && origin.altitude <= 100e3,
                     "altitude is in [-10, 100] km");
  origin_ecef_ = ecef_of(origin);
  const auto [sin_lat, cos_lat] = math::sin_cos(origin.latitude);
  const auto [sin_lon, cos_lon] = math::sin_cos(origin.longitude);
  from_ecef_ = {{-sin_lat * cos_lon, -sin_lat * sin_lon, cos_lat},
                {-sin_lon, cos_lon, 0},
                {-cos_lat * cos_lon, -cos_lat * sin_lon, -sin_lat}};
  to_ecef_ = transpose(from_ecef_);
}

Geodetic Reference::to_geodetic(const Vec3& local) const {
  const Vec3 ecef = to_ecef(local);
  double latitude = 0, longitude = 0, altitude = 0;
  GeographicLib::Geocentric::WGS84().Reverse(ecef.x, ecef.y, ecef.z, latitude, longitude, altitude);
  return {radians(latitude), radians(longitude), altitude};
}

Vec3 Reference::to_local(const Geodetic& place) const {
  const Vec3 exact = from_ecef_ * (ecef_of(place) - origin_ecef_);
  return {snap(exact.x), snap(exact.y), snap(exact.z)};
}

Vertical Reference::vertical_at(const Vec3& local) const {
  const Vec3 ecef = to_ecef(local);
  const double from_axis = distance_from_axis(ecef);
  const Meridian place = meridian_of(from_axis, ecef.z);

  // the east axis is level: what the reference's row_y is at its own longitude
  Vec3 east_ecef = from_ecef_.row_y;
  if (from_axis > kOnAxis)
    east_ecef = {-ecef.y / from_axis, ecef.x / from_axis, 0};
  const Vec3 down_ecef{-place.cos_lat * east_ecef.y, place.cos_lat * east_ecef.x, -place.sin_lat};

  const Vec3 east = from_ecef_ * east_ecef, down = from_ecef_ * down_ecef;
  return {.north = cross(east, down), .east = east, .down = down, .altitude = place.altitude};
}

double Reference::altitude_at(const Vec3& local) const {
  const Vec3 ecef = to_ecef(local);
  return meridian_of(distance_from_axis(ecef), ecef.z).altitude;
}

MapPlace Map::at(const Geodetic& place) const {
  const GeographicLib::AzimuthalEquidistant projection(GeographicLib::Geodesic::WGS84());
  MapPlace to;
  double azimuth = 0, scale = 0;  // azimuth: of the geodesic from the middle where it arrives, deg
  projection.Forward(degrees(middle_.latitude), degrees(middle_.longitude), degrees(place.latitude),
                     degrees(place.longitude), to.east, to.north, azimuth, scale);
  if (to.east * to.east + to.north * to.north > 1)  // nearer, the direction means nothing
    to.turn = wrap_pi(math::atan2(to.east, to.north) - radians(azimuth));
  return to;
}

}  // namespace eyrie
