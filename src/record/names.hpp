// SPDX-License-Identifier: MIT
#pragma once
/// \file  What events mean in names: phases, stores, behaviors.
#include <string>

#include "model/events.hpp"
#include "scenario/scenario.hpp"
#include "sim/event.hpp"

namespace eyrie::record {

[[nodiscard]] inline model::EventKind kind_of(const sim::Event& e) {
  return static_cast<model::EventKind>(e.kind.value);
}

/// Of a phase event: whether its sequencer is the outermost one of the player's tree.
[[nodiscard]] bool is_outermost(const scenario::Scenario& scenario, const sim::Event& phase);
/// Of a phase event: the name of the tree that was entered, such as "ingress".
[[nodiscard]] std::string phase_name(const scenario::Scenario& scenario, const sim::Event& phase);
/// Label of a missile type by its index in the library, "?" if there is none.
[[nodiscard]] std::string store_label(const scenario::Scenario& scenario, float index);

}  // namespace eyrie::record
