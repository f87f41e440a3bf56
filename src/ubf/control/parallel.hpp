// SPDX-License-Identifier: MIT
#pragma once
/// \file  All children at once: until enough of them have ended, or all.
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// Asks every child in every tick. Succeeds when at least `success_count` of them answer success,
/// else fails when at least `failure_count` answer failure, or so many that success is out of
/// reach, else is running: if both thresholds are reached in one tick, success wins. When it ends,
/// children that are still running forget. What goes up is merged field by field, as per_field
/// does, from all children that did not fail, those without a vote included; a failing parallel
/// proposes nothing. The paper's section II.A asks for more than the threshold, we for at least, as
/// Colledanchise and Ogren, Behavior Trees in Robotics and AI (2018), algorithm 3.
///   parallel: {success_count: 1, children: [navigate, release_weapon]}
template <class State, class Action>
class Parallel final : public Control<State, Action> {
 public:
  static constexpr std::string_view type_name = "parallel";
  static constexpr std::string_view help = "all children at once, until enough succeed or fail";
  [[nodiscard]] static constexpr auto params() {
    return Parallel::with_vote(param("success_count", &Parallel::success_count,
                                     range(1, Control<State, Action>::kMostInABitSet),
                                     "this many successes make a success; null: all children"),
                               param("failure_count", &Parallel::failure_count,
                                     range(1, Control<State, Action>::kMostInABitSet),
                                     "this many failures make a failure"));
  }
  using Control<State, Action>::Control;

  std::optional<std::uint32_t> success_count;
  std::uint32_t failure_count = 1;

  [[nodiscard]] std::string problem() const override {
    const std::size_t count = this->children_.size();
    if (count > this->kMostInABitSet)
      return this->too_many(type_name);
    if (success_count && *success_count > count)
      return fmt::format("success_count is {}, but there {}", *success_count, are(count));
    if (failure_count > count)
      return fmt::format("failure_count is {}, but there {}", failure_count, are(count));
    return Control<State, Action>::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    GatherAll<Action> gather;
    Scratch<Action> scratch;
    Proposal<Action>& next = scratch.get();
    std::uint64_t running = 0;
    std::size_t successes = 0, failures = 0;
    for (std::size_t i = 0; i < this->children_.size(); ++i) {
      const Status answer = this->ask(*this->children_[i], t, next);
      running |= std::uint64_t{answer == Status::running} << i;
      successes += answer == Status::success;
      failures += answer == Status::failure;
      if (answer != Status::failure)
        gather.add(next, out);
    }
    const Status status = verdict(successes, failures);
    if (status != Status::running)
      end(t, running);
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_fields(*t.trace, *this, kEverybody, kMerged);
    return status;
  }

 private:
  [[nodiscard]] static std::string are(std::size_t count) {
    return count == 1 ? "is 1 child" : fmt::format("are {} children", count);
  }
  [[nodiscard]] Status verdict(std::size_t successes, std::size_t failures) const {
    const std::size_t enough = success_count.value_or(this->children_.size());
    if (successes >= enough)
      return Status::success;
    return failures >= failure_count || failures + enough > this->children_.size()
               ? Status::failure
               : Status::running;
  }
  void end(const Tick<State>& t, std::uint64_t running) const {
    for (std::size_t i = 0; i < this->children_.size(); ++i) {
      const Status answer = running >> i & 1 ? Status::running : Status::success;
      if (this->left_open(*this->children_[i], answer))
        this->halt(*this->children_[i], t);
    }
  }
};

struct ParallelAllMemory {
  std::uint64_t ended = 0;   ///< bit i: child i has ended
  std::uint64_t failed = 0;  ///< bit i: by failing
};

/// Asks every child until it has ended, each once through, and waits for the last of them: a child
/// that ended is not asked again before the node starts anew. Running until all have ended; then a
/// failure if at least `failure_count` failed, else a success. What goes up is merged as by
/// `parallel`, from the children that were asked in this tick and did not fail. No child is ever
/// cut short; a standing child that ended forgets.
///   parallel_all: [navigate, {delay: {duration: 5 s, child: release_weapon}}]
template <class State, class Action>
class ParallelAll final : public WithMemory<Control<State, Action>, ParallelAllMemory> {
  using Base = WithMemory<Control<State, Action>, ParallelAllMemory>;

 public:
  static constexpr std::string_view type_name = "parallel_all";
  static constexpr std::string_view help = "all children at once, until each of them has ended";
  [[nodiscard]] static constexpr auto params() {
    return ParallelAll::with_vote(param("failure_count", &ParallelAll::failure_count,
                                        range(1, Control<State, Action>::kMostInABitSet),
                                        "this many failures make a failure, when all have ended"));
  }
  using Base::Base;

  std::uint32_t failure_count = 1;

  [[nodiscard]] std::string problem() const override {
    const std::size_t count = this->children_.size();
    if (count > this->kMostInABitSet)
      return this->too_many(type_name);
    if (failure_count > count)
      return fmt::format("failure_count is {}, but the number of children is {}", failure_count,
                         count);
    return Base::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    GatherAll<Action> gather;
    Scratch<Action> scratch;
    Proposal<Action>& next = scratch.get();
    bool running = false;
    for (std::size_t i = 0; i < this->children_.size(); ++i) {
      if (m.ended >> i & 1)
        continue;
      const auto& child = *this->children_[i];
      const Status answer = this->ask(child, t, next);
      if (answer != Status::failure)
        gather.add(next, out);
      if (answer == Status::running) {
        running = true;
        continue;
      }
      m.ended |= std::uint64_t{1} << i;
      m.failed |= std::uint64_t{answer == Status::failure} << i;
      this->close(child, t);
    }
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_fields(*t.trace, *this, kEverybody, kMerged);
    if (running)
      return Status::running;
    const bool failed = static_cast<std::uint32_t>(std::popcount(m.failed)) >= failure_count;
    m = {};
    return failed ? Status::failure : Status::success;
  }
};

}  // namespace eyrie::ubf
