// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/composite.hpp"

namespace eyrie::ubf {

struct WeightedRandomMemory {
  double since = 0;  ///< s, when the child was drawn
  ChildSlot child;
  std::uint8_t reserved[6] = {};
};

/// Asks every child and hands on the proposal of one that is drawn with the probability vote / sum
/// of the votes, with its vote and status. What was drawn stands for `keep`; a chosen child that
/// fails, abstains or succeeds is drawn for anew. Failing and abstaining children are not in the
/// draw; if that leaves none, it fails. The draw is that of the step and of this node, so a run can
/// be repeated. One pass suffices: child i replaces the one held so far with the probability
/// vote_i / (vote_0 + ... + vote_i), as in Chao, "A General Purpose Unequal Probability Sampling
/// Plan" (Biometrika, 1982).
///   weighted_random: {keep: 20 s, children: [pursue, navigate]}
template <class State, class Action>
class WeightedRandom final : public WithMemory<Arbiter<State, Action>, WeightedRandomMemory> {
 public:
  static constexpr std::string_view type_name = "weighted_random";
  static constexpr std::string_view help =
      "a proposal drawn at random, the more likely the higher its vote";
  static constexpr std::string_view decided_by = "chance";
  [[nodiscard]] static constexpr auto params() {
    return WeightedRandom::with_vote(param("keep", &WeightedRandom::keep, "s", range(0, 1e6),
                                           "how long a draw stands; 0: draws in every tick"));
  }

  double keep = 0;  ///< s

  [[nodiscard]] bool remembers() const noexcept override { return keep > 0; }
  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    const NodeIndex kept = passed(t.time, m.since, keep) ? kNone : m.child.get();
    Draw draw = this->draw(t);
    double total = 0;
    const auto chosen =
        this->choose(t, out, [&](NodeIndex i, const Proposal<Action>& next, NodeIndex held) {
          const auto weight = static_cast<double>(next.vote);
          total += weight;
          const bool drawn = draw.uniform() * total < weight || held == kNone;
          return i == kept || (drawn && (held == kNone || held != kept));
        });
    const double since = chosen.child == kept ? m.since : t.time;
    m = {};
    if (keep > 0 && chosen.status == Status::running) {
      m.since = since;
      m.child.set(chosen.child);
    }
    return this->hand_on(t, chosen, out);
  }
};

}  // namespace eyrie::ubf
