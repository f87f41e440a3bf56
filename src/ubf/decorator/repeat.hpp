// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator/repeating.hpp"

namespace eyrie::ubf {

/// Asks the child again after it succeeded, in the next tick, until it has succeeded `count` times;
/// running meanwhile. Fails as soon as the child does. Without a count it never succeeds.
template <class State, class Action>
class Repeat final : public Repeating<State, Action> {
 public:
  static constexpr std::string_view type_name = "repeat";
  static constexpr std::string_view help = "a child over and over, as long as it succeeds";
  [[nodiscard]] static constexpr auto params() {
    return std::tuple{param("count", &Repeat::count, range(1, 1e9),
                            "this many successes make a success; null: repeats for ever")};
  }
  using Repeating<State, Action>::Repeating;

  std::optional<std::uint32_t> count;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->loop(t, out, Status::success, count);
  }
};

}  // namespace eyrie::ubf
