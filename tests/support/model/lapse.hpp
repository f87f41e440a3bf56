// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests and benchmarks only: how the thrust of a turbofan falls with height, from which
/// the tables in data/ were made.
#include <algorithm>

#include "core/math.hpp"
#include "model/environment.hpp"

namespace eyrie::model::flight {

struct Stagnation {
  double theta, delta;
};

/// Total temperature and pressure over sea-level standard: Mattingly, eq. 2.52a, b.
inline Stagnation stagnation(double mach, const Air& air) {
  const double rise = 1 + 0.2 * mach * mach;
  return {air.temperature / kSeaLevelTemperature * rise,
          air.pressure / kSeaLevelPressure * math::pow(rise, 3.5)};
}

inline double lapse(double mach, const Air& air, double throttle_ratio, double slope) {
  const auto [theta, delta] = stagnation(mach, air);
  return delta * (1 - slope * std::max(theta - throttle_ratio, 0.0) / theta);
}

/// Installed thrust over its static sea-level value for a low-bypass mixed-flow turbofan of
/// throttle ratio `throttle_ratio`: Mattingly, Heiser & Pratt, eq. 2.54a (maximum power) and 2.54b
/// (military power, 0.6 at sea level and at rest).
inline double afterburner_lapse(double mach, const Air& air, double throttle_ratio) {
  return lapse(mach, air, throttle_ratio, 3.5);
}
inline double military_lapse(double mach, const Air& air, double throttle_ratio) {
  return 0.6 * lapse(mach, air, throttle_ratio, 3.8);
}

}  // namespace eyrie::model::flight
