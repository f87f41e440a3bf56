// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

#include "core/enum_names.hpp"
#include "ubf/arbiter/strongest_few.hpp"
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// What becomes of a field on which the proposals differ.
enum class Conflicts : std::uint8_t { blend, drop };

}  // namespace eyrie::ubf

template <>
struct eyrie::EnumNames<eyrie::ubf::Conflicts> {
  using Conflicts = ubf::Conflicts;
  static constexpr std::array names{
      std::pair<std::string_view, Conflicts>{"blend", Conflicts::blend},
      std::pair<std::string_view, Conflicts>{"drop", Conflicts::drop}};
};

namespace eyrie::ubf {

/// Asks every child and blends their proposals field by field, weighted by their votes, in the way
/// the field's description says (ubf/blend.hpp): means on the line, means on the circle, orders by
/// the strongest vote, choices only if undisputed. Failing and abstaining children are ignored; if
/// that leaves none, it fails. Vote and status are those of the strongest child. With `top` only
/// that many of the strongest are blended, the earlier of equals; with `conflicts: drop` a field
/// goes up only if all who set it agree.
template <class State, class Action>
class Fusion final : public Blending<State, Action> {
 public:
  static constexpr std::string_view type_name = "fusion";
  static constexpr std::string_view help =
      "all proposals blended by vote: headings on the circle, orders from the strongest";
  static constexpr Kind kind = Kind::arbiter;
  static constexpr std::size_t kMaxTop = 8;
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(
        std::tuple{param("top", &Fusion::top, range(1, kMaxTop),
                         "blends only so many of the strongest proposals; null: all"),
                   param("conflicts", &Fusion::conflicts,
                         "fields on which proposals differ are blended or dropped")},
        Voting<State, Action>::template vote_params<Fusion>());
  }
  using Blending<State, Action>::Blending;

  std::optional<std::uint32_t> top;
  Conflicts conflicts = Conflicts::blend;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    if (top)
      return conflicts == Conflicts::drop ? blend_top<AgreedOf>(t, out) : blend_top<SumOf>(t, out);
    const auto by_vote = [](const auto&, float given) { return static_cast<double>(given); };
    return conflicts == Conflicts::drop ? this->template blend<AgreedOf>(t, out, by_vote)
                                        : this->template blend<SumOf>(t, out, by_vote);
  }

 private:
  template <class Field>
  using SumOf = typename Field::Sum;
  template <class Field>
  using AgreedOf = typename blend::Agreed::template Sum<typename Field::Value>;

  template <template <class> class Of>
  Status blend_top(const Tick<State>& t, Proposal<Action>& out) const {
    StrongestFew<Action, kMaxTop> few(*top);
    for (const auto& child : this->children_) {
      Proposal<Action>& next = few.spare();
      const Status answer = this->ask(*child, t, next);
      if (answer != Status::failure && next.vote > 0)
        few.add(child->index(), answer);
    }
    FieldSums<Action, Of> sums;
    StrongestChild strongest;
    for (std::size_t i = 0; i < few.size(); ++i) {
      const Proposal<Action>& proposal = few.proposal(i);
      strongest.add(proposal, few.status(i));
      sums.add(proposal.action, [&](const auto&) { return static_cast<double>(proposal.vote); });
    }
    sums.get(out.action);
    out.vote = strongest.vote;
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_blend(*t.trace, *this,
                  [&](NodeIndex child, const auto&) { return few.contains(child); });
    return strongest.status;
  }
};

}  // namespace eyrie::ubf
