// SPDX-License-Identifier: MIT
#pragma once
/// \file  All children at once: until enough of them have ended, or all.
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// Which children of a parallel node have ended, and how.
struct ParallelMemory {
  std::uint64_t ended = 0;   ///< bit i: child i has ended
  std::uint64_t failed = 0;  ///< bit i: by failing

  [[nodiscard]] bool has_ended(std::size_t child) const { return ended >> child & 1; }
  [[nodiscard]] std::size_t successes() const {
    return static_cast<std::size_t>(std::popcount(ended & ~failed));
  }
  [[nodiscard]] std::size_t failures() const {
    return static_cast<std::size_t>(std::popcount(failed));
  }
};

/// The base of parallel and parallel_all.
template <class State, class Action>
class AtOnce : public WithMemory<Control<State, Action>, ParallelMemory> {
  using Base = WithMemory<Control<State, Action>, ParallelMemory>;

 public:
  std::uint32_t failure_count = 1;

  [[nodiscard]] std::string problem() const override {
    const std::size_t count = this->children_.size();
    if (count > this->kMostInABitSet)
      return this->too_many(this->type());
    return failure_count > count ? fewer_than("failure_count", failure_count) : Base::problem();
  }

 protected:
  [[nodiscard]] std::string fewer_than(std::string_view threshold, std::uint32_t value) const {
    const std::size_t count = this->children_.size();
    return fmt::format("{} is {}, but there {}", threshold, value,
                       count == 1 ? "is 1 child" : fmt::format("are {} children", count));
  }
  /// Asks the children that have not ended, and notes in `m` who ends now. What goes up is merged
  /// from them field by field, also of those without a vote, with the highest vote and its leader.
  /// `once`: who ended will not be asked again before the node starts anew.
  void ask_all(const Tick<State>& t, Proposal<Action>& out, ParallelMemory& m, bool once) const {
    FieldMerge<Action> merge;
    Scratch<Action> scratch;
    Proposal<Action>& next = scratch.get();
    for (std::size_t i = 0; i < this->children_.size(); ++i) {
      if (m.has_ended(i))
        continue;
      const auto& child = *this->children_[i];
      const Status answer = this->ask(child, t, next);
      if (answer != Status::failure) {
        merge.add(next, out.action);
        if (next.vote > out.vote || (out.leader == kNone && !next.is_empty()))
          out.leader = next.leader;
        out.vote = std::max(out.vote, next.vote);
      }
      m.ended |= std::uint64_t{answer != Status::running} << i;
      m.failed |= std::uint64_t{answer == Status::failure} << i;
      if (once && answer != Status::running)
        this->close(child, t);
    }
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_fields(*t.trace, *this, kEverybody, kMerged);
  }
};

/// Asks every child in every tick, with `once` until it has ended. Succeeds when at least
/// `success_count` of them answer success, else fails when at least `failure_count` answer failure,
/// or so many that success is out of reach, else is running: if both thresholds are reached in one
/// tick, success wins. When it ends, children that are still running forget. What goes up is merged
/// field by field, as per_field does, from all children that did not fail, those without a vote
/// included; a failing parallel proposes nothing. The paper's section II.A asks for more than the
/// threshold, we for at least, as Colledanchise and Ogren, Behavior Trees in Robotics and AI
/// (2018), algorithm 3; once: Parallel of BehaviorTree.CPP, synchronised policies of py_trees.
///   parallel: {success_count: 1, children: [navigate, release_weapon]}
template <class State, class Action>
class Parallel final : public AtOnce<State, Action> {
 public:
  static constexpr std::string_view type_name = "parallel";
  static constexpr std::string_view help = "all children at once, until enough succeed or fail";
  [[nodiscard]] static constexpr auto params() {
    return Parallel::with_vote(
        param("success_count", &Parallel::success_count,
              range(1, Control<State, Action>::kMostInABitSet),
              "this many successes make a success; null: all children"),
        param("failure_count", &Parallel::failure_count,
              range(1, Control<State, Action>::kMostInABitSet),
              "this many failures make a failure"),
        param("once", &Parallel::once, "a child that has ended is not asked again, but counts"));
  }

  std::optional<std::uint32_t> success_count;
  bool once = false;

  [[nodiscard]] std::size_t memory_bytes() const noexcept override {
    return once ? sizeof(ParallelMemory) : 0;
  }
  [[nodiscard]] std::string problem() const override {
    std::string wrong = AtOnce<State, Action>::problem();
    return wrong.empty() && success_count.value_or(0) > this->children_.size()
               ? this->fewer_than("success_count", *success_count)
               : wrong;
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    ParallelMemory now;
    ParallelMemory& m = once ? this->memory(t) : now;
    this->ask_all(t, out, m, once);
    const Status status = verdict(m.successes(), m.failures());
    if (status == Status::running)
      return status;
    for (std::size_t i = 0; i < this->children_.size(); ++i) {
      const auto& child = *this->children_[i];
      const bool ended = m.has_ended(i);
      // one that has ended once is closed already
      if (!(ended && once) && this->left_open(child, ended ? Status::success : Status::running))
        this->halt(child, t);
    }
    m = {};
    return status;
  }

 private:
  [[nodiscard]] Status verdict(std::size_t successes, std::size_t failures) const {
    const std::size_t enough = success_count.value_or(this->children_.size());
    if (successes >= enough)
      return Status::success;
    return failures >= this->failure_count || failures + enough > this->children_.size()
               ? Status::failure
               : Status::running;
  }
};

/// Asks every child until it has ended, each once through, and waits for the last of them: a child
/// that ended is not asked again before the node starts anew. Running until all have ended; then a
/// failure if at least `failure_count` failed, else a success. What goes up is merged as by
/// `parallel`, from the children that were asked in this tick and did not fail. No child is ever
/// cut short; a standing child that ended forgets.
///   parallel_all: [navigate, {delay: {duration: 5 s, child: release_weapon}}]
template <class State, class Action>
class ParallelAll final : public AtOnce<State, Action> {
 public:
  static constexpr std::string_view type_name = "parallel_all";
  static constexpr std::string_view help = "all children at once, until each of them has ended";
  [[nodiscard]] static constexpr auto params() {
    return ParallelAll::with_vote(param("failure_count", &ParallelAll::failure_count,
                                        range(1, Control<State, Action>::kMostInABitSet),
                                        "this many failures make a failure, when all have ended"));
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    this->ask_all(t, out, m, true);
    if (m.successes() + m.failures() < this->children_.size())
      return Status::running;
    const bool failed = m.failures() >= this->failure_count;
    m = {};
    return failed ? Status::failure : Status::success;
  }
};

}  // namespace eyrie::ubf
