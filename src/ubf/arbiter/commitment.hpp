// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/arbiter/held_proposal.hpp"
#include "ubf/composite.hpp"
#include "ubf/simulated_time.hpp"

namespace eyrie::ubf {

struct CommitmentMemory {
  double since = 0;             ///< s, when the committed child took over
  double last_proposed = 0;     ///< s, when it last had a proposal
  std::uint16_t committed = 0;  ///< 1 + child, 0 for none
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
template <class State, class Action>
class Commitment final : public WithMemory<Voting<State, Action>, CommitmentMemory> {
  using Base = WithMemory<Voting<State, Action>, CommitmentMemory>;

 public:
  static constexpr std::string_view type_name = "commitment";
  static constexpr std::string_view help =
      "the proposal with the highest vote, kept against short-lived or slightly better rivals";
  static constexpr Kind kind = Kind::arbiter;
  static constexpr bool takes_one_child = true;
  [[nodiscard]] static constexpr auto params() {
    return std::tuple_cat(
        std::tuple{param("margin", &Commitment::margin, range(0, 1000),
                         "by how much a rival's vote must be higher"),
                   param("min_time", &Commitment::min_time, "s", range(0, 1e6),
                         "how long a choice stands before a rival may replace it"),
                   param("hold", &Commitment::hold, "s", range(0, 1e6),
                         "how long the last proposal of a child that fell silent is kept up")},
        Voting<State, Action>::template vote_params<Commitment>());
  }
  using Base::Base;

  float margin = 0;
  double min_time = 0;  ///< s
  double hold = 0;      ///< s

  [[nodiscard]] bool stands() const noexcept override { return true; }
  [[nodiscard]] std::size_t memory_bytes() const noexcept override {
    return sizeof(CommitmentMemory) + (hold > 0 ? sizeof(Held) : 0);
  }
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept override {
    const auto& m = this->memory(slab);
    return m.committed ? static_cast<NodeIndex>(m.committed - 1) : kNone;
  }
  [[nodiscard]] std::string problem() const override {
    if (margin == 0 && min_time == 0 && hold == 0)
      return "commitment needs 'margin', 'min_time' or 'hold' above 0, or it commits to nothing";
    return Base::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    Choice incumbent, rival;
    incumbent.child = this->active_child(t.memory);
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
      m.committed = static_cast<std::uint16_t>(rival.child + 1);
      m.since = t.time;
    }

    const Choice& chosen = change ? rival : incumbent;
    const bool stands_in = bridged && !change;
    out.copy(chosen.proposal());
    trace(t, *this->children_[chosen.child], out, stands_in);
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
  void trace(const Tick<State>& t, const typename Commitment::Node& child,
             const Proposal<Action>& proposal, bool bridged) const {
    if (!t.trace) [[likely]]
      return;
    if (bridged)
      Trace<Action>::of(*t.trace).supplied(this->index(), child.index(), proposal.action);
    else
      this->took(t, child);
  }
};

}  // namespace eyrie::ubf
