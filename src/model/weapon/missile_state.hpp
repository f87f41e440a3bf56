// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one missile in flight remembers.
#include <cstdint>

#include "core/field.hpp"
#include "core/id.hpp"
#include "core/vec.hpp"
#include "model/fit.hpp"

namespace eyrie::model::weapon {

/// Why a missile ended without its fuze: values[0] of EventKind::timeout.
enum class MissileEnd : std::uint8_t {
  none,
  ground,  ///< flew into the ground
  speed,   ///< slower than the least speed at which it can be steered
  time,    ///< its battery is empty
  lost,    ///< saw nothing for longer than it remembers and destroyed itself
};

}  // namespace eyrie::model::weapon

template <>
struct eyrie::EnumNames<eyrie::model::weapon::MissileEnd> {
  using E = eyrie::model::weapon::MissileEnd;
  static constexpr std::array names{std::pair<std::string_view, E>{"none", E::none},
                                    std::pair<std::string_view, E>{"ground", E::ground},
                                    std::pair<std::string_view, E>{"speed", E::speed},
                                    std::pair<std::string_view, E>{"time", E::time},
                                    std::pair<std::string_view, E>{"lost", E::lost}};
};

namespace eyrie::model::weapon {

/// The memory of one missile. It knows what it was told by its shooter and what its seeker saw,
/// never the truth: `intended` is for scoring and `seen` names the echo that the seeker rests on.
struct MissileState {
  Vec3 target_position{};     ///< m, local frame: believed place of the target at target_time
  Vec3 target_velocity{};     ///< m/s
  double target_time = 0;     ///< s
  Vec3 sight{1, 0, 0};        ///< unit vector: filtered line of sight of the seeker at sight_time
  Vec3 sight_rate{};          ///< rad/s, its angular velocity
  double sight_time = 0;      ///< s, last look that saw something
  double closing_speed = 0;   ///< m/s, as the seeker measures or assumes it
  Vec3 wanted{};              ///< m/s^2, acceleration that guidance asks for
  Vec3 lift{};                ///< m/s^2, aerodynamic acceleration across the flight path
  double launch_time = 0;     ///< s
  double next_fuze_scan = 0;  ///< s: before that nobody can be close enough to matter
  PlayerId shooter{};
  PlayerId intended{};      ///< truth of the track it was launched at: scoring and debrief only
  TrackId track{};          ///< name of the target in the shooter's track file
  PlayerId seen{};          ///< who the seeker saw last; none if nobody yet
  std::uint16_t type = 0;   ///< index of the MissileType in the Library
  Side side = Side::none;   ///< of the shooter
  std::uint8_t active = 0;  ///< 1: the seeker is switched on
  std::uint8_t locked = 0;  ///< 1: the seeker rests on `seen` now
  std::uint8_t reserved[3] = {};

  static constexpr auto fields() {
    return field_list(
        field("target_position", &MissileState::target_position, "m"),
        field("target_velocity", &MissileState::target_velocity, "m/s"),
        field("target_time", &MissileState::target_time, "s"), field("sight", &MissileState::sight),
        field("sight_rate", &MissileState::sight_rate, "rad/s"),
        field("sight_time", &MissileState::sight_time, "s"),
        field("closing_speed", &MissileState::closing_speed, "m/s"),
        field("wanted", &MissileState::wanted, "m/s2"), field("lift", &MissileState::lift, "m/s2"),
        field("launch_time", &MissileState::launch_time, "s"),
        field("next_fuze_scan", &MissileState::next_fuze_scan, "s"),
        field("shooter", &MissileState::shooter), field("intended", &MissileState::intended),
        field("track", &MissileState::track), field("seen", &MissileState::seen),
        field("type", &MissileState::type), field("side", &MissileState::side),
        field("active", &MissileState::active), field("locked", &MissileState::locked),
        field("reserved", &MissileState::reserved));
  }
};
static_assert(fields_cover_row<MissileState>());

}  // namespace eyrie::model::weapon
