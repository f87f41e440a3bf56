// SPDX-License-Identifier: MIT
#pragma once
/// \file  Another status than the child's.
#include "ubf/decorator.hpp"

namespace eyrie::ubf {

/// Success becomes failure and failure success; running stays. A failing child's proposal is
/// ignored as everywhere, so the success made of it proposes nothing.
template <class State, class Action>
class Inverter final : public Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "inverter";
  static constexpr std::string_view help = "success becomes failure and failure success";
  using Decorator<State, Action>::Decorator;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    switch (this->ask_child(t, out)) {
      case Status::running:
        return Status::running;
      case Status::success:
        return Status::failure;
      case Status::failure:
        break;
    }
    out.clear();
    return Status::success;
  }
};

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
