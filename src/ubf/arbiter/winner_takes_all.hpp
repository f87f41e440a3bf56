// SPDX-License-Identifier: MIT
#pragma once
/// \file  The highest vote: in every tick anew, or kept against small and short changes.
#include "ubf/composite.hpp"

namespace eyrie::ubf {

/// Asks every child and hands on the proposal with the highest vote, with its child's status.
/// Equal votes: the earlier child. Failing and abstaining children are ignored; if that leaves
/// none, it fails. Roberson et al. (CSC'15), section III.C.2.
///   winner_takes_all: [break_turn, pursue, navigate]
template <class State, class Action>
class WinnerTakesAll final : public Arbiter<State, Action> {
 public:
  static constexpr std::string_view type_name = "winner_takes_all";
  static constexpr std::string_view help = "the proposal with the highest vote";

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    if (t.trace) [[unlikely]]
      return decide_watched(t, out);
    return decide<false>(t, out);
  }

 private:
  [[gnu::noinline]] Status decide_watched(const Tick<State>& t, Proposal<Action>& out) const {
    return decide<true>(t, out);
  }
  /// The arbiter that trees are made of: whether anybody watches is asked once for all children,
  /// and no place is cleared that was not used (measured: 165 ns of 27 leaves became 140).
  template <bool watched>
  [[gnu::always_inline]] Status decide(const Tick<State>& t, Proposal<Action>& out) const {
    Status status = Status::failure;  // stays if nobody is heard
    const AnyNode* winner = nullptr;  // noted for who watches
    Scratch<Action> other(ClearedLater{});
    BestSoFar<Action> best(out, other);
    const auto end = this->children_.end();
    for (auto child = this->children_.begin(); child != end; best.next().clear()) {
      // unwatched, what is left of ask(): best.next() is empty, and only a leader is named
      const Status answer = watched ? this->ask(**child, t, best.next())
                                    : this->typed(**child).decide(t, best.next());
      if (answer != Status::failure && outvotes(best.next().vote, best.kept().vote) &&
          this->is_heard(**child, t, best.next(), answer)) {
        status = answer;
        if constexpr (watched)
          winner = child->get();
        this->name_leader(**child, best.next());
        best.keep();
      }
      if (++child == end)
        break;
    }
    if (status == Status::failure) {
      out.clear();
      return status;
    }
    best.hand_on();
    this->rescale(out);
    if constexpr (watched)
      this->took(t, *winner);
    return status;
  }
};

struct CommitmentMemory {
  double since = 0;          ///< s, when the committed child took over
  double last_proposed = 0;  ///< s, when it last had a proposal
  ChildSlot child;           ///< the committed one
  std::uint8_t reserved[6] = {};
};

/// Winner takes all that does not dither. Once a child is chosen it stays chosen: a challenger
/// replaces it only after `min_time` and only with a vote above the committed child's plus
/// `margin`, and when the committed child falls silent (fails or abstains) its last proposal
/// stands in for it for `hold`. A committed child that succeeds has done what it was chosen for
/// and is committed to no longer. Every child is asked every time.
///
/// Over one child only `hold` matters: it is then a decorator that bridges short silences. That
/// agents without such persistence dither is in Blumberg, "Action-Selection in Hamsterdam" (SAB
/// 94); the rules here are ours.
///   commitment: {margin: 5, min_time: 3 s, hold: 1 s, children: [pursue, follow_lead]}
template <class State, class Action>
class Commitment final : public WithMemory<Arbiter<State, Action>, CommitmentMemory> {
  using Base = WithMemory<Arbiter<State, Action>, CommitmentMemory>;

