// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator.hpp"
#include "ubf/simulated_time.hpp"

namespace eyrie::ubf {

struct DelayMemory {
  double since = 0;          ///< s, when it was first asked
  std::uint8_t waiting = 0;  ///< 1: `since` counts
  std::uint8_t open = 0;     ///< 1: the time is up and the child has its turn
  std::uint8_t reserved[6] = {};
};

/// Waits `duration` of simulated time, running and proposing nothing, then asks the child until it
/// has ended. The next time it waits again.
template <class State, class Action>
class Delay final : public WithMemory<Decorator<State, Action>, DelayMemory> {
 public:
  static constexpr std::string_view type_name = "delay";
  static constexpr std::string_view help = "waits before it asks its child";
  [[nodiscard]] static constexpr auto params() {
    return std::tuple{
        param("duration", &Delay::duration, "s", positive(1e6), "how long it waits").required()};
  }
  using WithMemory<Decorator<State, Action>, DelayMemory>::WithMemory;

  double duration = 0;  ///< s

  [[nodiscard]] bool stands() const noexcept override { return false; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (!m.waiting)
      m = {.since = t.time, .waiting = 1};
    if (!m.open && !passed(t.time, m.since, duration))
      return Status::running;
    m.open = 1;
    const Status answer = this->ask_child(t, out);
    if (answer == Status::running)
      return answer;
    this->close(this->child(), t);
    m = {};
    return answer;
  }
};

}  // namespace eyrie::ubf
