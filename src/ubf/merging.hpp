// SPDX-License-Identifier: MIT
#pragma once
/// \file  Making one action of several: what the arbiters per_field, fusion and paper_fusion and
/// the control node parallel share.
#include "ubf/composite.hpp"

namespace eyrie::ubf {

/// The highest vote, its child's status and leader, the earlier of equals: what an arbiter that
/// mixes its children answers, so that exchanging one arbiter for another does not change the
/// statuses.
struct StrongestChild {
  float vote = 0;
  Status status = Status::failure;
  NodeIndex leader = kNone;

  template <class Action>
  void add(const Proposal<Action>& proposal, Status answer) {
    if (!(proposal.vote > vote))
      return;
    vote = proposal.vote;
    status = answer;
    leader = proposal.leader;
  }
};

/// Builds an action field by field, each from the highest vote that set it, the earlier of equals.
template <class Action>
class FieldMerge {
 public:
  /// A vote of 0 counts here: who wants abstaining children unheard does not add them.
  void add(const Proposal<Action>& proposal, Action& into) {
    for_each_field<Action>([&](const auto& f, auto i) {
      if (!(proposal.action.*f.member) || !(proposal.vote > votes_[i]))
        return;
      into.*f.member = *(proposal.action.*f.member);
      votes_[i] = proposal.vote;
    });
  }

 private:
  static constexpr std::array<float, kFields<Action>> nobody() {
    std::array<float, kFields<Action>> votes{};
    votes.fill(-1);
    return votes;
  }
  std::array<float, kFields<Action>> votes_ = nobody();
};

/// One sum per field of an action, each of type `SumOf<Field>`.
template <class Action, template <class> class SumOf>
class FieldSums {
 public:
  /// Adds the fields that are set, each with the weight `weigh(field)`; 0 leaves it out.
  template <class Weigh>
  void add(const Action& action, Weigh weigh) {
    for_each_field<Action>([&](const auto& f, auto i) {
      const auto& value = action.*f.member;
      const double weight = value ? weigh(f) : 0;
      if (weight > 0)
        std::get<i>(sums_).add(*value, weight);
    });
  }
  void get(Action& action) const {
    for_each_field<Action>([&]<class Field>(const Field& f, auto i) {
      action.*f.member = std::get<i>(sums_).get();
      if constexpr (Field::is_direction)
        if (action.*f.member)
          action.*f.member = f.as_counted(*(action.*f.member));
    });
  }

 private:
  template <class... Field>
  static std::tuple<SumOf<Field>...> sums_of(const Lines<Field...>&);
  decltype(sums_of(kFieldLines<Action>)) sums_;
};

/// Tells the trace which child each field of `node` came from: the strongest that set it, of those
/// that `is_heard(child, proposal)`; but for the fields that the node made itself, of which
/// `is_taken(field, i, setters)` is not true.
template <class State, class Action, class IsHeard, class IsTaken>
[[gnu::noinline, gnu::cold]] void trace_fields(AnyTrace& any, const Behavior<State, Action>& node,
                                               IsHeard is_heard, IsTaken is_taken) {
  auto& trace = Trace<Action>::of(any);
  for_each_field<Action>([&](const auto& f, auto i) {
    NodeIndex strongest = kNone;
    std::size_t setters = 0;
    for (const auto& child : node.children()) {
      const Proposal<Action>& proposal = trace.row(child->index()).proposal;
      if (!(proposal.action.*f.member) || !is_heard(child->index(), proposal))
        continue;
      ++setters;
      if (strongest == kNone || proposal.vote > trace.row(strongest).proposal.vote)
        strongest = child->index();
    }
    if (setters > 0 && is_taken(f, std::size_t{i}, setters))
      trace.took(node.index(), strongest, i);
  });
}
/// Whose proposals a node listens to: those that vote; or also those that propose an action without
/// a vote, as plain behavior trees do.
inline constexpr auto kVoters = [](NodeIndex, const auto& proposal) { return proposal.vote > 0; };
inline constexpr auto kEverybody = [](NodeIndex, const auto&) { return true; };
/// A merged field is one child's; a blended one only if no other set it, or it is an order.
inline constexpr auto kMerged = [](const auto&, std::size_t, std::size_t) { return true; };
inline constexpr auto kBlended = [](const auto& f, std::size_t, std::size_t setters) {
  return setters == 1 || !f.averages;
};

/// The base of arbiters that mix the proposals of all children.
template <class State, class Action>
class Mixing : public Arbiter<State, Action> {
 protected:
  /// Asks every child into `next`; `use(child, next)` those that neither fail nor abstain. If it
  /// answers false, the child has failed after all.
  template <class Use>
  StrongestChild ask_voters(const Tick<State>& t, Proposal<Action>& next, Use use) const {
    StrongestChild strongest;
    for (const auto& child : this->children_) {
      const Status answer = this->ask(*child, t, next);
      if (answer == Status::failure || next.vote == 0)
        continue;
      if constexpr (std::is_same_v<decltype(use(*child, next)), bool>) {
        if (!use(*child, next))
          continue;
      } else {
        use(*child, next);
      }
      strongest.add(next, answer);
    }
    return strongest;
  }
};

/// The base of arbiters that blend all proposals field by field.
template <class State, class Action>
class Blending : public Mixing<State, Action> {
 protected:
  /// Asks every child. A field of a child that voted v has the weight `weigh(field, v)`.
  template <template <class> class SumOf, class Weigh>
  Status blend(const Tick<State>& t, Proposal<Action>& out, Weigh weigh) const {
    FieldSums<Action, SumOf> sums;
    const StrongestChild strongest =
        this->ask_voters(t, out, [&](const auto&, const Proposal<Action>& next) {
          sums.add(next.action, [&](const auto& f) { return weigh(f, next.vote); });
        });
    sums.get(out.action);
    out.vote = strongest.vote;
    out.leader = kNone;  // the blend is nobody's but this node's
    this->rescale(out);
    if (t.trace) [[unlikely]]
      trace_fields(*t.trace, *this, kVoters, kBlended);
    return strongest.status;
  }
};

}  // namespace eyrie::ubf
