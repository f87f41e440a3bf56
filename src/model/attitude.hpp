// SPDX-License-Identifier: MIT
#pragma once
/// \file  How a body lies in a frame: axes, 3-2-1 Euler angles, and what a spin makes of them.
#include "core/vec.hpp"

namespace eyrie::model {

/// Forward, right and down as rows, in the frame that psi, theta and phi (rad) turn into them; and
/// the angles of such axes.
[[nodiscard]] Mat3 attitude_of(const Vec3& euler);
[[nodiscard]] Vec3 euler_of(const Mat3& attitude);

/// By what `spin` (rad/s, about the body's axes) turns an attitude in `time` (s): the new one is
/// turn(spin, time) * attitude. IEEE 1278.1-2012, E.7.2.
[[nodiscard]] Mat3 turn(const Vec3& spin, double time);

}  // namespace eyrie::model
