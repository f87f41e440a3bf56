// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// Asks every child and takes each field of the action from the highest vote that set it, the
/// earlier of equals. Failing and abstaining children are ignored; if that leaves none, it fails.
/// What goes up votes as the strongest child does and has that child's status.
template <class State, class Action>
class PerField final : public Mixing<State, Action> {
 public:
  static constexpr std::string_view type_name = "per_field";
  static constexpr std::string_view help = "each field from the highest vote that set it";
  static constexpr Kind kind = Kind::arbiter;
  [[nodiscard]] static constexpr auto params() {
    return Mixing<State, Action>::template vote_params<PerField>();
  }
  using Mixing<State, Action>::Mixing;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    FieldMerge<Action> merge;
    Scratch<Action> scratch;
    const StrongestChild strongest = this->ask_voters(
        t, scratch.get(),
        [&](const auto&, const Proposal<Action>& next) { merge.add(next, out.action); });
    out.vote = strongest.vote;
    out.leader = strongest.leader;
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_merge(*t.trace, *this, Heard::voters);
    return strongest.status;
  }
};

}  // namespace eyrie::ubf
