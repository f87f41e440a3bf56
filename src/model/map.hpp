// SPDX-License-Identifier: MIT
#pragma once
#include "model/frames.hpp"

namespace eyrie {

/// A place on a map: metres east and north of its middle.
struct MapPlace {
  double east = 0, north = 0;
  /// rad to add to a true heading there to get the heading on the map.
  double turn = 0;
};

/// A flat map around a place, for people to look at: distances and directions from the middle are
/// true (azimuthal equidistant, Snyder, Map Projections, USGS 1395, 1987, p. 191). For the boundary
/// only, never in a step: GeographicLib, with libm inside.
class Map {
 public:
  explicit Map(const Geodetic& middle) : middle_(middle) {}

  [[nodiscard]] const Geodetic& middle() const { return middle_; }
  [[nodiscard]] MapPlace at(const Geodetic& place) const;

 private:
  Geodetic middle_;
};

}  // namespace eyrie
