// SPDX-License-Identifier: MIT
#pragma once
/// \file  The platform's side of an aircraft: how a state is perceived (pilot/state.hpp) and how an
/// action is carried out.
#include "model/command.hpp"
#include "pilot/agent.hpp"
#include "pilot/state.hpp"

namespace eyrie::pilot {

/// Carries out what the tree recommends: numbers and mode go to the autopilot, orders become
/// requests to radar, stores and gun. What an empty field means is said in pilot/action.hpp.
///
/// A mode that lacks what it needs (a follow without anybody to follow) is flown as hold with the
/// numbers. A target that is no longer held, or no longer hostile, is dropped; a release at anybody
/// who is not identified as hostile is refused, whoever recommends it.
void execute(const Action& action, const State& state, model::Command& command,
             model::Request& request, Agent& agent);

/// Notices which missiles have left since the last decision. To be called before the tree is asked.
void account_for_shots(const State& state, Agent& agent);

}  // namespace eyrie::pilot
