// SPDX-License-Identifier: MIT
#pragma once
/// \file  Places on the Earth by the textbook, for readers that share nothing with Eyrie: neither
/// its frames nor its mathematics, nor GeographicLib. Hofmann-Wellenhof, Lichtenegger & Wasle, GNSS
/// (2008), eqs. 8.1 (Earth-centered) and 8.22 (local).
#include <array>
#include <cmath>

namespace eyrie::test {

/// Degrees, and meters above the ellipsoid.
struct Place {
  double longitude = 0, latitude = 0, altitude = 0;
};

using Meters = std::array<double, 3>;

[[nodiscard]] inline Meters earth_centered(const Place& p) {
  constexpr double kDegree = 0.017453292519943295, kA = 6378137, kF = 1 / 298.257223563;
  const double b = kA * (1 - kF), phi = p.latitude * kDegree, lambda = p.longitude * kDegree;
  const double n = kA * kA / std::hypot(kA * std::cos(phi), b * std::sin(phi));
  return {(n + p.altitude) * std::cos(phi) * std::cos(lambda),
          (n + p.altitude) * std::cos(phi) * std::sin(lambda),
          (b * b / (kA * kA) * n + p.altitude) * std::sin(phi)};
}

/// A difference of two Earth-centered places along north, east and down at a place.
[[nodiscard]] inline Meters turned_to_ned(const Place& at, const Meters& d) {
  constexpr double kDegree = 0.017453292519943295;
  const double phi = at.latitude * kDegree, lambda = at.longitude * kDegree;
  const double outward = std::cos(lambda) * d[0] + std::sin(lambda) * d[1];
  return {-std::sin(phi) * outward + std::cos(phi) * d[2],
          -std::sin(lambda) * d[0] + std::cos(lambda) * d[1],
          -(std::cos(phi) * outward + std::sin(phi) * d[2])};
}

/// Where `to` is, seen from `from`: north, east, down, along the straight line.
[[nodiscard]] inline Meters ned_between(const Place& from, const Place& to) {
  const Meters a = earth_centered(from), b = earth_centered(to);
  return turned_to_ned(from, {b[0] - a[0], b[1] - a[1], b[2] - a[2]});
}

}  // namespace eyrie::test
