// SPDX-License-Identifier: MIT
#include "model/events.hpp"

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

constexpr std::array kDescriptions{
    Description{EventKind::contact, "contact", {{{"range", "m"}, {"sources", ""}}}},
    Description{EventKind::track_lost, "track_lost", {{{"age", "s"}}}},
    Description{EventKind::identified, "identified", {{{"identity", ""}, {"range", "m"}}}},
    Description{EventKind::rwr_warning, "rwr_warning", {{{"kind", ""}, {"bearing", "rad"}}}},
    Description{EventKind::missile_warning, "missile_warning", {{{"bearing", "rad"}}}},
    Description{EventKind::release, "release", {{{"store", ""}, {"range", "m"}}}},
    Description{EventKind::launch, "launch", {{{"range", "m"}, {"store", ""}}}},
    Description{EventKind::seeker_active, "seeker_active", {{{"range", "m"}}}},
    Description{EventKind::seeker_acquired, "seeker_acquired", {{{"range", "m"}}}},
    Description{
        EventKind::gun_burst, "gun_burst", {{{"rounds", ""}, {"range", "m"}, {"hits", ""}}}},
    Description{EventKind::detonation,
                "detonation",
                {{{"miss", "m"}, {"kill_probability", ""}, {"draw", ""}}}},
    Description{EventKind::timeout, "timeout", {{{"reason", ""}, {"flight_time", "s"}}}},
    Description{EventKind::hit, "hit", {{{"damage", ""}, {"miss", "m"}}}},
    Description{EventKind::kill, "kill"},
    Description{EventKind::crash, "crash"},
    Description{EventKind::fuel_out, "fuel_out"},
    Description{EventKind::bingo, "bingo", {{{"fuel", "kg"}}}},
    Description{EventKind::winchester, "winchester"},
    Description{EventKind::home, "home"},
    Description{EventKind::phase, "phase", {{{"from", ""}, {"to", ""}, {"node", ""}}}},
    Description{EventKind::lead_change, "lead_change", {{{"flight", ""}}}},
    Description{EventKind::commit, "commit", {{{"range", "m"}}}},
    Description{EventKind::defend, "defend", {{{"phase", ""}}}},
    Description{EventKind::in_charge, "in_charge", {{{"node", ""}, {"vote", ""}}}},
    Description{EventKind::order, "order", {{{"kind", ""}}}},
    Description{EventKind::eject, "eject", {{{"store", ""}, {"last", ""}}}},
    Description{EventKind::scatter, "scatter", {{{"range", "m"}}}},
    Description{EventKind::loss, "loss"},
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
