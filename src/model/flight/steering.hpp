// SPDX-License-Identifier: MIT
#pragma once
/// \file  The inner loops of the autopilot for point_mass: load factor, bank and throttle.
#include "model/flight/autopilot.hpp"
#include "model/flight/guidance.hpp"
#include "model/flight/point_mass.hpp"

namespace eyrie::model::flight {

/// Controls that fly `wanted` with at most `load_factor` (g), the structure and the wing
/// permitting.
///
/// Height has priority over the turn, and flying speed over height: it climbs no steeper than the
/// excess thrust allows at the speed asked for, and puts the nose down before it gets too slow.
/// A wanted climb angle (Guidance::climb) is a direction of flight: the lift vector goes to it,
/// past the vertical and upside down too, and neither height nor flying speed have priority.
///
/// `afterburner` is lit (1) when it falls behind the speed asked for, and put out (0) once military
/// power is enough.
[[nodiscard]] Controls steer(const PointMass& model, const Kinematics& k,
                             const FlightCondition& condition, const Guidance& wanted,
                             double load_factor, std::uint8_t& afterburner);

/// Slowest speed (m/s) that steer() flies in this condition: where the wing can still give the
/// stall margin of the autopilot.
[[nodiscard]] double slowest_speed(const PointMass& model, const Kinematics& k,
                                   const FlightCondition& condition);

}  // namespace eyrie::model::flight
