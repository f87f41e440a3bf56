// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where somebody is who has not been heard of for a while: dead reckoning in world
/// coordinates. IEEE 1278.1-2012, annex E.
#include "dis/pdu.hpp"
#include "model/kinematics.hpp"

namespace eyrie::dis {

/// How somebody lies in the world and moves.
struct Motion {
  Vec3 position, velocity, acceleration;  ///< m, m/s, m/s^2; Earth-centred, Earth-fixed
  Mat3 attitude;                          ///< world to body: forward, right, down as rows
  Vec3 spin;                              ///< rad/s, about the body's axes
};

using model::attitude_of, model::euler_of;

/// After `time` (s), by an algorithm of world coordinates; by any other it stays where it is.
[[nodiscard]] Motion reckon(Reckoning algorithm, const Motion& from, double time);

/// The spin (rad/s) that turns one attitude into another in `time` (s).
[[nodiscard]] Vec3 spin_between(const Mat3& from, const Mat3& to, double time);

/// What an entity state tells, in the precision that it has on the wire.
[[nodiscard]] Motion motion_of(const EntityState& state);

/// How far what others reckon may be from the truth before they are told. 7.2.2 of the standard,
/// with its default values.
struct Thresholds {
  double position = 1;        ///< m
  double angle = radians(3);  ///< rad, of the turn between the two attitudes
  double heartbeat = 5;       ///< s, after which a state is told anyway
  /// s, after which others take one for gone.
  [[nodiscard]] double timeout() const { return 2.4 * heartbeat; }
};
[[nodiscard]] bool apart(const Motion& a, const Motion& b, const Thresholds& thresholds);

}  // namespace eyrie::dis
