// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator.hpp"
#include "ubf/simulated_time.hpp"

namespace eyrie::ubf {

struct TimeoutMemory {
  double begun = 0;          ///< s, the tick in which the child began to run
  std::uint8_t running = 0;  ///< 1: it still was in the last tick
  std::uint8_t reserved[7] = {};
};

/// Gives the child `after` seconds of simulated time from the tick in which it began to run. In the
/// first tick at or past that the child is not asked: it forgets, and the node fails. The next tick
/// begins anew; a cooldown around the timeout keeps it shut.
template <class State, class Action>
class Timeout final : public WithMemory<Decorator<State, Action>, TimeoutMemory> {
 public:
  static constexpr std::string_view type_name = "timeout";
  static constexpr std::string_view help = "fails and halts a child that runs for too long";
  [[nodiscard]] static constexpr auto params() {
    return std::tuple{
        param("after", &Timeout::after, "s", positive(1e6), "how long the child may run")
            .required()};
  }
  using WithMemory<Decorator<State, Action>, TimeoutMemory>::WithMemory;

  double after = 0;  ///< s

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (m.running && passed(t.time, m.begun, after)) {
      this->halt(this->child(), t);
      m = {};
      return Status::failure;
    }
    const double begun = m.running ? m.begun : t.time;
    const Status answer = this->ask_child(t, out);
    m = {};
    if (answer == Status::running)
      m = {.begun = begun, .running = 1};
    return answer;
  }
};

}  // namespace eyrie::ubf
