// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot's decision has to tell, as events.
#include "model/events.hpp"
#include "pilot/agent.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "sim/event.hpp"

namespace eyrie::pilot {

/// Emits the events of one pilot in one decision.
class Teller {
 public:
  Teller(PlayerId who, const State& state, sim::Outbox& out)
      : who_(who), state_(state), out_(out) {}

  /// What he notices whatever his tree says: that he leads now, that the fuel is down to bingo.
  void notice(Agent& agent, const model::Fit& fit) const;
  /// Every change of a sequencer; that of the `outermost` one is kept in the agent's phase.
  void transitions(const ubf::TransitionLog& log, ubf::NodeIndex outermost, Agent& agent) const;
  /// A new behavior in charge, a commit on somebody new, a defense, a landing.
  void changes(const Agent& before, const Proposal& decided, Agent& agent) const;

 private:
  void tell(model::EventKind kind, PlayerId whom, std::uint16_t aux, double a = 0, double b = 0,
            double c = 0) const;

  PlayerId who_;
  const State& state_;
  sim::Outbox& out_;
};

}  // namespace eyrie::pilot
