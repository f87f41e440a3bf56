// SPDX-License-Identifier: MIT
#include "model/events.hpp"

#include <algorithm>

namespace eyrie::model {

namespace {

constexpr EventValue kRange{"range", "m", "range_m", {}, "how far whom is from who"};
constexpr EventValue kBelieved{"range", "m", "range_m", {}, "from who to where it believes whom"};
constexpr EventValue kBearing{"bearing", "rad", "bearing_deg", {}, "true, from who"};
constexpr EventValue kMiss{"miss", "m", "miss_m", {}, "nearest distance of the missile"};
constexpr EventValue kStore{"store", {}, "weapon", EventCode::weapon, "type of missile"};
constexpr EventValue kDecoys{
    "kind", {}, "decoys", EventCode::decoys, "`chaff` (1), `flares` (2), `both` (3)"};

constexpr std::array kInfos = [] {
  using enum EventKind;
  using C = EventCode;
  return std::to_array<EventInfo>({
      {contact,
       "contact",
       "who has a new track of whom.",
       {{kBelieved,
         {"sources",
          {},
          "sources",
          C::sources,
          "`radar` (1), `eyes` (2), `datalink` (4), `truth` (8), `infrared` (16), or several "
          "(their sum)"}}}},
      {track_lost,
       "track_lost",
       "who has lost its track of whom.",
       {{{"age", "s", "age_s", C::number, "time since the track was last seen"}}}},
      {identified,
       "identified",
       "who knows now, or believes to know, whose side whom is on.",
       {{{"identity", {}, "identity", C::identity, "`unknown` (0), `friendly` (1), `hostile` (2)"},
         kBelieved}}},
      {rwr_warning,
       "rwr_warning",
       "The warning receiver of who hears the radar of whom.",
       {{{"kind", {}, "radar", C::radar, "`search` (1), `track` (2), `missile_seeker` (3)"},
         kBearing}}},
      {missile_warning, "missile_warning", "who is warned of the missile whom.", {{kBearing}}},
      {release,
       "release",
       "who has decided to shoot at whom: the store is being made ready. A `launch` follows, if "
       "who lives.",
       {{kStore, kBelieved}}},
      {launch, "launch", "The missile who leaves its shooter towards whom.", {{kBelieved, kStore}}},
      {seeker_active,
       "seeker_active",
       "The seeker of missile who is switched on (\"pitbull\"), to look for whom.",
       {{kBelieved}}},
      {seeker_acquired, "seeker_acquired", "The seeker of missile who sees whom.", {{kRange}}},
      {gun_burst,
       "gun_burst",
       "who has ended a burst of its gun at whom, or at nobody in its sight, or goes on at "
       "another; "
       "nothing if the run, or who, ends first.",
       {{{"rounds", {}, "rounds", C::number, "fired"},
         kRange,
         {"hits", {}, "hits", C::number, "rounds that hit"}}}},
      {detonation,
       "detonation",
       "The fuze of missile who works near whom; it kills if the draw is below the probability.",
       {{kMiss,
         {"kill_probability", {}, "kill_probability", C::number, "0 to 1, of that miss"},
         {"draw", {}, "draw", C::number, "0 to 1; -1: the program whose aircraft it is decides"}}}},
      {timeout,
       "timeout",
       "Missile who ends without its fuze. whom: it was shot at, or whose towed decoy it met.",
       {{{"reason",
          {},
          "ending",
          C::ending,
          "`ground` (1), `speed` (2, too slow), `time` (3, battery empty), "
          "`lost` (4, sees nothing), `decoy` (5, towed)"},
         {"flight_time", "s", "flight_time_s", C::number, "since its launch"}}}},
      {hit,
       "hit",
       "who has hit whom, by a missile or the gun.",
       {{{"damage", {}, "damage", C::number, "1 destroys"}, kMiss}}},
      {kill, "kill", "who has destroyed whom."},
      {crash, "crash", "who has hit the ground, or whom in the air."},
      {fuel_out, "fuel_out", "The tanks of who are empty."},
      {bingo,
       "bingo",
       "who has no more fuel than the bingo of his flight, at which he is to go home.",
       {{{"fuel", "kg", "fuel_kg", C::number, "what is left"}}}},
      {winchester, "winchester", "who has no missile left."},
      {home, "home", "who is home and leaves the run."},
      {phase,
       "phase",
       "A sequencer in the tree of who goes from one of its children to another.",
       {{{"from", {}, "phase_from", C::child, "label of the child; empty at first"},
         {"to", {}, "phase_to", C::child, "label of the child"},
         {"node", {}, "sequencer", C::node, "its label"}}}},
      {lead_change,
       "lead_change",
       "who leads its flight now, as whom did before.",
       {{{"flight", {}, "flight", C::flight, "its name"}}}},
      {commit, "commit", "who commits on whom.", {{kBelieved}}},
      {defend,
       "defend",
       "who defends against the missile whom, or against one that it does not see.",
       {{{"phase",
          {},
          "defense",
          C::defense,
          "`turn_in` (1), `break` (2), `notch` (3), `drag` (4), `last_ditch` (5), `out` (6, from a "
          "fighter)"}}}},
      {in_charge,
       "in_charge",
       "Another behavior of who leads its decisions.",
       {{{"node", {}, "behavior", C::node, "its label; empty: nobody"},
         {"vote", {}, "vote", C::number, "with which it leads"}}}},
      {order,
       "order",
       "who has been given an order from outside the run.",
       {{{"kind",
          {},
          "order_given",
          C::order,
          "`swap_tree`, `take_over`, `hand_back`, `vote`, `weapons_tight`, "
          "`weapons_free`, `point`"}}}},
      {eject,
       "eject",
       "A store leaves who towards whom; it becomes a `launch` in the same step.",
       {{kStore, {"last", {}, "last_one", C::number, "1: no missile is left"}}}},
      {scatter, "scatter", "who leaves its way because of aircraft whom.", {{kBelieved}}},
      {loss, "loss", "who is lost to something outside the run, by an order."},
      {dispense,
       "dispense",
       "who throws out decoys.",
       {{kDecoys,
         {"chaff", {}, "chaff", C::number, "bundles left"},
         {"flares", {}, "flares", C::number, "left"}}}},
      {decoyed, "decoyed", "Missile who goes for a decoy of whom.", {{kDecoys}}},
  });
}();

constexpr bool in_order() {
  for (std::size_t i = 0; i < kInfos.size(); ++i)
    if (static_cast<std::size_t>(kInfos[i].kind) != i + 1)
      return false;
  return kInfos.size() + 1 == static_cast<std::size_t>(EventKind::count);
}
static_assert(in_order(), "every kind is described, in the order of the enumeration");

}  // namespace

std::span<const EventInfo> event_infos() {
  return kInfos;
}

std::string_view event_name(EventKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  return index >= 1 && index <= kInfos.size() ? kInfos[index - 1].name : "";
}

std::span<const EventValue> event_values(EventKind kind) {
  if (event_name(kind).empty())
    return {};
  const auto& values = kInfos[static_cast<std::size_t>(kind) - 1].values;
  return std::span(values).first(static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](const auto& v) { return !v.name.empty(); })));
}

}  // namespace eyrie::model
