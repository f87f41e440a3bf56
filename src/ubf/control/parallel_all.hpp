// SPDX-License-Identifier: MIT
#pragma once
#include <bit>

#include "ubf/merging.hpp"

namespace eyrie::ubf {

struct ParallelAllMemory {
  std::uint64_t ended = 0;   ///< bit i: child i has ended
  std::uint64_t failed = 0;  ///< bit i: by failing
};

/// Asks every child until it has ended, each once through, and waits for the last of them: a child
/// that ended is not asked again before the node starts anew. Running until all have ended; then a
/// failure if at least `failure_count` failed, else a success. What goes up is merged as by
/// `parallel`, from the children that were asked in this tick and did not fail. No child is ever
/// cut short; a standing child that ended forgets.
template <class State, class Action>
class ParallelAll final : public WithMemory<Voting<State, Action>, ParallelAllMemory> {
  using Base = WithMemory<Voting<State, Action>, ParallelAllMemory>;

 public:
  static constexpr std::string_view type_name = "parallel_all";
  static constexpr std::string_view help = "all children at once, until each of them has ended";
  static constexpr Kind kind = Kind::control;
  static constexpr std::size_t kMaxChildren = 64;
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(
        std::tuple{param("failure_count", &ParallelAll::failure_count, range(1, kMaxChildren),
                         "this many failures make a failure, when all have ended")},
        Voting<State, Action>::template vote_params<ParallelAll>());
  }
  using Base::Base;

  std::uint32_t failure_count = 1;

  [[nodiscard]] std::string problem() const override {
    const std::size_t count = this->children_.size();
    if (count > kMaxChildren)
      return fmt::format("parallel_all takes at most {} children, here are {}", kMaxChildren,
                         count);
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
      trace_merge(*t.trace, *this, Heard::all);
    if (running)
      return Status::running;
    const bool failed = static_cast<std::uint32_t>(std::popcount(m.failed)) >= failure_count;
    m = {};
    return failed ? Status::failure : Status::success;
  }
};

}  // namespace eyrie::ubf
