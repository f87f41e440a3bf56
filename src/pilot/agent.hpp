// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one pilot keeps from decision to decision besides the memory of his tree.
#include "pilot/action.hpp"
#include "team/deciding.hpp"

namespace eyrie::pilot {

/// No tree: the autopilot flies alone.
using team::kNoTree;

/// A missile that left the own aircraft and may still be on its way, as far as its pilot can tell.
struct Shot {
  double since = 0;         ///< s, when it left
  double until = 0;         ///< s, when it will have arrived
  TrackId track{};          ///< at whom; none: an empty place
  std::uint16_t store = 0;  ///< index of the missile type in the Library
  std::uint8_t active = 0;  ///< 1: its own seeker is on, as he reckons; that is not taken back
  std::uint8_t reserved = 0;

  [[nodiscard]] constexpr bool flies(double time) const { return track && time < until; }

  static constexpr auto fields() {
    return field_list(field("since", &Shot::since, "s"), field("until", &Shot::until, "s"),
                      field("track", &Shot::track), field("store", &Shot::store),
                      field("active", &Shot::active), field("reserved", &Shot::reserved));
  }
};

/// One pilot. A scenario sets `bingo` and `tree` at birth; everything else begins at its default.
/// Recorders find here what the last decision was: step, node, vote, phase, target.
struct Agent {
  static constexpr std::string_view system = "pilot";  ///< who writes this row
  static constexpr std::size_t kShots = 4;

  double bingo = 0;                  ///< kg, fuel at which he goes home; set at birth
  double target_since = 0;           ///< s, when he took `target`
  double contested_since = 0;        ///< s, a better-ranked mate is on `target`; 0: none is
  std::uint64_t decided = 0;         ///< step of the last decision
  std::array<Shot, kShots> shots{};  ///< the last ones
  TrackId target{};                  ///< whom he attacks; none: nobody
  TrackId asked_track{};             ///< at whom he last asked for a release
  PlayerId committed{};              ///< on whom he committed last, for telling
  PlayerId lead{};                   ///< who he believes leads
  std::uint32_t asked_store = 0;     ///< index of the missile type that he asked for
  std::uint32_t ticks = 0;           ///< decisions so far
  float vote = 0;                    ///< of what the tree recommended last
  Call call = Call::none;
  std::uint16_t tree = kNoTree;      ///< index into the scenario's trees
  std::uint16_t node = ubf::kNone;   ///< the behavior whose recommendation led; kNone: none
  std::uint16_t phase = ubf::kNone;  ///< what the outermost sequencer has in charge; kNone: none
  std::uint8_t missiles = 0;         ///< that hung on the stations at the last decision
  std::uint8_t said_bingo = 0;

  static constexpr auto fields() {
    return field_list(
        field("bingo", &Agent::bingo, "kg"), field("target_since", &Agent::target_since, "s"),
        field("contested_since", &Agent::contested_since, "s"), field("decided", &Agent::decided),
        field("shots", &Agent::shots), field("target", &Agent::target),
        field("asked_track", &Agent::asked_track), field("committed", &Agent::committed),
        field("lead", &Agent::lead), field("asked_store", &Agent::asked_store),
        field("ticks", &Agent::ticks), field("vote", &Agent::vote), field("call", &Agent::call),
        field("tree", &Agent::tree), field("node", &Agent::node), field("phase", &Agent::phase),
        field("missiles", &Agent::missiles), field("said_bingo", &Agent::said_bingo));
  }

  /// Own missiles that may still be on their way to a track at `time` (s).
  [[nodiscard]] constexpr std::uint32_t flying_at(TrackId track, double time) const {
    std::uint32_t count = 0;
    for (const Shot& shot : shots)
      count += shot.track == track && shot.flies(time) ? 1 : 0;
    return count;
  }
};

/// What pilots add to the table of aircraft.
using PilotColumns = team::AgentColumns<Agent>;

}  // namespace eyrie::pilot
