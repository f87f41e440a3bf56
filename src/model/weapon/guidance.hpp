// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where a missile wants to turn: proportional navigation with gravity bias and loft.
#include "core/vec.hpp"
#include "model/weapon/line_of_sight.hpp"
#include "model/weapon/missile_type.hpp"

namespace eyrie::model::weapon {

/// m/s^2, what to ask of the autopilot of a missile that flies with `velocity` (m/s):
/// true proportional navigation (Zarchan, eq. 2.1), where a target that closes more slowly than
/// half the missile's own speed is taken to close with that, because the closing speed is small or
/// negative at first after a launch far off boresight;
/// plus a turn towards the target as long as it is more than 45 degrees off the flight path;
/// plus what holds the missile up against gravity.
[[nodiscard]] Vec3 steer(const MissileGuidance& guidance, const LineOfSight& los,
                         const Vec3& velocity, const Vec3& down);

/// Where to aim when the target is believed `relative_position` away (m): a distant target is aimed
/// above by the loft angle, and by less and less up to the end range. `altitude` is the missile's,
/// m; the ceiling holds for the place aimed at.
[[nodiscard]] Vec3 lofted(const Loft& loft, const Vec3& relative_position, const Vec3& down,
                          double altitude);

}  // namespace eyrie::model::weapon
