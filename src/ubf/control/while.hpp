// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/composite.hpp"

namespace eyrie::ubf {

struct WhileMemory {
  std::uint8_t open = 0;  ///< the branch that goes on since the last tick, 0 for none
};

/// Asks `do` while the condition `when` succeeds and `else` otherwise. The condition is checked in
/// every tick; the branch that it turns away from forgets if it was going on. The branch's proposal
/// and status go up; what `when` proposes is ignored. A `when` that answers running does not hold,
/// and forgets. Without an `else` it would be a guard.
template <class State, class Action>
class While final : public WithMemory<Voting<State, Action>, WhileMemory> {
  using Base = WithMemory<Voting<State, Action>, WhileMemory>;

 public:
  static constexpr std::string_view type_name = "while";
  static constexpr std::string_view help = "one of two children, as a condition says in every tick";
  static constexpr Kind kind = Kind::control;
  static constexpr std::array<std::string_view, 3> slots{"when", "do", "else"};
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<While>();
  }
  using Base::Base;

  [[nodiscard]] bool remembers() const noexcept override { return false; }
  [[nodiscard]] bool stands() const noexcept override { return this->any_child_stands(); }
  [[nodiscard]] std::string problem() const override {
    return this->children_.size() == 3 ? Base::problem() : "while has a condition and two children";
  }
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept override {
    const auto& m = this->memory(slab);
    return m.open ? m.open : kNone;
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    const auto& when = *this->children_[0];
    const Status holds = this->ask(when, t, out);
    if (holds == Status::running)
      this->halt(when, t);
    const std::uint8_t branch = holds == Status::success ? 1 : 2;
    if (m.open && m.open != branch)
      this->halt(*this->children_[m.open], t);
    const auto& child = *this->children_[branch];
    const Status answer = this->ask(child, t, out);
    this->took(t, child);
    this->rescale(out);
    m.open = this->left_open(child, answer) ? branch : 0;
    return answer;
  }
};

}  // namespace eyrie::ubf
