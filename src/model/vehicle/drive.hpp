// SPDX-License-Identifier: MIT
#pragma once
/// \file  How a ground vehicle moves over the surface of the ellipsoid.
#include <span>

#include "model/flight/route.hpp"
#include "model/frames.hpp"
#include "model/kinematics.hpp"
#include "model/vehicle/vehicle_state.hpp"
#include "model/vehicle/vehicle_type.hpp"

namespace eyrie::model::vehicle {

/// A vehicle at a place of the local frame (m), put onto the surface below or above it.
[[nodiscard]] Kinematics parked(const Reference& reference, const Vec3& position, double heading,
                                double speed);

/// One step (s): the front wheels turn towards what the heading asked for needs, the speed follows
/// within the limits, slower where the turn would be too fast, and the vehicle moves as the
/// kinematic bicycle does (Rajamani, Vehicle Dynamics and Control, 2nd ed. 2012, sec. 2.2), with
/// its rear axle as the place: heading rate = speed tan(steering) / wheelbase. The leg of the route
/// counts on, whoever leads.
void drive(const VehicleType& type, const Reference& reference,
           std::span<const flight::Route> routes, const DriveCommand& command, double dt,
           Kinematics& k, Driving& driving);

}  // namespace eyrie::model::vehicle
