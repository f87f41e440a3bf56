// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/arbiter/field_values.hpp"
#include "ubf/composite.hpp"
#include "ubf/expression.hpp"
#include "ubf/registry.hpp"

namespace eyrie::ubf {

/// Winner takes all among the proposals that keep to `bounds` and of which no condition of `refuse`
/// holds: the highest vote is checked, if it does not pass the next one is, and so on. With
/// `fallback` the last child is the fallback: its proposal is not checked, and goes up only if no
/// other one passes, or none was made. Vote and status are those of the child whose proposal goes
/// up. Children that fail or abstain are ignored, the fallback included; if that leaves none, it
/// fails. The switch to a simple and trusted controller when a better one leaves its bounds is the
/// idea of Sha, "Using Simplicity to Control Complexity" (IEEE Software, 2001).
///   verify: {bounds: {altitude: {min: 1000 ft}}, fallback: true, children: [pursue, navigate]}
template <class State, class Action>
class Verify final : public Arbiter<State, Action> {
 public:
  static constexpr std::string_view type_name = "verify";
  static constexpr std::string_view help =
      "the highest vote among the proposals that keep to bounds, or else a fallback";
  [[nodiscard]] static constexpr auto params() {
    return Verify::with_vote(
        param("bounds", &Verify::bounds, "a map from fields to 'min' and 'max'"),
        param("refuse", &Verify::refuse,
              "conditions in words on the state and, as action.altitude, the proposal; one "
              "that holds refuses it"),
        param("fallback", &Verify::fallback,
              "the last child goes up unchecked, but only if no other proposal passes"));
  }

  Bounds<Action> bounds;
  std::vector<std::string> refuse;
  bool fallback = false;

  [[nodiscard]] std::string problem() const override {
    if (fallback && this->children_.size() < 2)
      return "verify needs a child to check before the fallback";
    if (refuse.size() != refusals_.size())
      return "verify: 'refuse' is words of a file; in code, ask a Condition";
    return bounds.empty() && refusals_.empty() ? "verify needs 'bounds' or 'refuse' to check"
                                               : Arbiter<State, Action>::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    float highest = 0;
    const auto passes = [&](NodeIndex i, const Proposal<Action>& next, NodeIndex chosen) {
      const bool is_fallback = fallback && i + 1U == this->children_.size();
      if (is_fallback ? chosen != kNone : !(next.vote > highest))
        return false;
      if (const char* why = is_fallback ? nullptr : refused(t.state, next.action)) {
        if (t.trace) [[unlikely]]
          t.trace->because(this->children_[i]->index(), why);
        return false;
      }
      highest = next.vote;
      return true;
    };
    return this->hand_on(t, this->choose(t, out, passes), out);
  }

  /// From a file.
  void read(const NodeSpec& spec, NodeReader& reader) {
    using Refusal = ActionExpression<State, Action>;
    const Value* list = spec.body->find("refuse");
    if (!list)
      return;
    const std::span<const Value> texts = list->is_list() ? list->items : std::span(list, 1);
    for (const Value& text : texts) {
      refusals_.push_back(Refusal(reader.expression(text, Refusal::fields())));
      reasons_.push_back("refused: " + text.text);
    }
  }

 private:
  /// Why a proposal does not pass; null if it does.
  [[nodiscard]] const char* refused(const State& state, const Action& action) const {
    if (const char* why = bounds.broken_by(action))
      return why;
    for (std::size_t i = 0; i < refusals_.size(); ++i)
      if (refusals_[i].holds(state, action))
        return reasons_[i].c_str();
    return nullptr;
  }

  std::vector<ActionExpression<State, Action>> refusals_;
  std::vector<std::string> reasons_;  ///< of each
};

}  // namespace eyrie::ubf
