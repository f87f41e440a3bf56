// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every driver's decision: perceive, ask the tree, act. The decide phase of vehicles.
#include "driver/state.hpp"
#include "team/agent_system.hpp"

namespace eyrie::driver {

/// Orders that drivers carry out.
enum class OrderKind : std::uint16_t { none = 0, swap_tree = 2 };

/// Emits the events of one driver in one decision.
class Teller : public team::Telling {
 public:
  Teller(PlayerId who, const State& state, sim::Outbox& out)
      : Telling(who, state.own.position, out), state_(state) {}
  void notice(Agent& agent, const model::Fit& fit) const { new_lead(agent, state_.datalink, fit); }
  void changes(const Agent& before, const Proposal& decided, const Agent& agent) const;

 private:
  const State& state_;
};

/// What drivers are to team::AgentSystem. They tell phase, in_charge, lead_change and scatter.
struct Driving : Platform {
  using Agent = driver::Agent;
  using Columns = model::VehicleColumns;
  using Plan = Spacing;
  using View = Cab;
  using Teller = driver::Teller;
  /// What he writes.
  struct Controls {
    model::DriveCommand& command;
    static constexpr auto columns() { return Lines{&Columns::command}; }
  };
  static constexpr auto swap_tree = OrderKind::swap_tree;

  static void account(const State&, Agent&) {}
  static void rest(const Controls&) {}
  static void execute(const Action& action, const State&, const Controls& controls, Agent& agent) {
    driver::execute(action, controls.command, agent);
  }
};

using DriverSystem = team::AgentSystem<Driving>;
using DriverSetup = DriverSystem::Setup;

}  // namespace eyrie::driver

extern template class eyrie::team::AgentSystem<eyrie::driver::Driving>;
