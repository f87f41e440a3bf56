// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// Asks every child and takes each field of the action from the highest vote that set it, the
/// earlier of equals. Failing and abstaining children are ignored; if that leaves none, it fails.
/// What goes up votes as the strongest child does and has that child's status.
template <class State, class Action>
class PerField final : public Voting<State, Action> {
 public:
  static constexpr std::string_view type_name = "per_field";
  static constexpr std::string_view help = "each field from the highest vote that set it";
  static constexpr Kind kind = Kind::arbiter;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<PerField>();
  }
  using Voting<State, Action>::Voting;

  [[nodiscard]] bool stands() const noexcept override { return true; }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    FieldMerge<Action> merge;
    StrongestChild strongest;
    Scratch<Action> scratch;
    Proposal<Action>& next = scratch.get();
    for (const auto& child : this->children_) {
      const Status answer = this->ask(*child, t, next);
      if (answer == Status::failure || next.vote == 0)
        continue;
      strongest.add(next, answer);
      merge.add(next, out.action);
    }
    out.vote = strongest.vote;
    out.leader = strongest.leader;
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_merge(*t.trace, *this, Heard::voters);
    return strongest.status;
  }
};

}  // namespace eyrie::ubf
