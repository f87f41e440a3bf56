// SPDX-License-Identifier: MIT
#pragma once
/// \file  How bright an aircraft is to an infrared seeker. Belongs to the aircraft type.
#include <string_view>
#include <tuple>

#include "core/describe.hpp"

namespace eyrie::model {

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
    return std::tuple{param("front", &S::front, positive(1e6), "W/sr, nose on, military power"),
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
