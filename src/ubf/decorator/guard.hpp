// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator.hpp"

namespace eyrie::ubf {

struct GuardMemory {
  std::uint8_t open = 0;  ///< 1: the child goes on since the last tick
};

/// Asks the child only while `when` succeeds, which is checked in every tick; otherwise it fails,
/// and a child that was going on forgets. What `when` proposes is ignored. A `when` that answers
/// running does not hold, and forgets.
template <class State, class Action>
class Guard final : public WithMemory<Composite<State, Action>, GuardMemory> {
 public:
  static constexpr std::string_view type_name = "guard";
  static constexpr std::string_view help = "asks its child only while a condition holds";
  static constexpr Kind kind = Kind::decorator;
  static constexpr std::array<std::string_view, 2> slots{"when", "child"};
  using WithMemory<Composite<State, Action>, GuardMemory>::WithMemory;

  [[nodiscard]] bool remembers() const noexcept override { return false; }
  [[nodiscard]] bool stands() const noexcept override { return this->any_child_stands(); }
  [[nodiscard]] std::string problem() const override {
    return this->children_.size() == 2 ? "" : "a guard has a condition and one child";
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto &when = *this->children_[0], &child = *this->children_[1];
    auto& m = this->memory(t);
    const Status holds = this->ask(when, t, out);
    if (holds == Status::success) {
      const Status answer = this->ask(child, t, out);
      this->took(t, child);
      m.open = this->left_open(child, answer);
      return answer;
    }
    if (holds == Status::running)
      this->halt(when, t);
    if (m.open)
      this->halt(child, t);
    m.open = 0;
    return Status::failure;
  }
};

}  // namespace eyrie::ubf
