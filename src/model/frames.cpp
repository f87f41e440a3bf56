// SPDX-License-Identifier: MIT
#include "model/frames.hpp"

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/Geocentric.hpp>

#include "core/assert.hpp"
#include "model/ellipsoid.hpp"

namespace eyrie {
using namespace ellipsoid;
namespace {

constexpr double kGrid = 0x1p-10;  // metres

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
  return vertical_at<double>(local);
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
