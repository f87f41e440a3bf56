// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests and benchmarks only: how the thrust of a turbofan falls with height, from which
/// the tables in data/ were made.
#include <algorithm>
#include <array>

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

/// Nguyen et al., NASA TP-1538 (1979), installed thrust of the F-16's F100-PW-200 in lbf: rows Mach
/// 0 to 1 in steps of 0.2, columns 0 to 50,000 ft in steps of 10,000 ft.
struct ThrustTable {
  double rated;  ///< lbf, on the test bench
  std::array<std::array<double, 6>, 6> installed;
};
inline constexpr ThrustTable kMaximum = {23830,
                                         {{{20000, 15000, 10800, 7000, 4000, 2500},
                                           {21420, 15700, 11225, 7323, 4435, 2600},
                                           {22700, 16860, 12250, 8154, 5000, 2835},
                                           {24240, 18910, 13760, 9285, 5700, 3215},
                                           {26070, 21075, 15975, 11115, 6860, 3950},
                                           {28886, 23319, 18300, 13484, 8642, 5057}}}};
inline constexpr ThrustTable kMilitary = {14670,
                                          {{{12680, 9150, 6200, 3950, 2450, 1400},
                                            {12680, 9150, 6313, 4040, 2470, 1400},
                                            {12610, 9312, 6610, 4290, 2600, 1560},
                                            {12640, 9839, 7090, 4660, 2840, 1660},
                                            {12390, 10176, 7750, 5320, 3250, 1930},
                                            {11680, 9848, 8050, 6100, 3800, 2310}}}};

/// That over its rating, at Mach 0 to 1. Between the altitudes, and beyond the last of them, the
/// thrust over the air pressure is linear in the altitude.
inline double published_lapse(const ThrustTable& table, double mach, double altitude) {
  const double column = altitude / si(10000, "ft"), row = std::min(mach, 1.0) / 0.2;
  const auto left = std::min<std::size_t>(static_cast<std::size_t>(column), 4);
  const auto up = std::min<std::size_t>(static_cast<std::size_t>(row), 4);
  const auto at = [&](std::size_t i, std::size_t j) {
    return table.installed[i][j] / standard_air(si(10000, "ft") * static_cast<double>(j)).pressure;
  };
  const auto along = [&](std::size_t i) {
    return std::max(
        at(i, left) + (column - static_cast<double>(left)) * (at(i, left + 1) - at(i, left)), 0.0);
  };
  return (along(up) + (row - static_cast<double>(up)) * (along(up + 1) - along(up))) *
         standard_air(altitude).pressure / table.rated;
}

/// The lapse of data/airframes: the published one up to Mach 1, and on from there as Mattingly's
/// formula grows; military thrust also as (1 - 0.3 (M - 0.6)), the line along which the published
/// one leaves the formula between Mach 0.6 and 1.
inline double installed_military(double mach, double altitude) {
  const double published = published_lapse(kMilitary, mach, altitude);
  if (mach <= 1)
    return published;
  const Air air = standard_air(altitude);
  return published * military_lapse(mach, air, 1.07) / military_lapse(1, air, 1.07) *
         (1 - 0.3 * (mach - 0.6)) / 0.88;
}
inline double installed_afterburner(double mach, double altitude) {
  const double published = published_lapse(kMaximum, mach, altitude);
  if (mach <= 1)
    return published;
  const Air air = standard_air(altitude);
  return published * afterburner_lapse(mach, air, 1.07) / afterburner_lapse(1, air, 1.07);
}

}  // namespace eyrie::model::flight
