// SPDX-License-Identifier: MIT
#pragma once
/// \file  Leaves: always the same answer, running for a while, or a condition in words.
#include "ubf/behavior.hpp"
#include "ubf/expression.hpp"
#include "ubf/registry.hpp"

namespace eyrie::ubf {

/// Succeeds, and proposes nothing.
template <class State, class Action>
class AlwaysSuccess final : public Condition<State, Action> {
 public:
  static constexpr std::string_view type_name = "always_success";
  static constexpr std::string_view help = "holds, whatever is";
  [[nodiscard]] bool holds(const Tick<State>& /*t*/) const override { return true; }
};

/// Fails.
template <class State, class Action>
class AlwaysFailure final : public Condition<State, Action> {
 public:
  static constexpr std::string_view type_name = "always_failure";
  static constexpr std::string_view help = "holds never";
  [[nodiscard]] bool holds(const Tick<State>& /*t*/) const override { return false; }
};

struct WaitMemory {
  double since = 0;         ///< s, when it was first asked
  std::uint8_t counts = 0;  ///< 1: `since` counts
  std::uint8_t reserved[7] = {};
};

/// Running, without a proposal, for `duration` of simulated time from the tick in which it was
/// first asked; then it succeeds, and the next time it waits again. Wait of the Unreal Engine,
/// Sleep of BehaviorTree.CPP.
///   wait: {duration: 3 s}
template <class State, class Action>
class Wait final : public WithMemory<Behavior<State, Action>, WaitMemory> {
 public:
  static constexpr std::string_view type_name = "wait";
  static constexpr std::string_view help = "proposes nothing for a while, then succeeds";
  [[nodiscard]] static constexpr auto params() {
    return Lines{
        param("duration", &Wait::duration, "s", positive(1e6), "how long it waits").required()};
  }

  double duration = 0;  ///< s

  Status tick(const Tick<State>& t, Proposal<Action>& /*out*/) const override {
    auto& m = this->memory(t);
    if (!m.counts)
      m = {.since = t.time, .counts = 1};
    if (!passed(t.time, m.since, duration))
      return Status::running;
    m = {};
    return Status::success;
  }
};

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
