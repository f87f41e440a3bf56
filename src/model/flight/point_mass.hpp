// SPDX-License-Identifier: MIT
#pragma once
/// \file  point_mass: an aircraft as a point with lift, drag, thrust, weight and fuel, in
/// coordinated flight. Three degrees of freedom; docs/models/flight.md has the equations.
#include <algorithm>

#include "model/environment.hpp"
#include "model/flight/airframe.hpp"
#include "model/flight/flying.hpp"
#include "model/kinematics.hpp"

namespace eyrie::model::flight {

/// What hangs outside.
template <class Real>
struct LoadOf {
  Real mass = 0;       ///< kg
  Real drag_area = 0;  ///< m2, drag coefficient times area
};
using Load = LoadOf<double>;

/// What the pilot or the autopilot moves.
template <class Real>
struct ControlsOf {
  Real load_factor = 1;  ///< g, along the lift axis
  Real bank = 0;         ///< rad
  Real throttle = 0;     ///< 0 idle .. 1 military power .. 2 full afterburner
};
using Controls = ControlsOf<double>;

/// Everything that speed, altitude and mass decide in one step; forces in N.
template <class Real>
struct FlightConditionOf {
  Real mass = 0;  ///< kg
  Real mach = 0;
  Real temperature = 0;      ///< K
  Real density_root = 1;     ///< root of density over sea-level density: EAS = TAS times this
  Real speed_of_sound = 0;   ///< m/s
  Real zero_lift_drag = 0;   ///< N, of aircraft and stores
  Real induced_drag = 0;     ///< N at one g; grows with the square of the load factor
  Real separation = 0;       ///< g, load factor from which drag grows faster
  Real separation_drag = 0;  ///< N at one g beyond that; grows with the square
  Real lift_limit = 0;       ///< g, largest load factor that the wing gives
  ThrustOf<Real> thrust;

  [[nodiscard]] Real drag(const Real& load_factor) const {
    const Real beyond = math::max(math::abs(load_factor) - separation, 0);
    return zero_lift_drag + induced_drag * load_factor * load_factor +
           separation_drag * beyond * beyond;
  }
};
using FlightCondition = FlightConditionOf<double>;

template <class Real, bool kAlike>
class Equations;

/// The tables of one airframe on common breakpoints, so that a step looks its Mach number and its
/// altitude up once. Gives the same values as the airframe's own tables. Immutable.
class PointMass {
 public:
  explicit PointMass(const Airframe& airframe);

  [[nodiscard]] const Airframe& airframe() const { return airframe_; }

  /// Largest lift coefficient.
  [[nodiscard]] double max_lift(double mach) const {
    const auto machs = mach_.breakpoints();
    if (!(mach > machs.front()) || mach >= machs.back())
      return (mach >= machs.back() ? by_mach_.back() : by_mach_.front()).max_lift;
    const std::size_t i = mach_.below(mach);
    return by_mach_[i].max_lift + (mach - machs[i]) * by_mach_[i].lift_slope;
  }

 private:
  template <class Real, bool kAlike>
  friend class Equations;
  template <class Real>
  struct ByMachOf {
    Real zero_lift_drag, induced_drag, max_lift;
    Real lift_slope;  ///< of max_lift up to the next
  };
  /// Full power at one altitude, and at the next.
  template <class Real>
  struct PowerOf {
    Real military, afterburner, military_above, afterburner_above;
  };

  Airframe airframe_;
  double steepest_climb_, steepest_dive_;  ///< sines of the autopilot's largest angles
  Axis mach_, altitude_, share_;           ///< of two breakpoints at least
  std::vector<ByMachOf<double>> by_mach_;
  std::vector<PowerOf<double>> power_;  ///< by Mach number, then by altitude
  std::vector<double> part_power_;      ///< by share of military thrust
};

}  // namespace eyrie::model::flight
