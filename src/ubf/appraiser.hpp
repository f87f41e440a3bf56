// SPDX-License-Identifier: MIT
#pragma once
/// \file  Behaviors that judge commands instead of proposing one.
#include "ubf/behavior.hpp"

namespace eyrie::ubf {

/// A behavior that says of every candidate what it is worth, for the arbiters vote_grid and
/// utility. Its tick answers the status and, as the vote, the weight of its opinion; the action may
/// hold orders and whatever else is not decided on the grid. Under any other arbiter it is a
/// behavior like another.
///
///   class Avoid : public Appraiser<State, Action> {
///     Status tick(const Tick<State>&, Proposal<Action>& out) const override {
///       out.vote = 10;                          // how much the opinion weighs
///       return Status::running;
///     }
///     double appraise(const Tick<State>& t, const Action& candidate) const override {
///       return free_ahead(t.state, *candidate.heading) ? 0 : -1;
///     }
///   };
template <class State, class Action>
class Appraiser : public Behavior<State, Action> {
 public:
  /// What a command is worth: a vote in [-1, 1] for vote_grid, the utility of the outcome, any
  /// finite number, for utility. The fields of the grid are set in `candidate`, no others. Must not
  /// allocate, throw, lock or look at a clock.
  [[nodiscard]] virtual double appraise(const Tick<State>& t, const Action& candidate) const = 0;

  [[nodiscard]] const Appraiser* appraiser() const noexcept final { return this; }
};

}  // namespace eyrie::ubf
