// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/control/resuming.hpp"

namespace eyrie::ubf {

/// A selector that resumes: while a child is running, those before it are not asked again. Fails
/// when the last child has failed; succeeds or fails, it starts from the first child the next time.
/// Marzinotto et al., "Towards a Unified Behavior Trees Framework for Robot Control" (ICRA 2014),
/// "selector*".
template <class State, class Action>
class SelectorWithMemory final : public Resuming<State, Action> {
 public:
  static constexpr std::string_view type_name = "selector_with_memory";
  static constexpr std::string_view help =
      "the first child that does not fail; a running child is not interrupted";
  static constexpr Kind kind = Kind::control;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<SelectorWithMemory>();
  }
  using Resuming<State, Action>::Resuming;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->resume(t, out, Status::failure);
  }
};

}  // namespace eyrie::ubf
