// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator.hpp"
#include "ubf/simulated_time.hpp"

namespace eyrie::ubf {

struct CooldownMemory {
  double ended = 0;          ///< s, the tick in which the child ended
  std::uint8_t cooling = 0;  ///< 1: not asked until `duration` has passed since
  std::uint8_t running = 0;  ///< 1: the child was running in the last tick
  std::uint8_t reserved[6] = {};
};

/// After the child has ended, that is succeeded, or failed after running, it is not asked for
/// `duration` seconds of simulated time; the node fails meanwhile. A child that fails without ever
/// having run was not applicable and starts nothing. A cooldown that is halted while its child runs
/// forgets; one that is cooling was left by nobody and goes on cooling.
template <class State, class Action>
class Cooldown final : public WithMemory<Decorator<State, Action>, CooldownMemory> {
 public:
  static constexpr std::string_view type_name = "cooldown";
  static constexpr std::string_view help = "keeps a child that has ended from starting again";
  [[nodiscard]] static constexpr auto params() {
    return std::tuple{
        param("duration", &Cooldown::duration, "s", positive(1e6), "how long it stays shut")
            .required()};
  }
  using WithMemory<Decorator<State, Action>, CooldownMemory>::WithMemory;

  double duration = 0;  ///< s

  [[nodiscard]] bool stands() const noexcept override { return false; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (m.cooling && !passed(t.time, m.ended, duration))
      return Status::failure;
    const Status answer = this->ask_child(t, out);
    if (answer != Status::running)
      this->close(this->child(), t);
    const bool ended = answer == Status::success || (answer == Status::failure && m.running);
    m = {};
    m.running = answer == Status::running;
    if (ended)
      m = {.ended = t.time, .cooling = 1};
    return answer;
  }
};

}  // namespace eyrie::ubf
