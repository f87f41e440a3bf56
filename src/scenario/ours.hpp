// SPDX-License-Identifier: MIT
#pragma once
/// \file  Whom this program flies, and whom another one does.
#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "scenario/roster.hpp"

namespace eyrie::scenario {

/// Everybody is remote whom `ours` names neither itself nor by his flight or side; nobody if it
/// names nobody. `list` is what it was read from. Refused: names of nobody, and a remote player who
/// is no aircraft.
void share_out(const std::vector<std::string>& ours, const Value& list, Roster& roster,
               Diagnostics& diagnostics);

}  // namespace eyrie::scenario
