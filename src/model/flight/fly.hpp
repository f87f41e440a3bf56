// SPDX-License-Identifier: MIT
#pragma once
/// \file  One aircraft's step: autopilot, dynamics, fuel and the vertical at the new place.
#include "model/environment.hpp"
#include "model/flight/airframe.hpp"
#include "model/flight/point_mass.hpp"
#include "model/flight/steering.hpp"
#include "model/frames.hpp"

namespace eyrie::model::flight {

/// An aircraft in level flight at a place: local frame, heading (rad, true), true airspeed (m/s).
[[nodiscard]] Kinematics placed(const Reference& reference, const Environment& environment,
                                const Vec3& position, double heading, double speed);

/// The rows of one aircraft that flying reads and writes.
struct FlightRows {
  Kinematics& kinematics;
  Flying& flying;
  Propulsion& propulsion;
  const Command& command;
};

/// What surrounds them.
struct FlightContext {
  const Reference& reference;
  const Environment& environment;
  std::span<const Route> routes = {};  ///< of the flight
  Load load = {};                      ///< stores on board
  double time = 0;                     ///< s, at the beginning of the step
  double dt = 0;                       ///< s
};

/// Flies one step as the command asks. True when the tanks ran dry in it.
[[nodiscard]] bool fly(const PointMass& model, Dynamics dynamics, const FlightContext& context,
                       FlightRows rows);

}  // namespace eyrie::model::flight
