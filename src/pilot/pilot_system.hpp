// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every pilot's decision: perceive, ask the tree, act. The decide phase of aircraft.
#include "model/events.hpp"
#include "pilot/agent.hpp"
#include "pilot/controller.hpp"
#include "pilot/outside.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "sim/event.hpp"
#include "team/agent_system.hpp"
#include "team/deciding.hpp"

namespace eyrie::pilot {

/// Emits the events of one pilot in one decision.
class Teller : public team::Telling {
 public:
  Teller(PlayerId who, const State& state, sim::Outbox& out)
      : Telling(who, state.own.position, out), state_(state) {}

  /// What he notices whatever his tree says: that he leads now, that the fuel is down to bingo.
  void notice(Agent& agent, const model::Fit& fit) const;
  /// A new behavior in charge, a commit on somebody new, a defense, a landing.
  void changes(const Agent& before, const Proposal& decided, Agent& agent) const;

 private:
  const State& state_;
};

/// What pilots are to team::AgentSystem. They tell phase, in_charge, defend, commit, lead_change,
/// bingo and home.
struct Piloting : Platform {
  using Agent = pilot::Agent;
  using Columns = model::AircraftColumns;
  using Plan = Formation;
  using View = Cockpit;
  using Teller = pilot::Teller;
  using Outside = pilot::Outside;
  /// What he writes.
  struct Controls {
    model::Command& command;
    model::Request& request;
    static constexpr auto columns() { return Lines{&Columns::command, &Columns::request}; }
  };
  static constexpr auto swap_tree = OrderKind::swap_tree;

  static void account(const State& state, Agent& agent) { account_for_shots(state, agent); }
  /// A release is asked for once, not until the next decision.
  static void rest(const Controls& controls) {
    controls.request.shoot_at = {};
    controls.request.store = 0;
  }
  static void execute(const Action& action, const State& state, const Controls& controls,
                      Agent& agent) {
    pilot::execute(action, state, controls.command, controls.request, agent);
  }
};

using PilotSystem = team::AgentSystem<Piloting>;
using PilotSetup = PilotSystem::Setup;

}  // namespace eyrie::pilot

extern template class eyrie::team::AgentSystem<eyrie::pilot::Piloting>;
