// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "ubf/composite.hpp"

namespace eyrie::ubf {

/// The base of nodes with exactly one child.
template <class State, class Action>
class Decorator : public Composite<State, Action> {
 public:
  static constexpr Kind kind = Kind::decorator;
  static constexpr std::array<std::string_view, 1> slots{"child"};
  using Composite<State, Action>::Composite;

  [[nodiscard]] bool stands() const noexcept override { return this->any_child_stands(); }
  [[nodiscard]] std::string problem() const override {
    return this->children_.size() == 1 ? "" : "a decorator has exactly one child";
  }

 protected:
  [[nodiscard]] const typename Decorator::Node& child() const { return *this->children_.front(); }

  /// Asks the child on behalf of this node.
  Status ask_child(const Tick<State>& t, Proposal<Action>& out) const {
    const Status answer = this->ask(child(), t, out);
    this->took(t, child());
    return answer;
  }
};

}  // namespace eyrie::ubf
