// SPDX-License-Identifier: MIT
#pragma once
/// \file  Leaves that look at nothing: always the same answer, or running for a while.
#include "ubf/behavior.hpp"
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

}  // namespace eyrie::ubf
