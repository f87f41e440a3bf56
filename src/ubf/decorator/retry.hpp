// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator/repeating.hpp"

namespace eyrie::ubf {

/// Asks the child again after it failed, in the next tick, until it has failed `attempts` times;
/// running meanwhile, without a proposal in a tick in which it failed. Succeeds as soon as the
/// child does. Without a number it never fails.
template <class State, class Action>
class Retry final : public Repeating<State, Action> {
 public:
  static constexpr std::string_view type_name = "retry";
  static constexpr std::string_view help = "a child over and over, until it succeeds";
  [[nodiscard]] static constexpr auto params() {
    return std::tuple{param("attempts", &Retry::attempts, range(1, 1e9),
                            "this many failures make a failure; null: tries for ever")};
  }
  using Repeating<State, Action>::Repeating;

  std::optional<std::uint32_t> attempts;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->loop(t, out, Status::failure, attempts);
  }
};

}  // namespace eyrie::ubf
