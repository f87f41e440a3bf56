// SPDX-License-Identifier: MIT
#pragma once
/// \file  A steady horizontal wind, constant or by layers of altitude.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/describe.hpp"
#include "core/table.hpp"
#include "core/vec.hpp"

namespace eyrie::model {

/// The wind at one altitude, said as pilots say it.
struct WindLayer {
  static constexpr std::string_view type_name = "wind";
  static constexpr std::string_view help = "the wind at one altitude";
  static constexpr auto params() {
    return std::tuple{
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

  [[nodiscard]] bool calm() const { return velocity_.empty(); }
  /// Velocity of the air at an altitude (m): north, east, 0; m/s.
  [[nodiscard]] Vec3 at(double altitude) const;

 private:
  Axis altitude_;
  std::vector<Vec3> velocity_;  ///< north-east-down, one per layer
};

}  // namespace eyrie::model
