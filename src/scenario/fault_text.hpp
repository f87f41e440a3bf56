// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "scenario/roster.hpp"
#include "sim/event.hpp"

namespace eyrie::scenario {

/// "eagle1 at 12.3 s (step 615): root/pursue of tree 'pilot', from libmine.so, threw: no fuel"
[[nodiscard]] std::string fault_text(const sim::Fault& fault, const Roster& roster, double dt);

/// The fault of whoever ends the program in the middle of this thread's decision; its player is
/// none if the thread makes no decision. `done` as of EndGuard.
[[nodiscard]] sim::Fault fault_of_end(const std::string& done);

}  // namespace eyrie::scenario
