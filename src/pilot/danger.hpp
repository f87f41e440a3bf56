// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot makes of what he hears and sees of the enemy's shots: which missile comes
/// for him and when, whose radar tracks him, from where the enemy could hit him; and how long his
/// own missiles need him.
#include "pilot/state.hpp"

namespace eyrie::pilot {

/// s until a missile is here: as its signal grows, or else by its range as it is seen. Nothing if
/// neither is known.
[[nodiscard]] std::optional<double> time_to_go(const State& state,
                                               const model::InboundMissile& missile);

/// The missile that is here first, among those believed to come for this aircraft: known to be here
/// within `within` s, and heard or seen in the last second. One that is only seen counts in its
/// last 4 s. One whose signal does not grow as it would if it came here is for somebody else
/// (model::sensor::time_to_go), and so is one that a mate hears better than his place explains
/// (model::sensor::rests_on_mate). Null if there is none.
[[nodiscard]] const model::InboundMissile* inbound(const State& state, double within);

/// The radar that tracks this aircraft, the one that has for longest; null if none does.
[[nodiscard]] const model::RwrWarning* spike(const State& state);

/// A searching radar on the bearing of a hostile inside the reach of whose missile, if this
/// aircraft keeps its course, it is; null if there is none.
[[nodiscard]] const model::RwrWarning* scanned(const State& state);

/// The hostile who is deepest inside the range from which he can hit: range over r_ne is least.
struct Exposure {
  const Seen* hostile = nullptr;
  double ratio = 0;  ///< range over r_ne of his reach
};
/// Nothing if no hostile is known who could hit at all.
[[nodiscard]] std::optional<Exposure> exposure(const State& state);

/// Whether a hostile is within `factor` times the range from which he can hit.
[[nodiscard]] bool exposed(const State& state, double factor);

/// s that an own missile still needs the radar's support: until its own seeker is switched on, as
/// its shooter reckons. 0 or less if it needs none any more; nothing if it needs it in vain,
/// because its target's track is lost.
[[nodiscard]] std::optional<double> support_left(const State& state, const Shot& shot);

/// Whether any own missile that flies still needs the radar.
[[nodiscard]] bool support_needed(const State& state);

/// A danger that a defense turns from.
struct Danger {
  double bearing = 0;              ///< rad, true
  std::optional<double> altitude;  ///< m, if it is known
  Call call = Call::out;           ///< what a turn from it is called, unless it is a missile
};

/// What a defense is against.
enum class Against : std::uint8_t {
  missile,  ///< that comes for this aircraft
  radar,    ///< the missile, or else a radar that tracks this aircraft
  fighter,  ///< these, or else the hostile to whom this aircraft is most exposed, or the nearest
};
constexpr auto names_of(Against) {
  return names_from_zero<Against>("missile", "radar", "fighter");
}
/// The most pressing danger. A missile counts if it is here within `within` s.
[[nodiscard]] std::optional<Danger> danger(const State& state, Against against, double within);

}  // namespace eyrie::pilot
