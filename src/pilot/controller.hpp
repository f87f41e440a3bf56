// SPDX-License-Identifier: MIT
#pragma once
/// \file  The platform's side of an aircraft: how an action is carried out.
#include "model/command.hpp"
#include "pilot/agent.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Carries out what the tree recommends: numbers and mode go to the autopilot, orders become
/// requests to radar, stores and gun. Fields that are empty leave the last command as it is;
/// requests that nobody makes end. A mode that lacks what it needs (a follow without anybody to
/// follow) is flown as hold with the numbers.
void execute(const Action& action, const State& state, model::Command& command,
             model::Request& request, Agent& agent);

/// s, until a missile released now may have arrived: the range over the mean speed of a missile
/// plus what the target closes by itself.
[[nodiscard]] double time_of_flight(const State& state, const Seen& target);

}  // namespace eyrie::pilot
