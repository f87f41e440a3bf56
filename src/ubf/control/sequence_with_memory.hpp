// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/control/resuming.hpp"

namespace eyrie::ubf {

/// A sequence that resumes: a child that succeeded is not asked again until the sequence has ended.
/// What goes up is the proposal of the last child asked in this tick that made one. Succeeds when
/// the last child has succeeded; succeeds or fails, it starts from the first child the next time.
/// Marzinotto et al., "Towards a Unified Behavior Trees Framework for Robot Control" (ICRA 2014),
/// "sequence*".
template <class State, class Action>
class SequenceWithMemory final : public Resuming<State, Action> {
 public:
  static constexpr std::string_view type_name = "sequence_with_memory";
  static constexpr std::string_view help =
      "one child after the other; what has succeeded is not asked again";
  static constexpr Kind kind = Kind::control;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<SequenceWithMemory>();
  }
  using Resuming<State, Action>::Resuming;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->resume(t, out, Status::success);
  }
};

}  // namespace eyrie::ubf
