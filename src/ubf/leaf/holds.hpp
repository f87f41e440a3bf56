// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/behavior.hpp"
#include "ubf/expression.hpp"
#include "ubf/registry.hpp"

namespace eyrie::ubf {

/// A condition in words over the named fields of the state: `holds: range < 10 nmi`, or the words
/// alone in the place of a node.
template <class State, class Action>
class Holds final : public Condition<State, Action> {
 public:
  static constexpr std::string_view type_name = kHolds;
  static constexpr std::string_view help = "holds if a comparison of state fields does";
  static constexpr std::string_view text_key = "that";
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("that", &Holds::that, "as in range < 10 nmi and not threatened").required()};
  }

  std::string that;

  [[nodiscard]] std::string problem() const override {
    return expression_.empty() ? "holds needs a condition to look at" : "";
  }
  [[nodiscard]] bool holds(const Tick<State>& t) const override {
    return expression_.holds(t.state);
  }
  /// For code that builds a tree without a file.
  void look_at(Expression<State> expression) { expression_ = std::move(expression); }
  /// From a file.
  void read(const NodeSpec& spec, NodeReader& reader) {
    if (const Value* text = spec.body->find(text_key))
      expression_ = Expression<State>(reader.expression(*text));
  }

 private:
  Expression<State> expression_;
};

}  // namespace eyrie::ubf
