// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/composite.hpp"

namespace eyrie::ubf {

/// Asks every child and hands on the proposal with the highest vote, with its child's status.
/// Equal votes: the earlier child. Failing and abstaining children are ignored; if that leaves
/// none, it fails. Roberson et al. (CSC'15), section III.C.2.
template <class State, class Action>
class WinnerTakesAll final : public Voting<State, Action> {
 public:
  static constexpr std::string_view type_name = "winner_takes_all";
  static constexpr std::string_view help = "the proposal with the highest vote";
  static constexpr Kind kind = Kind::arbiter;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<WinnerTakesAll>();
  }
  using Voting<State, Action>::Voting;

  [[nodiscard]] bool stands() const noexcept override { return true; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    Status status = Status::failure;  // stays, with an empty proposal, if nobody is heard
    const typename WinnerTakesAll::Node* winner = nullptr;  // noted for the trace alone
    Scratch<Action> other;
    BestSoFar<Action> best(out, other);
    for (const auto& child : this->children_) {
      const Status answer = this->ask(*child, t, best.next());
      if (answer == Status::failure || !(best.next().vote > best.kept().vote))
        continue;
      status = answer;
      if (t.trace) [[unlikely]]
        winner = child.get();
      best.keep();
    }
    best.hand_on();
    this->rescale(out);
    if (winner) [[unlikely]]
      this->took(t, *winner);
    return status;
  }
};

}  // namespace eyrie::ubf
