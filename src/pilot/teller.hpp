// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot's decision has to tell, as events.
#include "model/events.hpp"
#include "pilot/agent.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "sim/event.hpp"
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

}  // namespace eyrie::pilot
