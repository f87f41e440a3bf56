// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one driver keeps from decision to decision besides the memory of his tree.
#include <cstdint>
#include <string_view>

#include "core/field.hpp"
#include "core/id.hpp"
#include "driver/action.hpp"
#include "team/deciding.hpp"

namespace eyrie::driver {

/// Recorders find here what the last decision was.
struct Agent {
  static constexpr std::string_view system = "driver";  ///< who writes this row

  std::uint64_t decided = 0;  ///< step of the last decision
  PlayerId lead{};            ///< who he believes leads
  std::uint32_t ticks = 0;    ///< decisions so far
  float vote = 0;             ///< of what the tree recommended last
  Call call = Call::none;
  std::uint16_t tree = team::kNoTree;  ///< index into the scenario's trees for drivers
  std::uint16_t node = ubf::kNone;     ///< the behavior whose recommendation led; kNone: none
  std::uint16_t phase = ubf::kNone;    ///< what the outermost sequencer has in charge; kNone: none
  std::uint8_t reserved[2] = {};

  static constexpr auto fields() {
    return field_list(field("decided", &Agent::decided), field("lead", &Agent::lead),
                      field("ticks", &Agent::ticks), field("vote", &Agent::vote),
                      field("call", &Agent::call), field("tree", &Agent::tree),
                      field("node", &Agent::node), field("phase", &Agent::phase),
                      field("reserved", &Agent::reserved));
  }
};

/// What drivers add to the table of vehicles.
using DriverColumns = team::AgentColumns<Agent>;

}  // namespace eyrie::driver
