// SPDX-License-Identifier: MIT
#include "model/map.hpp"

#include <GeographicLib/AzimuthalEquidistant.hpp>

#include "core/angle.hpp"
#include "core/math.hpp"

namespace eyrie {

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
