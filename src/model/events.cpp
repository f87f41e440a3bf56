// SPDX-License-Identifier: MIT
#include "model/events.hpp"

#include <array>
#include <initializer_list>

namespace eyrie::model {

namespace {

struct Value {
  const char* name;
  const char* unit;
};
struct Description {
  EventKind kind;
  std::string_view name;
  std::array<Value, 3> values{};
};

using E = EventKind;
constexpr std::array kDescriptions{
    Description{E::contact, "contact", {{{"range", "m"}, {"sources", ""}}}},
    Description{E::track_lost, "track_lost", {{{"age", "s"}}}},
    Description{E::identified, "identified", {{{"identity", ""}, {"range", "m"}}}},
    Description{E::rwr_warning, "rwr_warning", {{{"kind", ""}, {"bearing", "rad"}}}},
    Description{E::missile_warning, "missile_warning", {{{"bearing", "rad"}}}},
    Description{E::release, "release", {{{"store", ""}, {"range", "m"}}}},
    Description{E::launch, "launch", {{{"range", "m"}, {"store", ""}}}},
    Description{E::seeker_active, "seeker_active", {{{"range", "m"}}}},
    Description{E::seeker_acquired, "seeker_acquired", {{{"range", "m"}}}},
    Description{E::gun_burst, "gun_burst", {{{"rounds", ""}, {"range", "m"}, {"hits", ""}}}},
    Description{
        E::detonation, "detonation", {{{"miss", "m"}, {"kill_probability", ""}, {"draw", ""}}}},
    Description{E::timeout, "timeout", {{{"reason", ""}, {"flight_time", "s"}}}},
    Description{E::hit, "hit", {{{"damage", ""}, {"miss", "m"}}}},
    Description{E::kill, "kill"},
    Description{E::crash, "crash"},
    Description{E::fuel_out, "fuel_out"},
    Description{E::bingo, "bingo", {{{"fuel", "kg"}}}},
    Description{E::winchester, "winchester"},
    Description{E::home, "home"},
    Description{E::phase, "phase", {{{"from", ""}, {"to", ""}, {"node", ""}}}},
    Description{E::lead_change, "lead_change", {{{"flight", ""}}}},
    Description{E::commit, "commit", {{{"range", "m"}}}},
    Description{E::defend, "defend", {{{"phase", ""}}}},
    Description{E::in_charge, "in_charge", {{{"node", ""}, {"vote", ""}}}},
    Description{E::order, "order", {{{"kind", ""}}}},
    Description{E::eject, "eject", {{{"store", ""}, {"last", ""}}}},
};

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

void describe_events(sim::SchemaBuilder& builder) {
  for (const Description& d : kDescriptions) {
    const auto& v = d.values;
    const auto named = [](const Value& value) { return sim::NamedValue{value.name, value.unit}; };
    if (v[0].name == nullptr)
      builder.add_event(d.kind, d.name);
    else if (v[1].name == nullptr)
      builder.add_event(d.kind, d.name, {named(v[0])});
    else if (v[2].name == nullptr)
      builder.add_event(d.kind, d.name, {named(v[0]), named(v[1])});
    else
      builder.add_event(d.kind, d.name, {named(v[0]), named(v[1]), named(v[2])});
  }
}

}  // namespace eyrie::model
