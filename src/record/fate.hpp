// SPDX-License-Identifier: MIT
#pragma once
/// \file  Who leaves the run by an event, and how.
#include <optional>
#include <string_view>

#include "model/events.hpp"
#include "record/names.hpp"

namespace eyrie::record {

struct Fate {
  PlayerId who;
  std::string_view end;  ///< "lost", "home"; of a missile "kill", "miss", "trashed"
};

/// Nothing for an event by which nobody leaves.
[[nodiscard]] inline std::optional<Fate> fate_of(const sim::Event& e) {
  using model::EventKind;
  switch (kind_of(e)) {
    case EventKind::detonation:  // the draw was below the kill probability
      return Fate{e.who, e.values[2] < e.values[1] ? "kill" : "miss"};
    case EventKind::timeout:
      return Fate{e.who, "trashed"};
    case EventKind::kill:
      return Fate{e.whom, "lost"};
    case EventKind::crash:
    case EventKind::loss:
      return Fate{e.who, "lost"};
    case EventKind::home:
      return Fate{e.who, "home"};
    default:
      return std::nullopt;
  }
}

}  // namespace eyrie::record
