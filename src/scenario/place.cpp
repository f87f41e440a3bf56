// SPDX-License-Identifier: MIT
#include "scenario/place.hpp"

#include <fmt/format.h>

#include <cmath>

namespace eyrie::scenario {
namespace {

/// m; the local frame promises its accuracy so far out (docs/models/frames.md).
constexpr double kReach = 500e3;

}  // namespace

Vec3 at_altitude(const Reference& reference, double north, double east, double altitude) {
  // moving down by what the height is off converges by a factor of 1 - cos(tilt) < 0.4 % each time
  // the Earth is symmetric about the reference's meridian, its rounding is not: look east only
  Vec3 p{north, std::fabs(east), -altitude};
  for (int i = 0; i < 8; ++i)
    p.z += reference.altitude_at(p) - altitude;
  p.y = east;
  return p;
}

Vec3 resolve(const PlaceSpec& place, double altitude, const Reference& reference,
             const Location& where, Diagnostics& diagnostics) {
  const bool local = place.north && place.east;
  const bool geodetic = place.latitude && place.longitude;
  const bool any_local = place.north || place.east;
  const bool any_geodetic = place.latitude || place.longitude;
  if ((local && !any_geodetic) || (geodetic && !any_local)) {
    // the ground below it, straight through the Earth: the far side is far, too
    const Vec3 ground = local ? Vec3{*place.north, *place.east, 0}
                              : reference.to_local({*place.latitude, *place.longitude, 0});
    if (const double distance = norm(ground); distance > kReach) {
      diagnostics.error(where, fmt::format("this place is {:.0f} km from the reference point; the "
                                           "local frame reaches {:.0f} km",
                                           distance / 1000, kReach / 1000));
      return {};
    }
    return local ? at_altitude(reference, *place.north, *place.east, altitude)
                 : reference.to_local({*place.latitude, *place.longitude, altitude});
  }
  diagnostics.error(where, any_local && any_geodetic
                               ? "a place is given by north and east or by latitude and longitude, "
                                 "not by both"
                           : any_local || any_geodetic
                               ? "a place needs both north and east, or both latitude and longitude"
                               : "no place is given: north and east, or latitude and longitude");
  return {};
}

}  // namespace eyrie::scenario
