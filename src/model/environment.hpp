// SPDX-License-Identifier: MIT
#pragma once
/// \file  The air and the wind.
#include "core/describe.hpp"
#include "model/kinematics.hpp"

namespace eyrie::model {

/// Standard gravity, m/s2: exact by convention (ISO 80000-3).
inline constexpr double kGravity = 9.80665;

/// Specific gas constant of dry air, J/(kg K): R* / M0 of the U.S. Standard Atmosphere 1976,
/// table 2.
inline constexpr double kGasConstant = 8314.32 / 28.9644;

/// Ratio of specific heats of air: U.S. Standard Atmosphere 1976, table 2.
inline constexpr double kHeatRatio = 1.4;

/// Sea-level values: U.S. Standard Atmosphere 1976, table 2.
inline constexpr double kSeaLevelTemperature = 288.15;  ///< K
inline constexpr double kSeaLevelPressure = 101325;     ///< Pa
inline constexpr double kSeaLevelDensity =
    kSeaLevelPressure / (kGasConstant * kSeaLevelTemperature);  ///< kg/m3

/// The air at one place.
template <class Real>
struct AirOf {
  Real temperature = 0;     ///< K
  Real pressure = 0;        ///< Pa
  Real density = 0;         ///< kg/m3
  Real speed_of_sound = 0;  ///< m/s
};
using Air = AirOf<double>;

/// Geopotential altitude (m) of a geometric altitude (m): H = r Z / (r + Z) with r = 6356766 m,
/// U.S. Standard Atmosphere 1976, eq. 18.
template <class Real>
[[nodiscard]] constexpr Real geopotential(const Real& geometric) {
  constexpr double kRadius = 6356766;
  return kRadius * geometric / (kRadius + geometric);
}

/// Temperature (K) at a geopotential altitude (m) up to 32 km: U.S. Standard Atmosphere 1976,
/// table 4.
template <class Real>
[[nodiscard]] Real layer_temperature(const Real& height) {
  constexpr double kLapse = -0.0065, kRise = 0.001;  // K/m
  return math::max(kSeaLevelTemperature + kLapse * height,
                   Real(kSeaLevelTemperature + kLapse * 11000)) +
         kRise * math::max(height - 20000, 0);
}

/// What follows from temperature (K) and pressure (Pa).
template <class Real>
[[nodiscard]] AirOf<Real> complete(const Real& temperature, const Real& pressure) {
  const Real specific_energy = kGasConstant * temperature;
  return {.temperature = temperature,
          .pressure = pressure,
          .density = pressure / specific_energy,
          .speed_of_sound = math::sqrt(kHeatRatio * specific_energy)};
}

/// The standard atmosphere at a geometric altitude (m), from its definition: a hydrostatic ideal
/// gas whose temperature falls by 6.5 K/km to 11 km of geopotential altitude, stays, and rises by
/// 1 K/km from 20 km to 32 km. Below -2 km and above 32 km (geopotential) the air is that of the
/// limit. U.S. Standard Atmosphere 1976, eq. 23, 33a, 33b, 42 and 50; the same as ICAO Doc 7488/3.
[[nodiscard]] Air standard_air(double altitude);

/// The same, fast: pressure by cubic Hermite pieces of 500 m that meet the hydrostatic slope at
/// both ends. Within 2e-7 (relative) of standard_air. Immutable once built.
class Atmosphere {
 public:
  Atmosphere();

  /// `altitude`: geometric, m.
  [[nodiscard]] Air at(double altitude) const;
  template <std::size_t N>
  [[nodiscard]] AirOf<math::Lanes<N>> at(const math::Lanes<N>& altitude) const {
    return air_at(altitude);
  }

