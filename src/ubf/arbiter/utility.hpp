// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/arbiter/vote_grid.hpp"

namespace eyrie::ubf {

/// Behaviors state the utility of outcomes, and the command with the highest expectation goes up.
/// Outcomes are the points of a grid; what comes of a command is distributed around it as each
/// axis' `spread` says (normal, within the grid; on a circle around it). The utility of an outcome
/// is the sum over the children, weighted with their votes: an Appraiser states it, for a behavior
/// that proposes one command it is 1 there and falls to -1 at `reach`. Other fields, vote and
/// status as in vote_grid. Rosenblatt, "Optimal Selection of Uncertain Actions by Maximizing
/// Expected Utility" (Autonomous Robots, 2000).
template <class State, class Action>
class Utility final : public OverGrid<State, Action> {
  using Base = OverGrid<State, Action>;

 public:
  static constexpr std::string_view type_name = "utility";
  static constexpr std::string_view help = "the command with the highest expected utility";
  static constexpr Kind kind = Kind::arbiter;
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(
        std::tuple{
            param("grid", &Utility::grid, "the outcomes: a map from fields to axes").required()},
        Voting<State, Action>::template vote_params<Utility>());
  }
  using Base::Base;

  [[nodiscard]] std::string problem() const override { return this->grid_problem(); }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    typename Base::Sums utility, expected;
    const auto opinion = this->add_up(t, out, utility);
    if (opinion.any)
      expect(utility, expected);
    return this->propose(t, out, opinion, utility);
  }

 private:
  /// Turns utilities of outcomes into expectations of commands, axis by axis. Outcomes beyond an
  /// end of an axis fall on its end.
  void expect(typename Base::Sums& utility, typename Base::Sums& scratch) const {
    std::size_t stride = 1;
    for (const auto& axis : this->grid.axes()) {
      const auto reach = static_cast<std::ptrdiff_t>(axis.spread.size()) - 1;
      if (reach > 0) {
        const auto steps = static_cast<std::ptrdiff_t>(axis.steps);
        for (std::size_t i = 0; i < this->grid.size(); ++i) {
          const auto at = static_cast<std::ptrdiff_t>(i / stride % axis.steps);
          double sum = 0;
          for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
            const std::ptrdiff_t to = axis.is_circle
                                          ? (at + k + steps) % steps
                                          : std::clamp(at + k, std::ptrdiff_t{0}, steps - 1);
            sum += axis.spread[static_cast<std::size_t>(k < 0 ? -k : k)] *
                   utility[i + static_cast<std::size_t>(to - at) * stride];
          }
          scratch[i] = sum;
        }
        std::copy_n(scratch.begin(), this->grid.size(), utility.begin());
      }
      stride *= axis.steps;
    }
  }
};

}  // namespace eyrie::ubf
