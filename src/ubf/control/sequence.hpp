// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/control/reactive.hpp"

namespace eyrie::ubf {

/// Asks the children in order, from the first in every tick, until one does not succeed, and
/// answers what that one did; succeeds if every child succeeds. What goes up is the proposal of the
/// last child asked that made one: conditions make none, so [condition, action] sends up the
/// action. A failing sequence proposes nothing. Reactive: a condition further left is checked again
/// in every tick. Colledanchise and Ogren, Behavior Trees in Robotics and AI (2018), algorithm 1.
template <class State, class Action>
class Sequence final : public Reactive<State, Action> {
 public:
  static constexpr std::string_view type_name = "sequence";
  static constexpr std::string_view help = "one child after the other, as long as they succeed";
  static constexpr Kind kind = Kind::control;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<Sequence>();
  }
  using Reactive<State, Action>::Reactive;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    Status status = Status::success;
    std::size_t asked = 0;
    for (const auto& child : this->children_) {
      status = this->ask_over(*child, t, out);
      ++asked;
      if (status != Status::success)
        break;
    }
    this->settle(t, asked, status);
    this->rescale(out);
    return status;
  }
};

}  // namespace eyrie::ubf