 private:
  template <class Real>
  [[nodiscard]] AirOf<Real> air_at(const Real& altitude) const {
    const Real height = math::clamp(geopotential(altitude), kLowest, kHighest);

    // cubic Hermite between the two nodes around; the layers meet at nodes
    const Real pieces = (height - kLowest) * (1 / kPiece);
    const auto whole = math::whole_part(math::min(pieces, kPieces - 1));
    const Real t = pieces - math::whole<Real>(whole);
    const auto [a, b] = math::to_lanes<std::array<NodeOf<Real>, 2>>(
        math::each_of<math::kLanes<Real>>([&](auto i) { return &pieces_[math::lane(whole, i)]; }));
    const Real rise = b.pressure - a.pressure;
    const Real pressure =
        a.pressure +
        t * (a.slope + t * (3 * rise - 2 * a.slope - b.slope + t * (a.slope + b.slope - 2 * rise)));
    return complete(layer_temperature(height), pressure);
  }

  static constexpr double kLowest = -2000, kHighest = 32000, kPiece = 500;
  static constexpr int kPieces = static_cast<int>((kHighest - kLowest) / kPiece);
  template <class Real>
  struct NodeOf {
    Real pressure;  ///< Pa
    Real slope;     ///< Pa per piece
  };
  std::array<std::array<NodeOf<double>, 2>, kPieces> pieces_;  ///< both ends of each
};

/// The wind at one altitude, said as pilots say it.
struct WindLayer {
  static constexpr std::string_view type_name = "wind";
  static constexpr std::string_view help = "the wind at one altitude";
  static constexpr auto params() {
    return Lines{
        param("altitude", &WindLayer::altitude, "m", range(-2e3, 32e3), "where this wind blows"),
        param("speed", &WindLayer::speed, "m/s", range(0, 150), "how fast").required(),
        param("from", &WindLayer::from, "rad", range(-kTau, kTau),
              "the true direction it comes from")
            .required()};
  }

  double altitude = 0;  ///< m above the ellipsoid
  double speed = 0;     ///< m/s
  double from = 0;      ///< rad, true
};

/// Layers of wind; between two of them the components change linearly, beyond the first and last
/// the wind stays as it is there. Immutable. The default is calm air.
class Wind {
 public:
  Wind() = default;
  /// What is wrong with these layers, in words, if anything: altitudes must increase.
  [[nodiscard]] static std::optional<std::string> problem(std::span<const WindLayer> layers);
  /// std::logic_error if there is a problem.
  explicit Wind(std::span<const WindLayer> layers);

  [[nodiscard]] bool is_calm() const { return velocity_.empty(); }
  /// Velocity of the air at an altitude (m): north, east, 0; m/s.
  [[nodiscard]] Vec3 at(double altitude) const;

 private:
  Axis altitude_;
  std::vector<Vec3> velocity_;  ///< north-east-down, one per layer
};

extern const Wind kCalm;

/// m/s, in local axes: how the air moves where somebody is.
[[nodiscard]] inline Vec3 air_at(const Kinematics& k, const Wind& wind) {
  const Vec3 ned = wind.at(k.altitude);
  return ned.x * k.north + ned.y * k.east;
}
/// Likewise: how he moves through it.
[[nodiscard]] inline Vec3 through_air(const Kinematics& k, const Wind& wind) {
  return wind.is_calm() ? k.velocity : k.velocity - air_at(k, wind);
}
/// Unit vector in local axes: where the nose of who flies without sideslip points.
[[nodiscard]] inline Vec3 nose_of(const Kinematics& k, const Wind& wind) {
  return normalized(through_air(k, wind), k.north);
}

/// What a scenario says about the environment.
struct EnvironmentSpec {
  static constexpr std::string_view type_name = "environment";
  static constexpr std::string_view help = "the standard atmosphere, with a steady wind if wanted";
  static constexpr auto params() {
    return Lines{
        param("wind", &EnvironmentSpec::wind, "layers of wind from low to high; none: calm air")};
  }

  std::vector<WindLayer> wind;
};

/// The environment of a run. Immutable and shared.
struct Environment {
  Environment() = default;
  /// std::logic_error if Wind::problem(spec.wind).
  explicit Environment(const EnvironmentSpec& spec) : wind(spec.wind) {}

  Atmosphere atmosphere;
  Wind wind;
};

}  // namespace eyrie::model
