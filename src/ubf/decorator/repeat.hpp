// SPDX-License-Identifier: MIT
#pragma once
/// \file  A child over and over: as long as it succeeds, or until it does.
#include <cstdint>
#include <optional>

#include "ubf/decorator.hpp"

namespace eyrie::ubf {

struct RepeatingMemory {
  std::uint32_t rounds = 0;  ///< how often the child ended as it should
};

/// The base of repeat and retry: a child that ended in one way begins anew in the next tick, at
/// most once per tick, so that a loop takes simulated time. A standing child that ended forgets.
template <class State, class Action>
class Repeating : public WithMemory<Decorator<State, Action>, RepeatingMemory> {
 public:
  using WithMemory<Decorator<State, Action>, RepeatingMemory>::WithMemory;

  [[nodiscard]] bool stands() const noexcept final { return false; }

 protected:
  /// Running until the child has answered `again` that often (null: for ever) or ended otherwise.
  Status loop(const Tick<State>& t, Proposal<Action>& out, Status again,
              std::optional<std::uint32_t> rounds) const {
    auto& m = this->memory(t);
    const Status answer = this->ask_child(t, out);
    if (answer == Status::running)
      return answer;
    this->close(this->child(), t);
    if (answer != again || (rounds && m.rounds + 1 >= *rounds)) {
      m = {};
      return answer;
    }
    if (rounds)
      ++m.rounds;
    if (answer == Status::failure)
      out.clear();
    return Status::running;
  }
};

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
