// SPDX-License-Identifier: MIT
#include "scenario/assemble.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <optional>
#include <string>

#include "core/angle.hpp"

namespace eyrie::scenario {
namespace {

const Reference kReference({radians(33), radians(-68), 0});
const Location kHere{"a.yaml", 4, 2};

struct Resolved {
  Vec3 place;
  std::string mistakes;
};

Resolved resolved(const PlaceSpec& spec, double altitude = 0,
                  const Reference& reference = kReference) {
  Diagnostics diagnostics;
  Resolved result;
  result.place = resolve(spec, altitude, reference, kHere, diagnostics);
  result.mistakes = diagnostics.text();
  return result;
}

PlaceSpec local(double north, double east) {
  PlaceSpec spec;
  spec.north = north;
  spec.east = east;
  return spec;
}
PlaceSpec geodetic(double latitude, double longitude) {
  PlaceSpec spec;
  spec.latitude = radians(latitude);
  spec.longitude = radians(longitude);
  return spec;
}

TEST(AtAltitude, IsExactEverywhereWithinReach) {
  for (const double latitude : {0.0, 33.0, -60.0, 90.0}) {
    const Reference reference({radians(latitude), radians(10), 0});
    for (double north = -350e3; north <= 350e3; north += 50e3)
      for (double east = -350e3; east <= 350e3; east += 50e3)
        for (const double altitude : {0.0, 123.456, 7620.0, 30e3}) {
          const Vec3 p = at_altitude(reference, north, east, altitude);
          ASSERT_EQ(p.x, north);
          ASSERT_EQ(p.y, east);
          // GeographicLib stands outside of what the loop converges on
          ASSERT_NEAR(reference.to_geodetic(p).altitude, altitude, 1e-6) << north << " " << east;
        }
  }
}

TEST(AtAltitude, MirrorsPlacesToTheBit) {
  for (const double north : {0.0, 12345.678, -98765.4})
    for (const double east : {1.0, 60.2 * 1852, 333e3})
      for (const double altitude : {0.0, 25000 * 0.3048}) {
        const Vec3 right = at_altitude(kReference, north, east, altitude);
        const Vec3 left = at_altitude(kReference, north, -east, altitude);
        EXPECT_EQ(right.z, left.z) << north << " " << east;
      }
}

TEST(Resolve, TakesLocalPlacesAsTheyAre) {
  const auto [p, mistakes] = resolved(local(1000, -2000), 500);
  EXPECT_EQ(mistakes, "");
  EXPECT_EQ(p.x, 1000);
  EXPECT_EQ(p.y, -2000);
  EXPECT_NEAR(kReference.altitude_at(p), 500, 1e-6);
}

TEST(Resolve, AgreesWithGeographicLibOnGeodeticPlaces) {
  const GeographicLib::LocalCartesian other(33, -68, 0);
  for (const double latitude : {31.0, 33.0, 36.1})
    for (const double longitude : {-71.1, -68.0, -65.2}) {
      const auto [p, mistakes] = resolved(geodetic(latitude, longitude), 6096);
      ASSERT_EQ(mistakes, "");
      double east = 0, north = 0, up = 0;
      other.Forward(latitude, longitude, 6096, east, north, up);
      EXPECT_NEAR(p.x, north, 1e-3);
      EXPECT_NEAR(p.y, east, 1e-3);
      EXPECT_NEAR(p.z, -up, 1e-3);
    }
}

TEST(Resolve, RefusesHalfPlacesAndTwoPlacesInOne) {
  const auto without = [](auto member, PlaceSpec spec) {
    spec.*member = std::nullopt;
    return resolved(spec).mistakes;
  };
  const std::string half =
      "a.yaml:4:2: a place needs both north and east, or both latitude and longitude";
  EXPECT_EQ(without(&PlaceSpec::north, local(1, 2)), half);
  EXPECT_EQ(without(&PlaceSpec::east, local(1, 2)), half);
  EXPECT_EQ(without(&PlaceSpec::latitude, geodetic(33, -68)), half);
  EXPECT_EQ(without(&PlaceSpec::longitude, geodetic(33, -68)), half);

  const std::string both =
      "a.yaml:4:2: a place is given by north and east or by latitude and longitude, not by both";
  PlaceSpec spec = local(1, 2);
  spec.latitude = 0.5;
  EXPECT_EQ(resolved(spec).mistakes, both);
  spec.longitude = -1.2;
  EXPECT_EQ(resolved(spec).mistakes, both);
  spec.north = std::nullopt;
  EXPECT_EQ(resolved(spec).mistakes, both);

  EXPECT_EQ(resolved({}).mistakes,
            "a.yaml:4:2: no place is given: north and east, or latitude and longitude");
}

TEST(Resolve, RefusesPlacesBeyondTheLocalFrame) {
  EXPECT_EQ(resolved(geodetic(33, -62.7)).mistakes, "");
  EXPECT_EQ(resolved(geodetic(33, -62.5)).mistakes,
            "a.yaml:4:2: this place is 514 km from the reference point; the local frame reaches "
            "500 km");
  EXPECT_EQ(resolved(local(300e3, 400e3)).mistakes, "");
  EXPECT_EQ(resolved(local(400e3, 400e3)).mistakes,
            "a.yaml:4:2: this place is 566 km from the reference point; the local frame reaches "
            "500 km");
  // seen from above, the far side of the Earth is near: through the Earth it is not
  EXPECT_EQ(resolved(geodetic(-33, 112)).mistakes,
            "a.yaml:4:2: this place is 12744 km from the reference point; the local frame reaches "
            "500 km");
}

TEST(Resolve, MeasuresTheReachAtTheGround) {
  PlaceSpec spec = local(500e3, 0);
  EXPECT_EQ(resolved(spec, 30e3).mistakes, "") << "height costs no reach";
}

}  // namespace
}  // namespace eyrie::scenario
