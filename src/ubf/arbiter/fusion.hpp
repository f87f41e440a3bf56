// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// Asks every child and blends their proposals field by field, weighted by their votes, in the way
/// the field's description says (ubf/blend.hpp): means on the line, means on the circle, orders by
/// the strongest vote, choices only if undisputed. Failing and abstaining children are ignored; if
/// that leaves none, it fails. Vote and status are those of the strongest child.
template <class State, class Action>
class Fusion final : public Blending<State, Action> {
 public:
  static constexpr std::string_view type_name = "fusion";
  static constexpr std::string_view help =
      "all proposals blended by vote: headings on the circle, orders from the strongest";
  static constexpr Kind kind = Kind::arbiter;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<Fusion>();
  }
  using Blending<State, Action>::Blending;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto by_vote = [](const auto&, float given) { return static_cast<double>(given); };
    return this->template blend<SumOf>(t, out, by_vote);
  }

 private:
  template <class Field>
  using SumOf = typename Field::Sum;
};

}  // namespace eyrie::ubf
