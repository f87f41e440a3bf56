// SPDX-License-Identifier: MIT
#pragma once
/// \file  An aircraft's lift, drag, engine and limits.
#include <algorithm>

#include "model/environment.hpp"
#include "model/flight/autopilot.hpp"
#include "model/flight/laero.hpp"

namespace eyrie::model::flight {

/// Thrust that is there at one Mach number and altitude.
template <class Real>
struct ThrustOf {
  Real idle = 0, military = 0, afterburner = 0;  ///< N
};
using Thrust = ThrustOf<double>;

/// Const and shared. Thrust is installed thrust of all engines.
struct Engine {
  Table2 military;     ///< N over Mach number and altitude (m), full power without afterburner
  Table2 afterburner;  ///< N, full afterburner
  double idle_share = 0.05;
  double military_tsfc = si(0.9, "lb/lbf/h");     ///< kg/N/s
  double afterburner_tsfc = si(1.6, "lb/lbf/h");  ///< kg/N/s
  double military_tsfc_mach = 1.0 / 3;
  double afterburner_tsfc_mach = 0.16875;
  Table1 part_power{{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1},
                    {0, 0.1557, 0.2728, 0.3731, 0.4643, 0.5511, 0.6363, 0.7222, 0.8106, 0.9028, 1}};
  double idle_flow = 0;   ///< kg/s
  double spool_time = 4;  ///< s
  double light_time = 2;  ///< s

  static constexpr std::string_view type_name = "engine";
  static constexpr std::string_view help = "thrust and fuel flow of all engines of an aircraft";
  static constexpr auto params() {
    using E = Engine;
    return Lines{
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
        param("part_power", &E::part_power, axis("thrust", {}), {}, range(0, 2),
              "fuel flow over that at military power, over thrust over military thrust"),
        param("idle_flow", &E::idle_flow, "kg/s", range(0, 10), "least fuel flow while it runs"),
        param("spool_time", &E::spool_time, "s", range(0.1, 60), "from idle to military power"),
        param("light_time", &E::light_time, "s", range(0.1, 60),
              "from military power to full afterburner")};
  }

  [[nodiscard]] Thrust thrust_at(double mach, double altitude) const {
    const double dry = military(mach, altitude);
    return {.idle = idle_share * dry,
            .military = dry,
            .afterburner = std::max(afterburner(mach, altitude), dry)};
  }

  /// Thrust (N) at a throttle in [0, 2]: linear from idle to military power and on to afterburner.
  template <class Real>
  [[nodiscard]] static Real thrust_of(const ThrustOf<Real>& available,
                                      const std::type_identity_t<Real>& throttle) {
    return math::select(
        throttle <= 1, available.idle + throttle * (available.military - available.idle),
        available.military + (throttle - 1) * (available.afterburner - available.military));
  }
  /// The throttle that gives a thrust (N), limited to [0, 1], or [0, 2] with afterburner.
  template <class Real>
  [[nodiscard]] static Real throttle_for(const ThrustOf<Real>& available,
                                         const std::type_identity_t<Real>& thrust,
                                         const math::MaskOf<Real>& with_afterburner) {
    const Real dry = available.military - available.idle;
    const Real wet = available.afterburner - available.military;
    const Real up_to_military =
        math::select(dry > 0, math::clamp((thrust - available.idle) / dry, 0, 1), 1);
    const Real beyond =
        math::select(wet > 0, math::min(1 + (thrust - available.military) / wet, 2), 1);
    return math::select((thrust <= available.military) | !with_afterburner, up_to_military, beyond);
  }
};

/// Which equations of motion an aircraft flies by.
enum class Dynamics : std::uint8_t {
  laero,       ///< rate limits only, as the paper's aircraft
  point_mass,  ///< lift, drag, thrust, weight and fuel
};
constexpr auto names_of(Dynamics) {
  return names_from_zero<Dynamics>("laero", "point_mass");
}

/// Lift and drag, all per wing area: C_D = C_D0(M) + k(M) C_L^2, and k_s (|C_L| - C_Ls)^2 more from
/// C_Ls on, where the flow over the wing begins to separate and leading-edge suction is lost. C_L
/// reaches up to a largest value over the Mach number.
struct Aerodynamics {
  double wing_area = 50;  ///< m2
  Table1 zero_lift_drag = Table1::constant(0.02);
  Table1 induced_drag = Table1::constant(0.15);
  Table1 max_lift = Table1::constant(1.2);
  double separation_lift = 0.35;
  double separation_drag = 0.22;

