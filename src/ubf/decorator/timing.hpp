// SPDX-License-Identifier: MIT
#pragma once
/// \file  A child kept within simulated time: how long, how soon again, when first, how often.
#include "ubf/composite.hpp"

namespace eyrie::ubf {

struct TimeoutMemory {
  double begun = 0;          ///< s, the tick in which the child began to run
  std::uint8_t running = 0;  ///< 1: it still was in the last tick
  std::uint8_t reserved[7] = {};
};

/// Gives the child `after` seconds of simulated time from the tick in which it began to run. In the
/// first tick at or past that the child is not asked: it forgets, and the node fails. The next tick
/// begins anew; a cooldown around the timeout keeps it shut.
///   timeout: {after: 5 s, child: pursue}
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
///   cooldown: {duration: 20 s, child: break_turn}
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

struct DelayMemory {
  double since = 0;          ///< s, when it was first asked
  std::uint8_t waiting = 0;  ///< 1: `since` counts
  std::uint8_t open = 0;     ///< 1: the time is up and the child has its turn
  std::uint8_t reserved[6] = {};
};

/// Waits `duration` of simulated time, running and proposing nothing, then asks the child until it
/// has ended. The next time it waits again.
///   delay: {duration: 3 s, child: release_weapon}
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

struct RateLimitMemory {
  double began = 0;          ///< s, when the child last began
  std::uint8_t limited = 0;  ///< 1: `began` counts
  std::uint8_t running = 0;  ///< 1: the child was running in the last tick
  std::uint8_t reserved[6] = {};
};

/// Lets the child begin at most once per `period` of simulated time; a child that runs is asked in
/// every tick until it ends. Fails while it keeps the child from beginning. A child that fails
/// without having run did not begin. `cooldown` counts from the end, this from the beginning.
///   rate_limit: {period: 10 s, child: release_weapon}
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
