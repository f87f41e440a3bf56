// SPDX-License-Identifier: MIT
#pragma once
/// \file  What drivers add to the table of vehicles.
#include <algorithm>
#include <cstdint>

#include "driver/agent.hpp"
#include "sim/schema.hpp"

namespace eyrie::driver {

/// Written in decide.
struct DriverColumns {
  sim::Column<Agent> agent;
  sim::ByteColumn brain;  ///< memory of the tree, large enough for every tree of the scenario

  [[nodiscard]] static DriverColumns define(sim::SchemaBuilder& builder, TableId vehicles,
                                            std::uint32_t brain_bytes) {
    return {.agent = builder.add_column<Agent>(vehicles, "agent"),
            .brain = builder.add_bytes(vehicles, "brain", std::max<std::uint32_t>(brain_bytes, 8))};
  }
};

}  // namespace eyrie::driver
