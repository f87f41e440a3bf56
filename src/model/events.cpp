// SPDX-License-Identifier: MIT
#include "model/events.hpp"

#include <algorithm>
#include <array>

namespace eyrie::model {

namespace {

struct Description {
  EventKind kind;
  std::string_view name;
  std::array<std::string_view, 3> values{};  ///< their names
};

constexpr std::array kDescriptions = [] {
  using enum EventKind;
  return std::to_array<Description>({
      {contact, "contact", {"range", "sources"}},
      {track_lost, "track_lost", {"age"}},
      {identified, "identified", {"identity", "range"}},
      {rwr_warning, "rwr_warning", {"kind", "bearing"}},
      {missile_warning, "missile_warning", {"bearing"}},
      {release, "release", {"store", "range"}},
      {launch, "launch", {"range", "store"}},
      {seeker_active, "seeker_active", {"range"}},
      {seeker_acquired, "seeker_acquired", {"range"}},
      {gun_burst, "gun_burst", {"rounds", "range", "hits"}},
      {detonation, "detonation", {"miss", "kill_probability", "draw"}},
      {timeout, "timeout", {"reason", "flight_time"}},
      {hit, "hit", {"damage", "miss"}},
      {kill, "kill"},
      {crash, "crash"},
      {fuel_out, "fuel_out"},
      {bingo, "bingo", {"fuel"}},
      {winchester, "winchester"},
      {home, "home"},
      {phase, "phase", {"from", "to", "node"}},
      {lead_change, "lead_change", {"flight"}},
      {commit, "commit", {"range"}},
      {defend, "defend", {"phase"}},
      {in_charge, "in_charge", {"node", "vote"}},
      {order, "order", {"kind"}},
      {eject, "eject", {"store", "last"}},
      {scatter, "scatter", {"range"}},
      {loss, "loss"},
      {dispense, "dispense", {"kind", "chaff", "flares"}},
      {decoyed, "decoyed", {"kind"}},
  });
}();

constexpr bool in_order() {
  for (std::size_t i = 0; i < kDescriptions.size(); ++i)
    if (static_cast<std::size_t>(kDescriptions[i].kind) != i + 1)
      return false;
  return kDescriptions.size() + 1 == static_cast<std::size_t>(EventKind::count);
}
static_assert(in_order(), "every kind is described, in the order of the enumeration");

}  // namespace

std::string_view event_name(EventKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  return index >= 1 && index <= kDescriptions.size() ? kDescriptions[index - 1].name : "";
}

std::span<const std::string_view> event_values(EventKind kind) {
  if (event_name(kind).empty())
    return {};
  const auto& values = kDescriptions[static_cast<std::size_t>(kind) - 1].values;
  return std::span(values).first(static_cast<std::size_t>(std::count_if(
      values.begin(), values.end(), [](std::string_view name) { return !name.empty(); })));
}

}  // namespace eyrie::model
