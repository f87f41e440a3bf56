// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/composite.hpp"

namespace eyrie::ubf {

struct IfThenElseMemory {
  std::uint8_t branch = 0;  ///< the child in charge, 0 while the condition is asked
};

/// Asks the condition `if` until it has ended, then `then` after a success or `else` after a
/// failure until that has ended: the condition is not asked again meanwhile. The branch's proposal
/// and status go up; a running condition is running and proposes nothing. When
/// it has ended, nothing in it goes on. Without an `else` it would be a sequence with memory.
template <class State, class Action>
class IfThenElse final : public WithMemory<Voting<State, Action>, IfThenElseMemory> {
  using Base = WithMemory<Voting<State, Action>, IfThenElseMemory>;

 public:
  static constexpr std::string_view type_name = "if_then_else";
  static constexpr std::string_view help =
      "one of two children, as a condition says when it begins";
  static constexpr Kind kind = Kind::control;
  static constexpr std::array<std::string_view, 3> slots{"if", "then", "else"};
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<IfThenElse>();
  }
  using Base::Base;

  [[nodiscard]] std::string problem() const override {
    return this->children_.size() == 3 ? Base::problem()
                                       : "if_then_else has a condition and two children";
  }
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept override {
    const auto& m = this->memory(slab);
    return m.branch ? m.branch : kNone;
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (m.branch == 0) {
      const auto& condition = *this->children_[0];
      const Status holds = this->ask(condition, t, out);
      out.clear();
      if (holds == Status::running)
        return holds;
      this->close(condition, t);
      m.branch = holds == Status::success ? 1 : 2;
    }
    const auto& branch = *this->children_[m.branch];
    const Status answer = this->ask(branch, t, out);
    this->took(t, branch);
    this->rescale(out);
    if (answer == Status::running)
      return answer;
    this->close(branch, t);
    m = {};
    return answer;
  }
};

}  // namespace eyrie::ubf
