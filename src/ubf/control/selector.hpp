// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/control/reactive.hpp"

namespace eyrie::ubf {

/// Asks the children in order, from the first in every tick, until one does not fail; that child's
/// proposal and status go up. Fails if every child fails. Also called fallback; reactive, so a
/// child further left takes over as soon as it can. Isla, "Handling Complexity in the Halo 2 AI"
/// (GDC 2005); Colledanchise and Ogren, Behavior Trees in Robotics and AI (2018), algorithm 2.
template <class State, class Action>
class Selector final : public Reactive<State, Action> {
 public:
  static constexpr std::string_view type_name = "selector";
  static constexpr std::string_view help = "the first child that does not fail";
  static constexpr Kind kind = Kind::control;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<Selector>();
  }
  using Reactive<State, Action>::Reactive;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    Status status = Status::failure;
    std::size_t asked = 0;
    for (const auto& child : this->children_) {
      ++asked;
      status = this->ask(*child, t, out);
      if (status == Status::failure)
        continue;
      this->took(t, *child);
      this->rescale(out);
      break;
    }
    this->settle(t, asked, status);
    return status;
  }
};

}  // namespace eyrie::ubf
