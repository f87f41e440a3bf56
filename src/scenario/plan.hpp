// SPDX-License-Identifier: MIT
#pragma once
/// \file  The flights, convoys and players of a scenario document, read and checked, not yet built.
#include <deque>

#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "model/fit.hpp"
#include "scenario/spec.hpp"

namespace eyrie::scenario {

/// One aircraft or vehicle: what its flight or convoy says, overridden by what the file says of it.
template <class Spec>
struct MemberPlan {
  std::string name;
  std::uint16_t rank = 1;  ///< from the name
  Location where;
  Spec spec;
  bool own_altitude = false;   ///< its start has an altitude of its own
  bool own_place = false;      ///< it has a start place of its own instead of one in the formation
  bool sound = true;           ///< everything said of it and of its group could be read
  const Value* own = nullptr;  ///< its overrides in the document, if it has any
  const Value* group = nullptr;  ///< its flight or convoy in the document

  /// What the document says of a key: of the member, or else of its group; null if nothing.
  [[nodiscard]] const Value* said(std::string_view key) const {
    const Value* mine = own ? own->find(key) : nullptr;
    return mine || !group ? mine : group->find(key);
  }
  /// Whether it says nothing of it, or the text of no letters.
  [[nodiscard]] bool leaves_open(std::string_view key) const {
    const Value* value = said(key);
    return !value || (value->is_scalar() && value->text.empty());
  }
  /// Where it says so; if nowhere, where the member stands.
  [[nodiscard]] const Location& place(std::string_view key) const {
    const Value* value = said(key);
    return value ? value->where : where;
  }
};

/// A flight or a convoy.
template <class GroupSpec, class MemberSpec>
struct GroupPlan {
  using Member = MemberPlan<MemberSpec>;
  std::string name;
  model::Side side = model::Side::none;
  Location where;
  GroupSpec spec;
  bool sound = true;  ///< everything said of it could be read
  Location route_where, start_where;
  std::vector<Member> players;  ///< by rank

  /// rad, of the lead at the start; `own` if it says none.
  [[nodiscard]] double lead_heading(double own) const {
    return players.front().spec.start.heading.value_or(own);
  }
};

using PlayerPlan = MemberPlan<PlayerSpec>;
struct FlightPlan : GroupPlan<FlightSpec, PlayerSpec> {
  static constexpr std::string_view word = "flight";
  std::optional<PlaceSpec> home;  ///< of the flight, or else of the side
  Location home_where;
};

using VehiclePlan = MemberPlan<VehicleSpec>;
struct ConvoyPlan : GroupPlan<ConvoySpec, VehicleSpec> {
  static constexpr std::string_view word = "convoy";
};

/// A group of another kind of player, read by who knows it.
struct OtherPlan {
  std::size_t kind = 0;  ///< index into the keys given
  const Value::Entry* group = nullptr;
  model::Side side = model::Side::none;
};

struct Plans {
  std::vector<FlightPlan> flights;
  std::vector<ConvoyPlan> convoys;
  std::vector<OtherPlan> others;
  std::deque<Value::Entry> read;  ///< what convoys were read from, where they point into
};

/// Reads `blue:` and `red:` of a scenario document, in this order and flights and convoys in file
/// order. Refused: a side without either, a group without anybody in it, a player whose name is not
/// its group's name and a rank, two of one name, a group without a lead, ranks beyond
/// model::kMaxFlight, and of a convoy what only aircraft have. `others` are further keys of a side
/// under which groups stand.
[[nodiscard]] Plans read_plans(const Value& document, Diagnostics& diagnostics,
                               std::span<const std::string_view> others = {});

}  // namespace eyrie::scenario
