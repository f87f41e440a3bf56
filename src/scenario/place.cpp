// SPDX-License-Identifier: MIT
#include "scenario/place.hpp"

#include <fmt/format.h>

namespace eyrie::scenario {

Vec3 at_altitude(const Reference& reference, double north, double east, double altitude) {
  // moving down by what the height is off converges by a factor of 1 - cos(tilt) < 0.4 % each time
  Vec3 p{north, east, -altitude};
  for (int i = 0; i < 8; ++i)
    p.z += reference.altitude_at(p) - altitude;
  return p;
}

Vec3 resolve(const PlaceSpec& place, double altitude, const Reference& reference,
             const Location& where, Diagnostics& diagnostics) {
  const bool local = place.north && place.east;
  const bool geodetic = place.latitude && place.longitude;
  const bool any_local = place.north || place.east;
  const bool any_geodetic = place.latitude || place.longitude;
  if (local && !any_geodetic)
    return at_altitude(reference, *place.north, *place.east, altitude);
  if (geodetic && !any_local) {
    const Vec3 p = reference.to_local({*place.latitude, *place.longitude, altitude});
    const double distance = norm(Vec3{p.x, p.y, 0});
    if (distance > 500e3)
      diagnostics.error(where, fmt::format("this place is {:.0f} km from the reference point; the "
                                           "local frame reaches 500 km",
                                           distance / 1000));
    return p;
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
