// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator.hpp"

namespace eyrie::ubf {

/// Success becomes failure; everything else passes.
template <class State, class Action>
class ForceFailure final : public Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "force_failure";
  static constexpr std::string_view help = "success becomes failure; running stays running";
  using Decorator<State, Action>::Decorator;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const Status answer = this->ask_child(t, out);
    return answer == Status::success ? Status::failure : answer;
  }
};

}  // namespace eyrie::ubf
