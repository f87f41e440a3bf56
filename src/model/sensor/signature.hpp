// SPDX-License-Identifier: MIT
#pragma once
/// \file  How big a target looks to a radar and to the eye. Belongs to the aircraft type.
#include <string_view>
#include <tuple>

#include "core/describe.hpp"
#include "core/vec.hpp"
#include "model/sensor/geometry.hpp"

namespace eyrie::model {

/// Radar cross sections and silhouettes. The same from the left and from the right.
struct Signature {
  double rcs_front = 5;   ///< m^2, nose on
  double rcs_side = 25;   ///< m^2, abeam
  double rcs_rear = 8;    ///< m^2, tail on
  double area_front = 8;  ///< m^2, silhouette nose on
  double area_side = 25;  ///< m^2, silhouette abeam
  double area_top = 55;   ///< m^2, silhouette from above

  static constexpr std::string_view type_name = "signature";
  static constexpr std::string_view help = "radar cross sections and silhouettes of an aircraft";
  static constexpr auto params() {
    return std::tuple{
        param("rcs_front", &Signature::rcs_front, "m2", range(1e-4, 1e5), "nose on"),
        param("rcs_side", &Signature::rcs_side, "m2", range(1e-4, 1e5), "abeam"),
        param("rcs_rear", &Signature::rcs_rear, "m2", range(1e-4, 1e5), "tail on"),
        param("area_front", &Signature::area_front, "m2", range(0.01, 1e5), "silhouette nose on"),
        param("area_side", &Signature::area_side, "m2", range(0.01, 1e5), "silhouette abeam"),
        param("area_top", &Signature::area_top, "m2", range(0.01, 1e5), "silhouette from above")};
  }
};

/// Radar cross section (m^2) at aspect `a`, the angle at the target between its nose and the
/// radar: sigma_end + (sigma_side - sigma_end) sin^2 a, where the end is the nose in front of the
/// beam and the tail behind it. Without a jump in value or slope at the beam. The form with one end
/// is used for path planning against radars (see docs/models/radar.md); we need two.
[[nodiscard]] constexpr double radar_cross_section(const Signature& s, double cos_aspect) {
  const double end = cos_aspect >= 0 ? s.rcs_front : s.rcs_rear;
  return s.rcs_side + (end - s.rcs_side) * cos_aspect * cos_aspect;
}

/// Silhouette (m^2) from `unit`, a direction from the target in the local frame, of the ellipsoid
/// that has the three given silhouettes: the root of the sum of (area * direction cosine)^2, which
/// is exact for an ellipsoid (Vickers, Powder Technology 86 (1996) 195).
[[nodiscard]] double silhouette(const Signature& s, const Axes& target, const Vec3& unit);

}  // namespace eyrie::model
