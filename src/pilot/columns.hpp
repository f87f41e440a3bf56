// SPDX-License-Identifier: MIT
#pragma once
/// \file  What pilots add to the table of aircraft.
#include <cstdint>

#include "pilot/agent.hpp"
#include "sim/schema.hpp"

namespace eyrie::pilot {

/// Written in decide.
struct PilotColumns {
  sim::Column<Agent> agent;
  sim::ByteColumn brain;  ///< memory of the tree, large enough for every tree of the scenario

  [[nodiscard]] static PilotColumns define(sim::SchemaBuilder& builder, TableId aircraft,
                                           std::uint32_t brain_bytes);
};

}  // namespace eyrie::pilot
