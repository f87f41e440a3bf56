// SPDX-License-Identifier: MIT
#pragma once
/// \file  The engines of one aircraft, all together: thrust over Mach number and altitude, and
/// fuel.
#include <string_view>
#include <tuple>

#include "core/describe.hpp"
#include "model/environment.hpp"

namespace eyrie::model::flight {

/// Thrust that is there at one Mach number and altitude.
struct Thrust {
  double idle = 0, military = 0, afterburner = 0;  ///< N
};

/// Const and shared. Thrust is installed thrust of all engines.
struct Engine {
  Table2 military;     ///< N over Mach number and altitude (m), full power without afterburner
  Table2 afterburner;  ///< N, full afterburner
  double idle_share = 0.05;
  double military_tsfc = si(0.9, "lb/lbf/h");
  double afterburner_tsfc = si(1.6, "lb/lbf/h");
  double military_tsfc_mach = 1.0 / 3;
  double afterburner_tsfc_mach = 0.16875;
  double idle_flow = 0;
  double spool_time = 4;
  double light_time = 2;

  static constexpr std::string_view type_name = "engine";
  static constexpr std::string_view help = "thrust and fuel flow of all engines of an aircraft";
  static constexpr auto params() {
    using E = Engine;
    return std::tuple{
        param("military", &E::military, axis("mach", {}), axis("altitude", "m"), "N", positive(1e7),
              "installed thrust of all engines at full power without afterburner")
            .required(),
        param("afterburner", &E::afterburner, axis("mach", {}), axis("altitude", "m"), "N",
              positive(1e7), "installed thrust of all engines with full afterburner")
            .required(),
        param("idle_share", &E::idle_share, range(0, 1), "thrust at idle over military thrust"),
        param("military_tsfc", &E::military_tsfc, "kg/N/s", range(1e-6, 1e-3),
              "fuel flow over thrust at military power, at sea level and at rest"),
        param("afterburner_tsfc", &E::afterburner_tsfc, "kg/N/s", range(1e-6, 1e-3),
              "fuel flow over thrust at full afterburner, at sea level and at rest"),
        param("military_tsfc_mach", &E::military_tsfc_mach, range(0, 5),
              "part by which the military one grows per Mach number"),
        param("afterburner_tsfc_mach", &E::afterburner_tsfc_mach, range(0, 5),
              "part by which the afterburner one grows per Mach number"),
        param("idle_flow", &E::idle_flow, "kg/s", range(0, 10), "least fuel flow while it runs"),
        param("spool_time", &E::spool_time, "s", range(0.1, 60), "from idle to military power"),
        param("light_time", &E::light_time, "s", range(0.1, 60),
              "from military power to full afterburner")};
  }

  [[nodiscard]] Thrust thrust_at(double mach, double altitude) const;

  /// Thrust (N) at a throttle in [0, 2]: linear from idle to military power and on to afterburner.
  [[nodiscard]] static double thrust_of(const Thrust& available, double throttle);
  /// The throttle that gives a thrust (N), limited to [0, 1], or [0, 2] with afterburner.
  [[nodiscard]] static double throttle_for(const Thrust& available, double thrust,
                                           bool with_afterburner);

  /// Fuel flow (kg/s) at a throttle. TSFC = (C1 + C2 M) sqrt(theta), Mattingly, Heiser & Pratt,
  /// Aircraft Engine Design, 2nd ed. (2002), eq. 3.12, with C1 given at sea level and C2 / C1 as
  /// *_tsfc_mach (0.3 / 0.9 and 0.27 / 1.6 in eq. 3.55a, b). Between military power and full
  /// afterburner the flow is linear in the throttle. theta: temperature over sea-level temperature.
  [[nodiscard]] double flow_of(const Thrust& available, double throttle, double mach,
                               double temperature) const;

  /// The throttle one step of `dt` (s) later, on its way to `wanted`.
  [[nodiscard]] double spool(double throttle, double wanted, double dt) const;
};

/// Installed thrust over its static sea-level value for a low-bypass mixed-flow turbofan of
/// throttle ratio `throttle_ratio`: Mattingly, Heiser & Pratt, eq. 2.54a (maximum power) and 2.54b
/// (military power, 0.6 at sea level and at rest). Used to make the tables in data/, and to check
/// them.
[[nodiscard]] double afterburner_lapse(double mach, const Air& air, double throttle_ratio);
[[nodiscard]] double military_lapse(double mach, const Air& air, double throttle_ratio);

}  // namespace eyrie::model::flight
