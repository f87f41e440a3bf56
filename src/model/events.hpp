// SPDX-License-Identifier: MIT
#pragma once
/// \file  The events of the air war, in the field's words.
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "core/units.hpp"

namespace eyrie::model {

/// Of an event's values: one that it does not have.
inline constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();

/// `who` does it, `whom` it is done to. Ranges in m, times in s, angles in rad. What each means to
/// readers of a table is said in events.cpp, from which docs/events.md is made.
enum class EventKind : std::uint16_t {
  none = 0,
  contact,          ///< who got a new track of whom (truth); values: range, source bits
  track_lost,       ///< who lost its track of whom; values: age
  identified,       ///< who identified whom; values: identity, range
  rwr_warning,      ///< who is warned of whom's radar; values: kind, bearing
  missile_warning,  ///< who is warned of missile whom; values: bearing
  release,          ///< who released a store at whom; values: store index, range
  launch,           ///< missile who was born, whom = target; detail = shooter; values: range,
                    ///< store index
  seeker_active,    ///< missile who's seeker went active; values: range to where it believes whom
  seeker_acquired,  ///< missile who's seeker sees whom; values: range
  gun_burst,        ///< who fired the gun at whom; values: rounds, range, hits
  detonation,       ///< missile who's fuze fired near whom; values: miss distance, kill
                    ///< probability, draw
  timeout,          ///< missile who ended at no aircraft, whom it flew at or whose towed decoy
                    ///< it met; values: MissileEnd, time of flight
  hit,              ///< who (shooter) hit whom; values: damage, miss distance; detail = missile,
                    ///< or 0 for the gun
  kill,             ///< who (shooter) killed whom; detail = missile, or 0 for the gun
  crash,            ///< who hit the ground, or whom in the air
  fuel_out,         ///< who's tanks are empty
  bingo,            ///< who reached bingo fuel; values: fuel (kg)
  winchester,       ///< who has no missile left
  home,             ///< who is home and leaves the run
  phase,            ///< who's sequencer changed; values: from, to, sequencer node
  lead_change,      ///< who now leads its flight, whom led before; values: flight
  commit,           ///< who commits on whom; values: range
  defend,           ///< who defends against missile whom or an unseen one; values: phase 1 turns
                    ///< into it, 2 breaks, 3 notches, 4 drags, 5 breaks at the last moment, 6 goes
                    ///< out from a fighter, no missile being known
  in_charge,        ///< who's winning behavior changed; values: node index, vote
  order,            ///< an order from outside was carried out on who; values: order kind, detail
  eject,            ///< a store leaves who's station aux towards whom; detail = its track; values:
                    ///< store index, 1 if it is the last. Becomes a launch in the same step
  scatter,          ///< who leaves its way because of aircraft whom; values: range
  loss,             ///< who is lost to something outside the run, by an order
  dispense,         ///< who throws out decoys; values: 1 chaff, 2 flares, 3 both; chaff left,
                    ///< flares left
  decoyed,          ///< missile who goes for a decoy of whom; values: 1 chaff, 2 flare
  count
};

/// What the number of a value stands for, where it is no quantity.
enum class EventCode : std::uint8_t {
  number,
  weapon,    ///< index of the missile type in the library
  sources,   ///< bits of TrackSource
  identity,  ///< Identity
  radar,     ///< EmissionKind
  ending,    ///< MissileEnd
  child,     ///< of the sequencer in the third value; -1: none
  node,      ///< of the tree `aux`; -1: none
  flight,    ///< index into the flights
  defense,   ///< phase of a defend event
  order,     ///< kind of order, with the second value
  decoys,    ///< Dispense
};

/// A value that an event carries.
struct EventValue {
  std::string_view name;      ///< "range", as campaigns call it; "": there is none
  Unit unit{};                ///< of a quantity
  std::string_view column{};  ///< of tables, "range_m"
  EventCode code = EventCode::number;
  std::string_view help{};

  /// Its number is an index into the tree `aux`.
  [[nodiscard]] constexpr bool is_of_tree() const {
    return code == EventCode::child || code == EventCode::node;
  }
  /// Its number is an index, which says nothing to anybody outside.
  [[nodiscard]] constexpr bool is_name() const {
    return code == EventCode::weapon || code == EventCode::flight || is_of_tree();
  }
};

/// A kind of event, for who reads a table of them.
struct EventInfo {
  EventKind kind = EventKind::none;
  std::string_view name;  ///< "seeker_active"
  std::string_view help;  ///< a sentence about who and whom
  std::array<EventValue, 3> values{};
};

/// Every kind, in the order of the enumeration.
[[nodiscard]] std::span<const EventInfo> event_infos();

/// "seeker_active"; "" for none and for numbers that are no kind.
[[nodiscard]] std::string_view event_name(EventKind kind);

/// The values that an event of that kind carries, such as the range.
[[nodiscard]] std::span<const EventValue> event_values(EventKind kind);

}  // namespace eyrie::model