 public:
  static constexpr std::string_view type_name = "commitment";
  static constexpr std::string_view help =
      "the proposal with the highest vote, kept against short-lived or slightly better rivals";
  static constexpr bool takes_one_child = true;
  [[nodiscard]] static constexpr auto params() {
    return Commitment::with_vote(
        param("margin", &Commitment::margin, range(0, 1000),
              "by how much a rival's vote must be higher"),
        param("min_time", &Commitment::min_time, "s", range(0, 1e6),
              "how long a choice stands before a rival may replace it"),
        param("hold", &Commitment::hold, "s", range(0, 1e6),
              "how long the last proposal of a child that fell silent is kept up"));
  }

  float margin = 0;
  double min_time = 0;  ///< s
  double hold = 0;      ///< s

  [[nodiscard]] std::size_t memory_bytes() const noexcept override {
    return sizeof(CommitmentMemory) + (hold > 0 ? sizeof(Held) : 0);
  }
  [[nodiscard]] std::string problem() const override {
    if (margin == 0 && min_time == 0 && hold == 0)
      return "commitment needs 'margin', 'min_time' or 'hold' above 0, or it commits to nothing";
    return Base::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    Choice incumbent, rival;
    incumbent.child = m.child.get();
    listen(t, incumbent, rival);
    const bool bridged = incumbent.status == Status::failure && bridge(t, incumbent);

    // the incumbent stays unless it has nothing to say or is clearly beaten
    const bool rivaled = rival.status != Status::failure;
    const bool beaten = rivaled && passed(t.time, m.since, min_time) &&
                        rival.proposal().vote > incumbent.proposal().vote + margin;
    const bool change = incumbent.status == Status::failure || beaten;
    if (change && !rivaled) {
      release(t);
      return Status::failure;
    }
    if (change) {
      m.child.set(rival.child);
      m.since = t.time;
    }

    const Choice& chosen = change ? rival : incumbent;
    const bool stands_in = bridged && !change;
    out.copy(chosen.proposal());
    const AnyNode& child = *this->children_[chosen.child];
    if (stands_in)
      this->supplied(t, child, out);
    else
      this->took(t, child);
    if (chosen.status == Status::success)
      release(t);
    else if (!stands_in)
      remember(t, out);
    this->rescale(out);
    return chosen.status;
  }

 private:
  struct Choice {
    NodeIndex child = kNone;
    Status status = Status::failure;
    Scratch<Action> scratch;

    [[nodiscard]] Proposal<Action>& proposal() { return scratch.get(); }
    [[nodiscard]] const Proposal<Action>& proposal() const { return scratch.get(); }
  };
  /// The committed child's last proposal stands behind CommitmentMemory in the slab.
  using Held = HeldProposal<Action>;

  void listen(const Tick<State>& t, Choice& incumbent, Choice& rival) const {
    Scratch<Action> scratch;
    Proposal<Action>& next = scratch.get();
    for (std::size_t i = 0; i < this->children_.size(); ++i) {
      const Status answer = this->ask(*this->children_[i], t, next);
      if (answer == Status::failure || next.vote == 0)
        continue;
      Choice& choice = i == incumbent.child ? incumbent : rival;
      if (!(next.vote > choice.proposal().vote))
        continue;
      choice.child = static_cast<NodeIndex>(i);
      choice.status = answer;
      choice.proposal().copy(next);
    }
  }
  bool bridge(const Tick<State>& t, Choice& incumbent) const {
    const auto& m = this->memory(t);
    if (incumbent.child == kNone || hold == 0 || passed(t.time, m.last_proposed, hold))
      return false;
    held(t).get(incumbent.proposal());
    incumbent.status = Status::running;
    return true;
  }
  void remember(const Tick<State>& t, const Proposal<Action>& proposal) const {
    this->memory(t).last_proposed = t.time;
    if (hold > 0)
      held(t).keep(proposal);
  }
  void release(const Tick<State>& t) const {
    std::memset(t.memory + this->memory_begin(), 0, memory_bytes());
  }
  [[nodiscard]] Held& held(const Tick<State>& t) const {
    return *reinterpret_cast<Held*>(t.memory + this->memory_begin() + sizeof(CommitmentMemory));
  }
};

}  // namespace eyrie::ubf
