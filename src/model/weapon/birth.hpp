// SPDX-License-Identifier: MIT
#pragma once
/// \file  The rows of a missile that has just left its aircraft.
#include "core/id.hpp"
#include "model/fit.hpp"
#include "model/kinematics.hpp"
#include "model/track.hpp"
#include "model/weapon/missile_state.hpp"
#include "model/weapon/missile_type.hpp"

namespace eyrie::model::weapon {

struct Launch {
  const MissileType& type;
  std::uint16_t type_index = 0;
  PlayerId shooter;
  Side side = Side::none;
  double time = 0;  ///< s
};

struct Newborn {
  Kinematics kinematics;
  MissileState state;
};

/// A missile at its shooter's place with its shooter's velocity, pushed away from the belly, that
/// has been told of the target what the track says. An infrared seeker is switched on already and
/// points at the track.
[[nodiscard]] Newborn launched(const Launch& launch, const Kinematics& shooter, const Track& track);

}  // namespace eyrie::model::weapon
