// SPDX-License-Identifier: MIT
#pragma once
/// \file  How big a target looks to a radar and to the eye. Belongs to the aircraft type.
#include <algorithm>

#include "core/describe.hpp"
#include "model/kinematics.hpp"

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
    return Lines{
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
[[nodiscard]] inline double silhouette(const Signature& s, const Axes& target, const Vec3& unit) {
  const double front = s.area_front * dot(unit, target.forward);
  const double side = s.area_side * dot(unit, target.right);
  const double top = s.area_top * dot(unit, target.down);
  return std::sqrt(front * front + side * side + top * top);
}
/// m^2: none is larger.
[[nodiscard]] inline double largest_silhouette(const Signature& s) {
  return std::max({s.area_front, s.area_side, s.area_top});
}

/// Radiant intensity in the seeker's band, W/sr, at military power; the afterburner multiplies what
/// is seen of the plume. The same from the left and from the right.
struct InfraredSignature {
  double front = 60;        ///< W/sr, nose on: skin, and plume beside the fuselage
  double side = 250;        ///< W/sr, abeam: plume
  double rear = 1000;       ///< W/sr, tail on: hot nozzle
  double afterburner = 10;  ///< factor on everything with full afterburner

  static constexpr std::string_view type_name = "infrared_signature";
  static constexpr std::string_view help = "radiant intensity of an aircraft by aspect";
  static constexpr auto params() {
    using S = InfraredSignature;
    return Lines{param("front", &S::front, positive(1e6), "W/sr, nose on, military power"),
                 param("side", &S::side, positive(1e6), "W/sr, abeam, military power"),
                 param("rear", &S::rear, positive(1e6), "W/sr, tail on, military power"),
                 param("afterburner", &S::afterburner, range(1, 1000),
                       "factor on all of them with full afterburner")};
  }
};

/// Intensity (W/sr) at aspect `a`, the angle at the target between its nose and the seeker, with
/// the same form as the radar cross section. `throttle`: 0 idle, 1 military power, 2 full
/// afterburner; below military power it falls to a third, above it grows linearly to the factor.
[[nodiscard]] constexpr double radiant_intensity(const InfraredSignature& s, double cos_aspect,
                                                 double throttle) {
  const double end = cos_aspect >= 0 ? s.front : s.rear;
  const double military = s.side + (end - s.side) * cos_aspect * cos_aspect;
  if (throttle >= 1)
    return military * (1 + (s.afterburner - 1) * (throttle < 2 ? throttle - 1 : 1));
  return military * (1 + 2 * (throttle > 0 ? throttle : 0)) / 3;
}

}  // namespace eyrie::model
