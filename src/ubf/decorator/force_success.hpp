// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator.hpp"

namespace eyrie::ubf {

/// Failure becomes success, which proposes nothing; everything else passes.
template <class State, class Action>
class ForceSuccess final : public Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "force_success";
  static constexpr std::string_view help = "failure becomes success; running stays running";
  using Decorator<State, Action>::Decorator;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const Status answer = this->ask_child(t, out);
    if (answer != Status::failure)
      return answer;
    out.clear();
    return Status::success;
  }
};

}  // namespace eyrie::ubf
