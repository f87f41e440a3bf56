// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one missile does with what it is told and what it sees: link, seeker, guidance.
#include "core/draw.hpp"
#include "model/kinematics.hpp"
#include "model/track.hpp"
#include "model/weapon/missile_state.hpp"
#include "model/weapon/missile_type.hpp"
#include "model/weapon/target_scene.hpp"

namespace eyrie::model::weapon {

/// Where the missile believes its target to be at `time` (s), m.
[[nodiscard]] Vec3 believed_position(const MissileState& state, double time);

/// Switches an active radar seeker on when the target is believed to be near enough. True at that
/// moment.
[[nodiscard]] bool switch_on(const MissileType& type, const Kinematics& k, double time,
                             MissileState& state);

/// One look of a seeker that is on: follows whom it rests on or searches where it believes the
/// target. What it now sees for the first time, if anybody.
[[nodiscard]] std::optional<Detected> look(const MissileType& type, const Kinematics& k,
                                           double time, const TargetScene& scene, Draw noise,
                                           MissileState& state);

/// Takes over what the shooter's track says, if it is newer and the seeker sees nobody itself.
void hear(const Track& track, MissileState& state);

/// The acceleration that guidance asks for, m/s^2: none until the missile is clear of its aircraft,
/// along the seeker's line of sight while it sees somebody (and while an infrared missile remembers
/// where that was), otherwise towards the believed target, lofted if it can.
[[nodiscard]] Vec3 guide(const MissileType& type, const Kinematics& k, double time,
                         const MissileState& state);

}  // namespace eyrie::model::weapon
