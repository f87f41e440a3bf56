// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/composite.hpp"

namespace eyrie::ubf {

struct RandomSelectorMemory {
  std::uint64_t tried = 0;  ///< bit i: child i has failed since the node began
  ChildSlot child;          ///< the one that was left running
  std::uint8_t reserved[6] = {};
};

/// Draws a child, child i with the probability weight i / sum of the weights, and asks it; when it
/// fails, draws one of the rest in the same tick, until one does not fail or all have failed. A
/// running child is asked again without another draw. When the node has ended, nothing in it goes
/// on and all children are in the draw again. The draw is that of the step and of this node, so a
/// run can be repeated.
///   random_selector: {weights: [2, 1], children: [break_turn, pursue]}
template <class State, class Action>
class RandomSelector final : public WithMemory<Control<State, Action>, RandomSelectorMemory> {
  using Base = WithMemory<Control<State, Action>, RandomSelectorMemory>;

 public:
  static constexpr std::string_view type_name = "random_selector";
  static constexpr std::string_view help =
      "a child drawn by weight; when it fails, another one of the rest";
  [[nodiscard]] static constexpr auto params() {
    return RandomSelector::with_vote(param("weights", &RandomSelector::weights, positive(1e6),
                                           "one per child; none: all children alike"));
  }

  std::vector<double> weights;

  [[nodiscard]] std::string problem() const override {
    const std::size_t count = this->children_.size();
    if (count > this->kMostInABitSet)
      return this->too_many(type_name);
    if (!weights.empty() && weights.size() != count)
      return fmt::format("random_selector has {} weights for {} children", weights.size(), count);
    return Base::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    Draw draw = this->draw(t);
    for (;;) {
      const std::optional<std::size_t> drawn = m.child ? m.child.get() : pick(draw, m.tried);
      if (!drawn) {
        m = {};
        return Status::failure;
      }
      const auto& child = *this->children_[*drawn];
      const Status answer = this->ask(child, t, out);
      if (answer == Status::running) {
        m.child.set(*drawn);
        return this->hand_on(t, child, out, answer);
      }
      this->close(child, t);
      if (answer == Status::success) {
        m = {};
        return this->hand_on(t, child, out, answer);
      }
      m.tried |= std::uint64_t{1} << *drawn;
      m.child.clear();
    }
  }

 private:
  [[nodiscard]] double weight(std::size_t child) const {
    return weights.empty() ? 1 : weights[child];
  }
  /// One of the children that were not tried yet; null if there is none.
  [[nodiscard]] std::optional<std::size_t> pick(Draw& draw, std::uint64_t tried) const {
    double total = 0;
    for (std::size_t i = 0; i < this->children_.size(); ++i)
      total += tried >> i & 1 ? 0 : weight(i);
    if (!(total > 0))
      return std::nullopt;
    double rest = draw.uniform() * total;
    std::optional<std::size_t> last;  // stands if rounding leaves some of `rest` over
    for (std::size_t i = 0; i < this->children_.size(); ++i) {
      if (tried >> i & 1)
        continue;
      last = i;
      rest -= weight(i);
      if (rest < 0)
        break;
    }
    return last;
  }
};

}  // namespace eyrie::ubf
