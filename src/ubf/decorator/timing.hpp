// SPDX-License-Identifier: MIT
#pragma once
/// \file  A child kept within simulated time: how long, how soon again, when first, how often.
#include "ubf/composite.hpp"

namespace eyrie::ubf {

/// What a child within time remembers.
struct TimingMemory {
  double since = 0;          ///< s, when it began, ended or was first asked
  std::uint8_t counts = 0;   ///< 1: `since` counts
  std::uint8_t running = 0;  ///< 1: the child was asked in the last tick and goes on
  std::uint8_t reserved[6] = {};
};

/// The base of the nodes that keep a child within simulated time.
template <class State, class Action>
class Timing : public WithMemory<Decorator<State, Action>, TimingMemory> {
 protected:
  /// Whether so much time (s) has passed since `since`.
  [[nodiscard]] bool is_over(const Tick<State>& t, double duration) const {
    return passed(t.time, this->memory(t).since, duration);
  }
};

/// Gives the child `after` seconds of simulated time from the tick in which it began to run. In the
/// first tick at or past that the child is not asked: it forgets, and the node fails. The next tick
/// begins anew; a cooldown around the timeout keeps it shut.
///   timeout: {after: 5 s, child: pursue}
template <class State, class Action>
class Timeout final : public Timing<State, Action> {
 public:
  static constexpr std::string_view type_name = "timeout";
  static constexpr std::string_view help = "fails and halts a child that runs for too long";
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("after", &Timeout::after, "s", positive(1e6), "how long the child may run")
                     .required()};
  }

  double after = 0;  ///< s

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (m.counts && this->is_over(t, after)) {
      this->halt(this->child(), t);
      m = {};
      return this->fails(t, "its time is up");
    }
    const double begun = m.counts ? m.since : t.time;
    const Status answer = this->ask_child(t, out);
    m = {};
    if (answer == Status::running)
      m = {.since = begun, .counts = 1};
    return answer;
  }
};

/// After the child has ended, that is succeeded, or failed after running, it is not asked for
/// `duration` seconds of simulated time; the node fails meanwhile. A child that fails without ever
/// having run was not applicable and starts nothing. A cooldown that is halted while its child runs
/// forgets; one that is cooling was left by nobody and goes on cooling.
///   cooldown: {duration: 20 s, child: break_turn}
template <class State, class Action>
class Cooldown final : public Timing<State, Action> {
 public:
  static constexpr std::string_view type_name = "cooldown";
  static constexpr std::string_view help = "keeps a child that has ended from starting again";
  [[nodiscard]] static constexpr auto params() {
    return Lines{
        param("duration", &Cooldown::duration, "s", positive(1e6), "how long it stays shut")
            .required()};
  }

  double duration = 0;  ///< s

  [[nodiscard]] bool stands() const noexcept override { return false; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (m.counts && !this->is_over(t, duration))
      return this->fails(t, "it ended too recently");
    const Status answer = this->ask_to_its_end(t, out);
    const bool ended = answer == Status::success || (answer == Status::failure && m.running);
    m = {};
    m.running = answer == Status::running;
    if (ended)
      m = {.since = t.time, .counts = 1};
    return answer;
  }
};

/// Waits `duration` of simulated time, running and proposing nothing, then asks the child until it
/// has ended. The next time it waits again.
///   delay: {duration: 3 s, child: release_weapon}
template <class State, class Action>
class Delay final : public Timing<State, Action> {
 public:
  static constexpr std::string_view type_name = "delay";
  static constexpr std::string_view help = "waits before it asks its child";
  [[nodiscard]] static constexpr auto params() {
    return Lines{
        param("duration", &Delay::duration, "s", positive(1e6), "how long it waits").required()};
  }

  double duration = 0;  ///< s

  [[nodiscard]] bool stands() const noexcept override { return false; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (!m.counts)
      m = {.since = t.time, .counts = 1};
    if (!m.running && !this->is_over(t, duration))
      return Status::running;
    m.running = 1;
    const Status answer = this->ask_to_its_end(t, out);
    if (answer != Status::running)
      m = {};
    return answer;
  }
};

/// Lets the child begin at most once per `period` of simulated time; a child that runs is asked in
/// every tick until it ends. Fails while it keeps the child from beginning. A child that fails
/// without having run did not begin. `cooldown` counts from the end, this from the beginning.
///   rate_limit: {period: 10 s, child: release_weapon}
template <class State, class Action>
class RateLimit final : public Timing<State, Action> {
 public:
  static constexpr std::string_view type_name = "rate_limit";
  static constexpr std::string_view help = "keeps a child from beginning too often";
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("period", &RateLimit::period, "s", positive(1e6),
                       "least time from one beginning to the next")
                     .required()};
  }

  double period = 0;  ///< s

  [[nodiscard]] bool stands() const noexcept override { return false; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (!m.running && m.counts && !this->is_over(t, period))
      return this->fails(t, "it began too recently");
    const Status answer = this->ask_to_its_end(t, out);
    if (!m.running && answer != Status::failure)
      m = {.since = t.time, .counts = 1};
    m.running = answer == Status::running;
    return answer;
  }
};

}  // namespace eyrie::ubf
