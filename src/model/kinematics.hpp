// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where a player is and how it moves: the truth that the move phase writes.
#include "core/field.hpp"
#include "core/vec.hpp"

namespace eyrie::model {

/// Position, velocity and attitude of one player.
/// Positions and velocities are in the scenario's local frame (tangent plane at the reference
/// point: x north, y east, z down; see model/frames.hpp). Heading, pitch and roll are relative to
/// the geodetic north-east-down axes at the player itself. Heading, pitch and speed are those of
/// the motion through the air; only `velocity` has the wind in it.
struct Kinematics {
  Vec3 position = {};      ///< m
  Vec3 velocity = {};      ///< m/s over the ground
  Vec3 north = {};         ///< unit vector: local geodetic north at the player
  Vec3 east = {};          ///< unit vector: local geodetic east
  Vec3 down = {};          ///< unit vector: local geodetic down
  double altitude = 0;     ///< m above the WGS-84 ellipsoid
  double heading = 0;      ///< rad, true, clockwise from north, in (-pi, pi]
  double pitch = 0;        ///< rad, of the velocity vector and the nose, positive up
  double roll = 0;         ///< rad, positive right wing down
  double speed = 0;        ///< m/s true airspeed
  double mach = 0;         ///< speed over the local speed of sound
  double load_factor = 1;  ///< g, along the lift axis

  static constexpr auto fields() {
    return field_list(
        field("position", &Kinematics::position, "m"),
        field("velocity", &Kinematics::velocity, "m/s"), field("north", &Kinematics::north),
        field("east", &Kinematics::east), field("down", &Kinematics::down),
        field("altitude", &Kinematics::altitude, "m"),
        field("heading", &Kinematics::heading, "rad"), field("pitch", &Kinematics::pitch, "rad"),
        field("roll", &Kinematics::roll, "rad"), field("speed", &Kinematics::speed, "m/s"),
        field("mach", &Kinematics::mach), field("load_factor", &Kinematics::load_factor));
  }
};

}  // namespace eyrie::model
