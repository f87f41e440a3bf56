// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where a player is and how it moves: the truth that the move phase writes.
#include "core/field.hpp"
#include "model/frames.hpp"

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
    using K = Kinematics;
    return field_list(field("position", &K::position, "m"), field("velocity", &K::velocity, "m/s"),
                      field("north", &K::north), field("east", &K::east), field("down", &K::down),
                      field("altitude", &K::altitude, "m"), field("heading", &K::heading, "rad"),
                      field("pitch", &K::pitch, "rad"), field("roll", &K::roll, "rad"),
                      field("speed", &K::speed, "m/s"), field("mach", &K::mach),
                      field("load_factor", &K::load_factor));
  }
};

/// Of its place.
void set_vertical(auto& k, const auto& at) {
  k.north = at.north;
  k.east = at.east;
  k.down = at.down;
  k.altitude = at.altitude;
}
/// Of the place to which it moved in a step. It goes on in the same direction: the heading turns
/// against north.
void carry_to(auto& k, const auto& at) {
  k.heading = wrap_pi(k.heading - turn_of_north(k.east, at.north));
  set_vertical(k, at);
}

/// Where a player waits who is in the run and has not appeared: on the other side of the Earth, so
/// that nobody senses him.
inline constexpr Vec3 kNowhere{0, 0, 12.77e6};
[[nodiscard]] inline bool is_nowhere(const Kinematics& k) {
  return k.position.z > 10e6;
}

/// Forward, right and down as rows, in the frame that psi, theta and phi (rad) turn into them
/// (Stevens, Lewis & Johnson, Aircraft Control and Simulation, 3rd ed., eq. 1.3-20: 3-2-1 Euler
/// angles); and the angles of such axes.
[[nodiscard]] Mat3 attitude_of(const Vec3& euler);
[[nodiscard]] Vec3 euler_of(const Mat3& attitude);

/// By what `spin` (rad/s, about the body's axes) turns an attitude in `time` (s): the new one is
/// turn(spin, time) * attitude. IEEE 1278.1-2012, E.7.2.
[[nodiscard]] Mat3 turn(const Vec3& spin, double time);

/// Three orthonormal axes in the local frame.
struct Axes {
  Vec3 forward{1, 0, 0}, right{0, 1, 0}, down{0, 0, 1};
};

/// Nose, right wing and belly of a player.
[[nodiscard]] Axes body_axes(const Kinematics& k);

/// The level axes at a player, turned by `heading` (rad, true).
[[nodiscard]] Axes level_axes(const Kinematics& k, double heading);

/// Where a direction of the local frame points to, seen from a player.
struct Bearing {
  double azimuth = 0;    ///< rad, true, clockwise from north, in (-pi, pi]
  double elevation = 0;  ///< rad, above the horizontal
};
[[nodiscard]] Bearing bearing_of(const Kinematics& from, const Vec3& unit);

/// A slant range (m) up to which two players at these altitudes (m above the ellipsoid) see each
/// other over a smooth sphere: the tangents of both to it. `earth_factor` scales the radius of the
/// Earth: 1 for the eye; 4/3 for radio waves, which bend with the air (Skolnik, Introduction to
/// Radar Systems, 3rd ed., sec. 8.2; Federal Standard 1037C, "radar line-of-sight equation").
/// Altitudes below zero count as zero.
[[nodiscard]] double horizon_range(double altitude_a, double altitude_b, double earth_factor);

inline constexpr double kRadioEarth = 4.0 / 3.0;
inline constexpr double kEarthRadius = 6371008.8;  ///< m, mean radius R1 of WGS-84 (Moritz 2000)

}  // namespace eyrie::model
