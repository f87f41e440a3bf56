// SPDX-License-Identifier: MIT
#pragma once
/// \file  The reference point of a scenario and its local axes; a flat map for people.
#include "core/vec.hpp"

namespace eyrie {

/// A place on or above the WGS-84 ellipsoid: radians, metres above the ellipsoid.
struct Geodetic {
  double latitude = 0, longitude = 0, altitude = 0;

  friend constexpr bool operator==(const Geodetic&, const Geodetic&) = default;
};

/// The geodetic frame at one place, its axes written in local axes: unit vectors, `down` along the
/// normal of the ellipsoid. `altitude` is metres above the ellipsoid.
template <class Real>
struct VerticalOf {
  Vec3Of<Real> north{1, 0, 0}, east{0, 1, 0}, down{0, 0, 1};
  Real altitude = 0;
};
using Vertical = VerticalOf<double>;

/// By how much (rad, clockwise) north turns between two places close together, of which the first
/// has that `east` and the second that `north`: who flies straight on has so much less heading. To
/// the third order; seen from a pole places less than a few steps away are not close.
template <class Real>
[[nodiscard]] Real turn_of_north(const Vec3Of<Real>& east, const Vec3Of<Real>& north) {
  const Real sine = dot(north, east);
  return sine * (1 + sine * sine * (1.0 / 6));
}

/// Local axes to the geodetic NED axes at a place or a player.
[[nodiscard]] constexpr Vec3 to_ned(const auto& at, const Vec3& local) {
  return {dot(at.north, local), dot(at.east, local), dot(at.down, local)};
}
/// And back.
[[nodiscard]] constexpr Vec3 from_ned(const auto& at, const Vec3& ned) {
  return ned.x * at.north + ned.y * at.east + ned.z * at.down;
}

/// The place that a scenario is flown around. Local axes are north, east and down at that place, a
/// rigid rotation and shift of the Earth-centred axes: distances and angles are true, and the Earth
/// curves away below the plane. docs/models/frames.md has the model and what it is worth.
///
/// All but to_geodetic is made of core/math and + - * / sqrt, so it is the same on every machine.
class Reference {
 public:
  /// At latitude 0, longitude 0, altitude 0.
  Reference() : Reference(Geodetic{}) {}
  /// Latitude in [-pi/2, pi/2], longitude in [-2 pi, 2 pi], altitude in [-10 km, 100 km]; otherwise
  /// std::logic_error. At a pole the longitude says where local north points.
  explicit Reference(const Geodetic& origin);

  [[nodiscard]] const Geodetic& origin() const { return origin_; }

  /// For the boundary only, never in a step: GeographicLib, with libm inside. Exact to a nanometre;
  /// longitude in [-pi, pi], and 0 on the Earth's axis.
  [[nodiscard]] Geodetic to_geodetic(const Vec3& local) const;
  /// For the boundary: the result is on a grid of 2^-10 m, so places that a file gives to a
  /// millimetre are the same place.
  [[nodiscard]] Vec3 to_local(const Geodetic& place) const;

  /// A position, Earth-centred and Earth-fixed, metres.
  [[nodiscard]] Vec3 to_ecef(const Vec3& local) const { return origin_ecef_ + to_ecef_ * local; }

  [[nodiscard]] Vec3 from_ecef(const Vec3& ecef) const {
    return from_ecef_ * (ecef - origin_ecef_);
  }

  /// A direction or a velocity in the axes of to_ecef(), and back.
  [[nodiscard]] Vec3 turned_to_ecef(const Vec3& local) const { return to_ecef_ * local; }
  [[nodiscard]] Vec3 turned_from_ecef(const Vec3& ecef) const { return from_ecef_ * ecef; }

  /// Height above the ellipsoid and the geodetic axes at a place, for altitudes from -10 km to
  /// 1000 km. On the Earth's axis (within 2^-10 m) north and east are those of the reference's
  /// longitude.
  [[nodiscard]] Vertical vertical_at(const Vec3& local) const;
  /// Of several places side by side, with the same bits: model/ellipsoid.hpp.
  template <class Real>
  [[nodiscard]] VerticalOf<Real> vertical_at(const Vec3Of<Real>& local) const;
  /// vertical_at(local).altitude, bit for bit, for less work.
  [[nodiscard]] double altitude_at(const Vec3& local) const;

 private:
  Geodetic origin_;
  Vec3 origin_ecef_;
  Mat3 to_ecef_, from_ecef_;
};

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
