// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "ubf/composite.hpp"

namespace eyrie::ubf {

struct PriorityMemory {
  std::uint16_t held = 0;  ///< 1 + the child that may not be interrupted, 0 for none
};

/// Asks every child and hands on the proposal of the first one that is heard, however it votes: the
/// order in the file is the order of rank. A child that is not interruptible, once it is chosen and
/// running, keeps control over those before it until it succeeds, fails or abstains. Failing and
/// abstaining children are ignored; if that leaves none, it fails. Vote and status are those of the
/// chosen child. A selector differs in that it does not ask those behind the chosen child, and in
/// that it hears who does not vote.
template <class State, class Action>
class Priority final : public WithMemory<Voting<State, Action>, PriorityMemory> {
  using Base = WithMemory<Voting<State, Action>, PriorityMemory>;

 public:
  static constexpr std::string_view type_name = "priority";
  static constexpr std::string_view help = "the proposal of the first child that makes one";
  static constexpr Kind kind = Kind::arbiter;
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(
        std::tuple{param("interruptible", &Priority::interruptible,
                         "one per child: may those before it take over while it runs? none: all")},
        Voting<State, Action>::template vote_params<Priority>());
  }
  using Base::Base;

  std::vector<bool> interruptible;

  [[nodiscard]] bool stands() const noexcept override { return true; }
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept override {
    const auto& m = this->memory(slab);
    return m.held ? static_cast<NodeIndex>(m.held - 1) : kNone;
  }
  [[nodiscard]] std::string problem() const override {
    const std::size_t count = this->children_.size();
    if (!interruptible.empty() && interruptible.size() != count)
      return fmt::format("'interruptible' has {} items for {} children", interruptible.size(),
                         count);
    return Base::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    const NodeIndex held = active_child(t.memory);
    Status status = Status::failure;
    NodeIndex chosen = kNone;
    Scratch<Action> other;
    BestSoFar<Action> best(out, other);
    for (std::size_t i = 0; i < this->children_.size(); ++i) {
      const Status answer = this->ask(*this->children_[i], t, best.next());
      if (answer == Status::failure || best.next().vote == 0 || (chosen != kNone && i != held))
        continue;
      chosen = static_cast<NodeIndex>(i);
      status = answer;
      best.keep();
    }
    m = {};
    if (chosen == kNone)
      return Status::failure;
    best.hand_on();
    if (status == Status::running && !interruptible.empty() && !interruptible[chosen])
      m.held = static_cast<std::uint16_t>(chosen + 1);
    this->took(t, *this->children_[chosen]);
    this->rescale(out);
    return status;
  }
};

}  // namespace eyrie::ubf