  static constexpr std::string_view type_name = "aerodynamics";
  static constexpr std::string_view help = "lift and drag of an aircraft over the Mach number";
  static constexpr auto params() {
    using A = Aerodynamics;
    return Lines{
        param("wing_area", &A::wing_area, "m2", range(1, 1000), "of all coefficients").required(),
        param("zero_lift_drag", &A::zero_lift_drag, axis("mach", {}), {}, range(1e-4, 1),
              "C_D0, without stores")
            .required(),
        param("induced_drag", &A::induced_drag, axis("mach", {}), {}, range(1e-3, 5),
              "k in C_D = C_D0 + k C_L^2 at small C_L")
            .required(),
        param("max_lift", &A::max_lift, axis("mach", {}), {}, range(0.05, 5),
              "C_L that it can pull to")
            .required(),
        param("separation_lift", &A::separation_lift, range(0, 5),
              "C_L from which drag grows faster"),
        param("separation_drag", &A::separation_drag, range(0, 5),
              "k_s: drag coefficient more per square of C_L beyond that")};
  }
};

/// What the structure, the flight controls and the inlets allow.
struct FlightLimits {
  double max_load_factor = 9;
  double min_load_factor = -3;
  double load_factor_rate = 6;
  double roll_rate = si(180, "deg/s");  ///< rad/s
  double max_mach = 2;
  double max_equivalent_airspeed = si(800, "kt");  ///< m/s

  static constexpr std::string_view type_name = "flight_limits";
  static constexpr std::string_view help = "what structure and flight controls allow";
  static constexpr auto params() {
    using L = FlightLimits;
    return Lines{
        param("max_load_factor", &L::max_load_factor, range(1, 20), "g"),
        param("min_load_factor", &L::min_load_factor, range(-10, 0), "g"),
        param("load_factor_rate", &L::load_factor_rate, range(0.1, 100),
              "g per second by which the load factor changes"),
        param("roll_rate", &L::roll_rate, "rad/s", range(0.5, 600, "deg/s"),
              "largest rate of roll"),
        param("max_mach", &L::max_mach, range(0.1, 4), "the autopilot flies no faster"),
        param("max_equivalent_airspeed", &L::max_equivalent_airspeed, "m/s", range(50, 600),
              "the autopilot flies no faster: true airspeed times the root of the density ratio")};
  }
};

/// One kind of aircraft as the flight models see it. Const and shared. `laero` and `autopilot` have
/// defaults; the rest is what the point-mass model needs.
struct Airframe {
  double empty_mass = 10000;    ///< kg, without fuel and stores
  double internal_fuel = 3000;  ///< kg
  Aerodynamics aerodynamics;
  Engine engine;
  FlightLimits limits;
  Laero laero;
  Autopilot autopilot;

  static constexpr std::string_view type_name = "airframe";
  static constexpr std::string_view help = "mass, aerodynamics, engines, limits and autopilot";
  static constexpr auto params() {
    using A = Airframe;
    return Lines{
        param("empty_mass", &A::empty_mass, "kg", range(100, 500e3),
              "ready to fly, without fuel and stores")
            .required(),
        param("internal_fuel", &A::internal_fuel, "kg", range(0, 200e3), "full internal tanks")
            .required(),
        param("aerodynamics", &A::aerodynamics, "lift and drag").required(),
        param("engine", &A::engine, "thrust and fuel flow").required(),
        param("limits", &A::limits, "what structure and flight controls allow"),
        param("laero", &A::laero, "rate limits of the simple model, where an aircraft flies it"),
        param("autopilot", &A::autopilot, "gains and limits of the autopilot")};
  }
};

}  // namespace eyrie::model::flight
