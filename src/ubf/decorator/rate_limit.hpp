// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/decorator.hpp"
#include "ubf/simulated_time.hpp"

namespace eyrie::ubf {

struct RateLimitMemory {
  double began = 0;          ///< s, when the child last began
  std::uint8_t limited = 0;  ///< 1: `began` counts
  std::uint8_t running = 0;  ///< 1: the child was running in the last tick
  std::uint8_t reserved[6] = {};
};

/// Lets the child begin at most once per `period` of simulated time; a child that runs is asked in
/// every tick until it ends. Fails while it keeps the child from beginning. A child that fails
/// without having run did not begin. `cooldown` counts from the end, this from the beginning.
template <class State, class Action>
class RateLimit final : public WithMemory<Decorator<State, Action>, RateLimitMemory> {
 public:
  static constexpr std::string_view type_name = "rate_limit";
  static constexpr std::string_view help = "keeps a child from beginning too often";
  [[nodiscard]] static constexpr auto params() {
    return std::tuple{param("period", &RateLimit::period, "s", positive(1e6),
                            "least time from one beginning to the next")
                          .required()};
  }
  using WithMemory<Decorator<State, Action>, RateLimitMemory>::WithMemory;

  double period = 0;  ///< s

  [[nodiscard]] bool stands() const noexcept override { return false; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (!m.running && m.limited && !passed(t.time, m.began, period))
      return Status::failure;
    const Status answer = this->ask_child(t, out);
    if (answer != Status::running)
      this->close(this->child(), t);
    if (!m.running && answer != Status::failure)
      m = {.began = t.time, .limited = 1};
    m.running = answer == Status::running;
    return answer;
  }
};

}  // namespace eyrie::ubf
