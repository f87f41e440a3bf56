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

/// `who` does it, `whom` it is done to. What each means, and its values, is said in events.cpp,
/// from which docs/events.md is made. What has no column there: `detail` of a launch is the
/// shooter, of a hit and a kill the missile (0: the gun), of an eject the track of whom; `aux` of
/// an eject is the station, of whatever has values of a tree that tree.
enum class EventKind : std::uint16_t {
  none = 0,
  contact,
  track_lost,
  identified,
  rwr_warning,
  missile_warning,
  release,
  launch,
  seeker_active,
  seeker_acquired,
  gun_burst,
  detonation,
  timeout,
  hit,
  kill,
  crash,
  fuel_out,
  bingo,
  winchester,
  home,
  phase,
  lead_change,
  commit,
  defend,
  in_charge,
  order,
  eject,
  scatter,
  loss,
  dispense,
  decoyed,
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
