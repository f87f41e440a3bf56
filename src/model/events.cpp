// SPDX-License-Identifier: MIT
#include "model/events.hpp"

#include <algorithm>

namespace eyrie::model {

namespace {

constexpr EventValue quantity(std::string_view name, Unit unit, std::string_view column,
                              std::string_view help) {
  return {name, unit, column, EventCode::number, help};
}
constexpr EventValue number(std::string_view name, std::string_view help) {
  return {name, {}, name, EventCode::number, help};
}
constexpr EventValue coded(std::string_view name, EventCode code, std::string_view column,
                           std::string_view help) {
  return {name, {}, column, code, help};
}

constexpr EventInfo event(EventKind kind, std::string_view name, std::string_view help,
                          const auto&... values) {
  return {kind, name, help, {values...}};
}

constexpr EventValue kRange = quantity("range", "m", "range_m", "how far whom is from who");
constexpr EventValue kBelieved =
    quantity("range", "m", "range_m", "from who to where it believes whom");
constexpr EventValue kBearing = quantity("bearing", "rad", "bearing_deg", "true, from who");
constexpr EventValue kMiss = quantity("miss", "m", "miss_m", "nearest distance of the missile");
constexpr EventValue kStore = coded("store", EventCode::weapon, "weapon", "type of missile");
constexpr EventValue kDecoys =
    coded("kind", EventCode::decoys, "decoys", "`chaff` (1), `flares` (2), `both` (3)");

constexpr std::array kInfos = [] {
  using enum EventKind;
  using C = EventCode;
  return std::array{
      event(contact, "contact", "who has a new track of whom.", kBelieved,
            coded("sources", C::sources, "sources",
                  "`radar` (1), `eyes` (2), `datalink` (4), `truth` (8), `infrared` (16), or "
                  "several (their sum)")),
      event(track_lost, "track_lost", "who has lost its track of whom.",
            quantity("age", "s", "age_s", "time since the track was last seen")),
      event(identified, "identified", "who knows now, or believes to know, whose side whom is on.",
            coded("identity", C::identity, "identity",
                  "`unknown` (0), `friendly` (1), `hostile` (2)"),
            kBelieved),
      event(rwr_warning, "rwr_warning", "The warning receiver of who hears the radar of whom.",
            coded("kind", C::radar, "radar", "`search` (1), `track` (2), `missile_seeker` (3)"),
            kBearing),
      event(missile_warning, "missile_warning", "who is warned of the missile whom.", kBearing),
      event(release, "release",
            "who has decided to shoot at whom: the store is being made ready. A `launch` follows, "
            "if who lives.",
            kStore, kBelieved),
      event(launch, "launch", "The missile who leaves its shooter towards whom.", kBelieved,
            kStore),
      event(seeker_active, "seeker_active",
            "The seeker of missile who is switched on (\"pitbull\"), to look for whom.", kBelieved),
      event(seeker_acquired, "seeker_acquired", "The seeker of missile who sees whom.", kRange),
      event(gun_burst, "gun_burst",
            "who has ended a burst of its gun at whom, or at nobody in its sight, or goes on at "
            "another; nothing if the run, or who, ends first.",
            number("rounds", "fired"), kRange, number("hits", "rounds that hit")),
      event(
          detonation, "detonation",
          "The fuze of missile who works near whom; it kills if the draw is below the probability.",
          kMiss, number("kill_probability", "0 to 1, of that miss"),
          number("draw", "0 to 1; -1: the program whose aircraft it is decides")),
      event(timeout, "timeout",
            "Missile who ends without its fuze. whom: it was shot at, or whose towed decoy it met.",
            coded("reason", C::ending, "ending",
                  "`ground` (1), `speed` (2, too slow), `time` (3, battery empty), `lost` (4, sees "
                  "nothing), `decoy` (5, towed)"),
            quantity("flight_time", "s", "flight_time_s", "since its launch")),
      event(hit, "hit", "who has hit whom, by a missile or the gun.",
            number("damage", "1 destroys"), kMiss),
      event(kill, "kill", "who has destroyed whom."),
      event(crash, "crash", "who has hit the ground, or whom in the air."),
      event(fuel_out, "fuel_out", "The tanks of who are empty."),
      event(bingo, "bingo",
            "who has no more fuel than the bingo of his flight, at which he is to go home.",
            quantity("fuel", "kg", "fuel_kg", "what is left")),
      event(winchester, "winchester", "who has no missile left."),
      event(home, "home", "who is home and leaves the run."),
      event(phase, "phase",
            "A sequencer in the tree of who goes from one of its children to another.",
            coded("from", C::child, "phase_from", "label of the child; empty at first"),
            coded("to", C::child, "phase_to", "label of the child"),
            coded("node", C::node, "sequencer", "its label")),
      event(lead_change, "lead_change", "who leads its flight now, as whom did before.",
            coded("flight", C::flight, "flight", "its name")),
      event(commit, "commit", "who commits on whom.", kBelieved),
      event(defend, "defend",
            "who defends against the missile whom, or against one that it does not see.",
            coded("phase", C::defense, "defense",
                  "`turn_in` (1), `break` (2), `notch` (3), `drag` (4), `last_ditch` (5), `out` "
                  "(6, from a fighter)")),
      event(in_charge, "in_charge", "Another behavior of who leads its decisions.",
            coded("node", C::node, "behavior", "its label; empty: nobody"),
            number("vote", "with which it leads")),
      event(order, "order", "who has been given an order from outside the run.",
            coded("kind", C::order, "order_given",
                  "`swap_tree`, `take_over`, `hand_back`, `vote`, `weapons_tight`, `weapons_free`, "
                  "`point`")),
      event(eject, "eject",
            "A store leaves who towards whom; it becomes a `launch` in the same step.", kStore,
            coded("last", C::number, "last_one", "1: no missile is left")),
      event(scatter, "scatter", "who leaves its way because of aircraft whom.", kBelieved),
      event(loss, "loss", "who is lost to something outside the run, by an order."),
      event(dispense, "dispense", "who throws out decoys.", kDecoys,
            number("chaff", "bundles left"), number("flares", "left")),
      event(decoyed, "decoyed", "Missile who goes for a decoy of whom.", kDecoys)};
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
  const auto end = std::ranges::find(values, std::string_view(), &EventValue::name);
  return std::span(values.begin(), end);
}

}  // namespace eyrie::model
