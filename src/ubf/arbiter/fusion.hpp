// SPDX-License-Identifier: MIT
#pragma once
/// \file  One action of several: each field from the strongest, or blended, or as in the paper.
#include "ubf/merging.hpp"

namespace eyrie::ubf {

/// What becomes of a field on which the proposals differ.
enum class Conflicts : std::uint8_t { blend, drop };
constexpr auto names_of(Conflicts) {
  return names_from_zero<Conflicts>("blend", "drop");
}

/// Asks every child and takes each field of the action from the highest vote that set it, the
/// earlier of equals. Failing and abstaining children are ignored; if that leaves none, it fails.
/// What goes up votes as the strongest child does and has that child's status.
///   per_field: [release_weapon, pursue]
template <class State, class Action>
class PerField final : public Mixing<State, Action> {
 public:
  static constexpr std::string_view type_name = "per_field";
  static constexpr std::string_view help = "each field from the highest vote that set it";

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
      trace_fields(*t.trace, *this, kVoters, kMerged);
    return strongest.status;
  }
};

/// The few strongest of many proposals, in the order in which they came; of equal votes the
/// earlier. On the stack, for one tick.
template <class Action, std::size_t Most>
class StrongestFew {
 public:
  /// At most `few` of them, which is at least 1 and at most Most.
  explicit StrongestFew(std::size_t few) : few_(few) {}
  StrongestFew(const StrongestFew&) = delete;
  StrongestFew& operator=(const StrongestFew&) = delete;

  /// Where the next proposal goes, before add() says that it counts.
  [[nodiscard]] Proposal<Action>& spare() { return kept_[size_].scratch->get(); }
  /// Keeps the proposal in spare() unless there are enough that are at least as strong.
  void add(NodeIndex child, Status status) {
    kept_[size_].child = child;
    kept_[size_].status = status;
    if (size_ < few_) {
      ++size_;
      return;
    }
    // the weakest goes, the latest of equals, and its place is the spare one from now on
    std::size_t weakest = size_;
    for (std::size_t i = size_; i-- > 0;)
      if (proposal(i).vote < proposal(weakest).vote)
        weakest = i;
    const Kept gone = kept_[weakest];
    for (std::size_t i = weakest; i < size_; ++i)
      kept_[i] = kept_[i + 1];
    kept_[size_] = gone;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Proposal<Action>& proposal(std::size_t i) const {
    return kept_[i].scratch->get();
  }
  [[nodiscard]] Status status(std::size_t i) const { return kept_[i].status; }
  [[nodiscard]] bool contains(NodeIndex child) const {
    for (std::size_t i = 0; i < size_; ++i)
      if (kept_[i].child == child)
        return true;
    return false;
  }

 private:
  struct Kept {
    Scratch<Action>* scratch = nullptr;
    NodeIndex child = kNone;
    Status status = Status::failure;
  };
  [[nodiscard]] std::array<Kept, Most + 1> places() {
    std::array<Kept, Most + 1> all;
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].scratch = &scratch_[i];
    return all;
  }

  std::array<Scratch<Action>, Most + 1> scratch_;
  std::array<Kept, Most + 1> kept_ = places();  ///< those behind the first size_ are spare
  std::size_t few_, size_ = 0;
};

/// Asks every child and blends their proposals field by field, weighted by their votes, in the way
/// the field's description says (ubf/blend.hpp): means on the line, means on the circle, orders by
/// the strongest vote, choices only if undisputed. Failing and abstaining children are ignored; if
/// that leaves none, it fails. Vote and status are those of the strongest child. With `top` only
/// that many of the strongest are blended, the earlier of equals; with `conflicts: drop` a field
/// goes up only if all who set it agree.
///   fusion: {top: 2, conflicts: drop, children: [pursue, follow_lead, navigate]}
template <class State, class Action>
class Fusion final : public Blending<State, Action> {
 public:
  static constexpr std::string_view type_name = "fusion";
  static constexpr std::string_view help =
      "all proposals blended by vote: headings on the circle, orders from the strongest";
  static constexpr std::size_t kMaxTop = 8;
  [[nodiscard]] static constexpr auto params() {
    return Fusion::with_vote(param("top", &Fusion::top, range(1, kMaxTop),
                                   "blends only so many of the strongest proposals; null: all"),
                             param("conflicts", &Fusion::conflicts,
                                   "fields on which proposals differ are blended or dropped"));
  }

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
      trace_few(*t.trace, few);
    return strongest.status;
  }

  [[gnu::noinline, gnu::cold]] void trace_few(AnyTrace& trace,
                                              const StrongestFew<Action, kMaxTop>& few) const {
    const auto is_heard = [&](NodeIndex child, const auto&) { return few.contains(child); };
    for (const auto& child : this->children_)
      if (const auto& row = Trace<Action>::of(trace).row(child->index());
          row.status != Status::failure && row.proposal.vote > 0 && !few.contains(child->index()))
        trace.because(child->index(), "not among the strongest");
    trace_fields(trace, *this, is_heard, kBlended);
  }
};

/// The fusion arbiter of Roberson et al., "The Unified Behavior Framework for the Simulation of
/// Autonomous Agents" (CSC'15), section III.C.2: every quantity (altitude, velocity, heading) is
/// the plain average of all proposals, whatever their votes, and an order (release) goes up if a
/// highly voted proposal gives it, a flag also if a stronger one says no. A heading is averaged as
/// the plain number it is, so 350 and 10 degrees make 180; `fusion` is the arbiter that knows the
/// circle. How high a vote must be is not in the paper and so must be given. Failing and abstaining
/// children make no proposal; if none is left, it fails. Vote and status are those of the strongest
/// child.
///   paper_fusion: {high_vote: 50, children: [release_weapon, pursue]}
template <class State, class Action>
class PaperFusion final : public Blending<State, Action> {
 public:
  static constexpr std::string_view type_name = "paper_fusion";
  static constexpr std::string_view help =
      "as in the paper: plain averages, and orders that a highly voted proposal gives";
  [[nodiscard]] static constexpr auto params() {
    return PaperFusion::with_vote(param("high_vote", &PaperFusion::high_vote, range(0, 1000),
                                        "least vote of a proposal whose orders are taken")
                                      .required());
  }

  float high_vote = 0;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto as_in_the_paper = [this]<class Field>(const Field&, float given) -> double {
      if (Field::averages)
        return 1;
      return kIsOrder<Field> && given < high_vote ? 0 : static_cast<double>(given);
    };
    return this->template blend<SumOf>(t, out, as_in_the_paper);
  }

 private:
  template <class Field>
  static constexpr bool kIsOrder = std::is_same_v<typename Field::BlendTag, blend::Strongest>;
  /// "Release" goes up if anybody who is heard says so.
  class AnyYes {
   public:
    void add(bool value, double) { value_ = value || value_.value_or(false); }
    [[nodiscard]] std::optional<bool> get() const { return value_; }

   private:
    std::optional<bool> value_;
  };
  template <class Field>
  struct Plain {
    using type = typename Field::Sum;
  };
  template <class Field>
  requires Field::averages struct Plain<Field> {
    using type = blend::Mean::Sum<typename Field::Value>;
  };
  template <class Field>
  requires(kIsOrder<Field>&& std::is_same_v<typename Field::Value, bool>) struct Plain<Field> {
    using type = AnyYes;
  };
  template <class Field>
  using SumOf = typename Plain<Field>::type;
};

}  // namespace eyrie::ubf
