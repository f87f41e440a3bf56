// SPDX-License-Identifier: MIT
#include "model/frames.hpp"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/angle.hpp"
#include "core/hash.hpp"

// Against GeographicLib, which solves the same problem with libm and without our approximations.

namespace eyrie {
namespace {

constexpr double kDeg = kPi / 180;

const GeographicLib::Geocentric& wgs84() {
  return GeographicLib::Geocentric::WGS84();
}

/// What GeographicLib says about a place.
struct Truth {
  double altitude;
  Vec3 north_ecef, east_ecef, down_ecef;

  explicit Truth(const Vec3& ecef) {
    double latitude = 0, longitude = 0;
    std::vector<double> m(9);
    wgs84().Reverse(ecef.x, ecef.y, ecef.z, latitude, longitude, altitude, m);
    east_ecef = {m[0], m[3], m[6]};
    north_ecef = {m[1], m[4], m[7]};
    down_ecef = {-m[2], -m[5], -m[8]};
  }
};

/// A direction in Earth-centred axes: the difference of two positions so far apart that their last
/// bits do not count.
Vec3 turned_to_ecef(const Reference& reference, const Vec3& direction) {
  return (reference.to_ecef(1e9 * direction) - reference.to_ecef({})) / 1e9;
}

double scaled(std::int32_t n, double range) {
  return range * n / 2147483648.0;
}

RC_GTEST_PROP(Reference, KnowsHeightAndAxesWithin500Km,
              (std::int32_t a, std::int32_t b, std::int32_t c, std::uint16_t d, std::int32_t e)) {
  const Reference reference({scaled(a, kPi / 2), scaled(b, kPi), 0});
  const double distance = 500e3 * d / 65536, bearing = scaled(c, kPi);
  const double altitude = 49.75e3 + scaled(e, 50.25e3);  // -500 m to 100 km, near enough
  const Vec3 local{distance * std::cos(bearing), distance * std::sin(bearing),
                   distance * distance / (2 * 6.371e6) - altitude};
  const Vec3 ecef = reference.to_ecef(local);
  const Truth truth(ecef);
  const Vertical vertical = reference.vertical_at(local);

  RC_ASSERT(std::fabs(vertical.altitude - truth.altitude) < 2e-8);
  RC_ASSERT(reference.altitude_at(local) == vertical.altitude);
  RC_ASSERT(norm(turned_to_ecef(reference, vertical.down) - truth.down_ecef) < 2e-11);
  if (std::hypot(ecef.x, ecef.y) > 1000) {
    RC_ASSERT(norm(turned_to_ecef(reference, vertical.north) - truth.north_ecef) < 2e-11);
    RC_ASSERT(norm(turned_to_ecef(reference, vertical.east) - truth.east_ecef) < 2e-11);
  }
  // right-handed and square, wherever it is
  RC_ASSERT(norm(cross(vertical.north, vertical.east) - vertical.down) < 1e-15);
  RC_ASSERT(std::fabs(norm(vertical.north) - 1) < 1e-15);
}

RC_GTEST_PROP(Reference, ConvertsPlacesAsALocalCartesianFrameDoes,
              (std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, std::int32_t e)) {
  const Geodetic origin{scaled(a, kPi / 2), scaled(b, kPi), scaled(c, 5000)};
  const Reference reference(origin);
  const GeographicLib::LocalCartesian peer(degrees(origin.latitude), degrees(origin.longitude),
                                           origin.altitude, wgs84());
  const Geodetic place{std::clamp(origin.latitude + scaled(d, 0.08), -kPi / 2, kPi / 2),
                       origin.longitude + scaled(e, 0.08), scaled(e, 20e3)};
  double east = 0, north = 0, up = 0;
  peer.Forward(degrees(place.latitude), degrees(place.longitude), place.altitude, east, north, up);
  const Vec3 local = reference.to_local(place);
  RC_ASSERT(norm(local - Vec3{north, east, -up}) < 0.001);  // half a grid step in each axis

  const Geodetic back = reference.to_geodetic(local);
  RC_ASSERT(std::fabs(back.altitude - place.altitude) < 0.001);
  RC_ASSERT(norm(reference.to_local(back) - local) == 0);
}

RC_GTEST_PROP(Reference, KeepsDistancesAndComesBack,
              (std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, std::int32_t e)) {
  const Reference reference({scaled(a, kPi / 2), scaled(b, kPi), 0});
  const Vec3 p{scaled(c, 500e3), scaled(d, 500e3), scaled(e, 30e3)};
  const Vec3 q{scaled(d, 500e3), scaled(e, 500e3), scaled(c, 30e3)};
  const double apart = norm(reference.to_ecef(p) - reference.to_ecef(q));
  RC_ASSERT(std::fabs(apart - norm(p - q)) < 1e-8);

  const Vertical at = reference.vertical_at(p);
  RC_ASSERT(norm(from_ned(at, to_ned(at, q)) - q) < 1e-9);
}

TEST(Reference, HasTheDefiningPointsOfTheEllipsoid) {
  const Reference gulf_of_guinea;
  EXPECT_EQ(gulf_of_guinea.to_ecef({}), (Vec3{6378137, 0, 0}));
  EXPECT_EQ(gulf_of_guinea.to_ecef({0, 0, -1000}), (Vec3{6379137, 0, 0}));
  EXPECT_NEAR(gulf_of_guinea.altitude_at({0, 0, -1000}), 1000, 1e-9);

  const Reference pole({kPi / 2, 0, 0});
  EXPECT_NEAR(pole.to_ecef({}).z, 6356752.314245179, 1e-8);  // TR8350.2, table 3.3
}

TEST(Reference, IsLevelAtItsOrigin) {
  for (const double latitude : {-90.0, -89.0, -33.0, 0.0, 45.0, 90.0})
    for (const double longitude : {-180.0, -77.0, 0.0, 12.5, 180.0}) {
      const Geodetic origin{latitude * kDeg, longitude * kDeg, 1234.5};
      const Reference reference(origin);
      EXPECT_EQ(reference.origin(), origin);
      const Vertical at = reference.vertical_at({});
      EXPECT_LT(norm(at.north - Vec3{1, 0, 0}), 1e-12) << latitude << ", " << longitude;
      EXPECT_LT(norm(at.east - Vec3{0, 1, 0}), 1e-12) << latitude << ", " << longitude;
      EXPECT_LT(norm(at.down - Vec3{0, 0, 1}), 1e-12) << latitude << ", " << longitude;
      EXPECT_NEAR(at.altitude, 1234.5, 1e-8);
      EXPECT_EQ(reference.to_local(origin), Vec3{});
    }
}

TEST(Reference, SeesTheEarthCurveAway) {
  // 500 km along the plane: the height is that of a circle of the radius of curvature in the
  // meridian, a (1 - e^2) / (1 - e^2 sin^2)^(3/2) = 6367.4 km at 45 deg
  const Reference reference({45 * kDeg, 0, 0});
  EXPECT_NEAR(reference.altitude_at({500e3, 0, 0}), std::hypot(6367.4e3, 500e3) - 6367.4e3, 60);
  const Vertical there = reference.vertical_at({500e3, 0, 0});
  EXPECT_NEAR(angle_between(there.down, Vec3{0, 0, 1}), std::atan(500e3 / 6367.4e3), 1e-4);
}

TEST(Reference, CrossesTheAntimeridian) {
  const Reference reference({10 * kDeg, 179.9 * kDeg, 0});
  const Vec3 east = reference.to_local({10 * kDeg, -179.9 * kDeg, 0});
  const Vec3 also_east = reference.to_local({10 * kDeg, 180.1 * kDeg, 0});
  EXPECT_EQ(east, also_east);
  EXPECT_NEAR(east.y, 21.9e3, 0.1e3);
  EXPECT_NEAR(reference.to_geodetic(east).longitude, -179.9 * kDeg, 1e-9);
  const Vertical there = reference.vertical_at(east);
  EXPECT_NEAR(there.east.y, 1, 1e-5);
  EXPECT_NEAR(there.altitude, 0, 1e-3);
}

TEST(Reference, FliesOverThePole) {
  const double longitude = 30 * kDeg;
  const Reference pole({90 * kDeg, longitude, 0});
  // local north at the pole points along the reference's longitude, away from it
  const Geodetic ahead = pole.to_geodetic({-1000, 0, 0});
  EXPECT_NEAR(ahead.longitude, longitude, 1e-9);
  // beyond the pole north is behind and east is on the other hand
  const Vertical beyond = pole.vertical_at({1000, 0, 0});
  EXPECT_NEAR(beyond.north.x, -1, 1e-6);
  EXPECT_NEAR(beyond.east.y, -1, 1e-6);
  const Vertical before = pole.vertical_at({-1000, 0, 0});
  EXPECT_NEAR(before.north.x, 1, 1e-6);
  EXPECT_NEAR(before.east.y, 1, 1e-6);
  // on the axis, where there is no east, the reference's own stands in at every height
  const Vertical above = pole.vertical_at({0, 0, -20e3});
  EXPECT_LT(norm(above.north - Vec3{1, 0, 0}), 1e-15);
  EXPECT_LT(norm(above.east - Vec3{0, 1, 0}), 1e-15);
  EXPECT_NEAR(above.altitude, 20e3, 1e-8);
}

TEST(Reference, SnapsPlacesToAGrid) {
  const Reference reference({0.7, 0.3, 0});
  const Vec3 local = reference.to_local({0.7123456789, 0.3456789, 5432.1});
  for (const double x : {local.x, local.y, local.z})
    EXPECT_EQ(x * 1024, std::floor(x * 1024));
}

TEST(Reference, RefusesPlacesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Reference({1.6, 0, 0}), std::logic_error);
  EXPECT_THROW(Reference({0, 7, 0}), std::logic_error);
  EXPECT_THROW(Reference({0, 0, 2e5}), std::logic_error);
  EXPECT_THROW(Reference({nan, 0, 0}), std::logic_error);
  EXPECT_THROW(Reference({0, nan, 0}), std::logic_error);
  EXPECT_THROW(Reference({0, 0, nan}), std::logic_error);
}

TEST(Reference, GivesTheSameBitsEverywhere) {
  Hasher hasher;
  const auto see = [&](double x) { hasher.word(std::bit_cast<std::uint64_t>(x)); };
  for (int i = 0; i < 1000; ++i) {
    const Reference reference({(i - 500) * 0x1p-9, i * 0x1p-8, 1.0 * i});
    const Vec3 local = reference.to_local({(i - 497) * 0x1p-9, (i + 5) * 0x1p-8, 10.0 * i});
    const Vertical at = reference.vertical_at(local);
    for (const Vec3& v : {local, at.north, at.east, at.down})
      for (const double x : {v.x, v.y, v.z})
        see(x);
    see(at.altitude);
  }
  EXPECT_EQ(hasher.value(), 0xcd322880506d23e8u) << std::hex << hasher.value();
}

TEST(Map, IsTrueFromItsMiddle) {
  const Map map({.latitude = radians(33), .longitude = radians(-68)});
  const MapPlace middle = map.at(map.middle());
  EXPECT_NEAR(middle.east, 0, 1e-6);
  EXPECT_NEAR(middle.north, 0, 1e-6);
  EXPECT_EQ(middle.turn, 0);
  // one minute of latitude at 33 degrees: 1848.4 m (WGS-84)
  const MapPlace north = map.at({.latitude = radians(33 + 1.0 / 60), .longitude = radians(-68)});
  EXPECT_NEAR(north.north, 1848.5, 0.5);
  EXPECT_NEAR(north.east, 0, 1e-6);
}

TEST(Map, TurnsHeadingsWhereMeridiansLean) {
  const Map map({.latitude = radians(33), .longitude = radians(-68)});
  // two degrees of longitude east of the middle a meridian leans by about 2 sin(33) degrees
  const Geodetic place{.latitude = radians(33), .longitude = radians(-66)};
  const MapPlace at = map.at(place);
  const MapPlace ahead = map.at({.latitude = radians(33.001), .longitude = radians(-66)});
  const double heading_on_map = std::atan2(ahead.east - at.east, ahead.north - at.north);
  EXPECT_NEAR(at.turn, heading_on_map, 1e-3);
  EXPECT_NEAR(degrees(at.turn), -2 * std::sin(radians(33)), 0.1);
}

}  // namespace
}  // namespace eyrie
