// SPDX-License-Identifier: MIT
#pragma once
/// \file  A child's answer made another: turned over, repeated, kept; and a child behind a
/// condition.
#include "ubf/composite.hpp"

namespace eyrie::ubf {

/// What run_once answers when its child has ended.
enum class Afterwards : std::uint8_t { same, failure, success };
constexpr auto names_of(Afterwards) {
  return names_from_zero<Afterwards>("same", "failure", "success");
}

/// Success becomes failure and failure success. A failing child's proposal is ignored as
/// everywhere, so a success made of a failure proposes nothing.
///   inverter: has_target
template <class State, class Action>
class Inverter final : public Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "inverter";
  static constexpr std::string_view help = "success becomes failure and failure success";

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const Status answer = this->ask_child(t, out);
    if (answer == Status::running)
      return answer;
    out.clear();
    return answer == Status::success ? Status::failure : Status::success;
  }
};

/// The base of force_success and force_failure: what a child becomes that ended otherwise, and with
/// `running` also one that runs, which goes on in the next tick.
template <class State, class Action, Status forced>
class Forcing : public Decorator<State, Action> {
 public:
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("running", &Forcing::running, "also a child that runs")};
  }

  bool running = false;

  [[nodiscard]] bool stands() const noexcept final { return running || this->any_child_stands(); }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const final {
    const Status answer = this->ask_child(t, out);
    if (answer == Status::running && !running)
      return answer;
    if (answer == Status::failure)
      out.clear();
    return forced;
  }
};

/// Failure becomes success, with `running` also running: a sequence goes on behind a plain
/// behavior, which runs for ever; what it proposes goes up if nobody behind it proposes.
///   force_success: shoot_gun
template <class State, class Action>
class ForceSuccess final : public Forcing<State, Action, Status::success> {
 public:
  static constexpr std::string_view type_name = "force_success";
  static constexpr std::string_view help = "failure becomes success; running too, if asked for";
};

/// Success becomes failure, with `running` also running.
///   force_failure: shoot_gun
template <class State, class Action>
class ForceFailure final : public Forcing<State, Action, Status::failure> {
 public:
  static constexpr std::string_view type_name = "force_failure";
  static constexpr std::string_view help = "success becomes failure; running too, if asked for";
};

struct RepeatingMemory {
  std::uint32_t rounds = 0;  ///< how often the child ended as it should
};

/// The base of repeat and retry: a child that ended in one way begins anew in the next tick, at
/// most once per tick, so that a loop takes simulated time. A standing child that ended forgets.
template <class State, class Action>
class Repeating : public WithMemory<Decorator<State, Action>, RepeatingMemory> {
 public:
  [[nodiscard]] bool stands() const noexcept final { return false; }

 protected:
  /// Running until the child has answered `again` that often (null: for ever) or ended otherwise.
  Status loop(const Tick<State>& t, Proposal<Action>& out, Status again,
              std::optional<std::uint32_t> rounds) const {
    auto& m = this->memory(t);
    const Status answer = this->ask_to_its_end(t, out);
    if (answer == Status::running)
      return answer;
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
///   repeat: {count: 3, child: release_weapon}
template <class State, class Action>
class Repeat final : public Repeating<State, Action> {
 public:
  static constexpr std::string_view type_name = "repeat";
  static constexpr std::string_view help = "a child over and over, as long as it succeeds";
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("count", &Repeat::count, range(1, 1e9),
                       "this many successes make a success; null: repeats for ever")};
  }

  std::optional<std::uint32_t> count;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->loop(t, out, Status::success, count);
  }
};

/// Asks the child again after it failed, in the next tick, until it has failed `attempts` times;
/// running meanwhile, without a proposal in a tick in which it failed. Succeeds as soon as the
/// child does. Without a number it never fails.
///   retry: {attempts: 3, child: release_weapon}
template <class State, class Action>
class Retry final : public Repeating<State, Action> {
 public:
  static constexpr std::string_view type_name = "retry";
  static constexpr std::string_view help = "a child over and over, until it succeeds";
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("attempts", &Retry::attempts, range(1, 1e9),
                       "this many failures make a failure; null: tries for ever")};
  }

  std::optional<std::uint32_t> attempts;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->loop(t, out, Status::failure, attempts);
  }
};

struct RunOnceMemory {
  std::uint8_t ended = 0;  ///< 1 + the status with which the child ended, 0 before that
};

/// Asks the child until it has ended, success or failure, and then never again; from then on it
/// proposes nothing and answers what `then` says. It begins anew when a subtree around it loses
/// control and forgets.
///   run_once: {then: failure, child: navigate}
template <class State, class Action>
class RunOnce final : public WithMemory<Decorator<State, Action>, RunOnceMemory> {
 public:
  static constexpr std::string_view type_name = "run_once";
  static constexpr std::string_view help = "does not ask a child again that has ended";
  [[nodiscard]] static constexpr auto params() {
    return Lines{param("then", &RunOnce::then,
                       "what it answers from then on: what the child last did, or always that")};
  }

  Afterwards then = Afterwards::same;

  [[nodiscard]] bool stands() const noexcept override { return false; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (m.ended)
      return afterwards(static_cast<Status>(m.ended - 1));
    const Status answer = this->ask_to_its_end(t, out);
    if (answer != Status::running)
      m.ended = static_cast<std::uint8_t>(static_cast<std::uint8_t>(answer) + 1);
    return answer;
  }

 private:
  [[nodiscard]] Status afterwards(Status ended) const {
    if (then == Afterwards::same)
      return ended;
    return then == Afterwards::success ? Status::success : Status::failure;
  }
};

struct GuardMemory {
  std::uint8_t open = 0;  ///< 1: the child goes on since the last tick
};

/// Asks the child only while `when` succeeds, which is checked in every tick; otherwise it fails,
/// and a child that was going on forgets. What `when` proposes is ignored. A `when` that answers
/// running does not hold, and forgets.
///   guard: {when: range < 10 nmi, child: pursue}
template <class State, class Action>
class Guard final : public WithMemory<Composite<State, Action>, GuardMemory> {
 public:
  static constexpr std::string_view type_name = "guard";
  static constexpr std::string_view help = "asks its child only while a condition holds";
  static constexpr Kind kind = Kind::decorator;
  static constexpr std::array<std::string_view, 2> slots{"when", "child"};

  [[nodiscard]] bool remembers() const noexcept override { return false; }
  [[nodiscard]] bool stands() const noexcept override { return this->any_child_stands(); }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto &when = *this->children_[0], &child = *this->children_[1];
    auto& m = this->memory(t);
    const Status holds = this->ask(when, t, out);
    if (holds == Status::success) {
      const Status answer = this->ask(child, t, out);
      this->took(t, child);
      m.open = this->left_open(child, answer);
      return answer;
    }
    if (holds == Status::running)
      this->halt(when, t);
    if (m.open)
      this->halt(child, t);
    m.open = 0;
    return Status::failure;
  }
};

}  // namespace eyrie::ubf
