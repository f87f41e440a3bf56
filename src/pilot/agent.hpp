// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one pilot keeps from decision to decision besides the memory of his tree.
#include <cstdint>

#include "core/field.hpp"
#include "core/id.hpp"
#include "pilot/action.hpp"
#include "sim/schema.hpp"
#include "ubf/transition.hpp"

namespace eyrie::pilot {

/// No tree: the autopilot flies alone.
inline constexpr std::uint16_t kNoTree = ubf::kNone;

struct Agent {
  double bingo = 0;         ///< kg, fuel at which he goes home; set at birth
  double shot_time = 0;     ///< s, of the last release
  double shot_until = 0;    ///< s, when that missile will have arrived
  TrackId target;           ///< the chosen track
  TrackId shot_track;       ///< the track of the last release
  PlayerId lead;            ///< who he believes leads
  std::uint32_t ticks = 0;  ///< decisions so far
  float vote = 0;           ///< of what the tree recommended last
  std::uint16_t tree = kNoTree;
  std::uint16_t node = ubf::kNone;  ///< the behavior whose recommendation led; kNone: none
  Call call = Call::none;
  std::uint8_t said_bingo = 0;
  std::uint8_t shots = 0;           ///< releases so far, saturating
  std::uint8_t shots_at_track = 0;  ///< of these, how many in a row at shot_track
  std::uint8_t reserved = 0;

  static constexpr auto fields() {
    return field_list(
        field("bingo", &Agent::bingo, "kg"), field("shot_time", &Agent::shot_time, "s"),
        field("shot_until", &Agent::shot_until, "s"), field("target", &Agent::target),
        field("shot_track", &Agent::shot_track), field("lead", &Agent::lead),
        field("ticks", &Agent::ticks), field("vote", &Agent::vote), field("tree", &Agent::tree),
        field("node", &Agent::node), field("call", &Agent::call),
        field("said_bingo", &Agent::said_bingo), field("shots", &Agent::shots),
        field("shots_at_track", &Agent::shots_at_track), field("reserved", &Agent::reserved));
  }
};
static_assert(fields_cover_row<Agent>());

}  // namespace eyrie::pilot
