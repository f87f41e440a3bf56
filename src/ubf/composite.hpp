// SPDX-License-Identifier: MIT
#pragma once
/// \file  A node with children: how it asks them, makes them forget, and hands on what they say.
#include <iterator>

#include "ubf/behavior.hpp"
#include "ubf/trace.hpp"

namespace eyrie::ubf {

/// The base of arbiters, control nodes and decorators.
template <class State, class Action>
class Composite : public Behavior<State, Action> {
 public:
  using Node = Behavior<State, Action>;
  using Child = std::unique_ptr<Node>;
  using Children = std::vector<Child>;

  /// Gives a node its children while the tree is being built.
  void adopt(Children children) {
    this->children_.assign(std::make_move_iterator(children.begin()),
                           std::make_move_iterator(children.end()));
  }
  template <std::convertible_to<Child>... C>
  void adopt(C... children) {
    (this->children_.push_back(std::move(children)), ...);
  }

 protected:
  /// Asks a child for its proposal. Everything goes through here: what arrives in `out` is emptied
  /// first, and the answer is checked and traced. An answer that means nothing is a failure.
  Status ask(const AnyNode& child, const Tick<State>& t, Proposal<Action>& out) const {
    if (out.leader != kNone)  // somebody was asked into it; a fresh one is empty
      out.clear();
    if (t.trace) [[unlikely]]
      t.trace->asking(child.index_);
    Status status = typed(child).decide(t, out);
    if (status != Status::failure && !(is_vote(out.vote) && fields_mean_something(out)))
        [[unlikely]]
      status = refuse(child, t, out, status);
    name_leader(child, out);
    if (t.trace) [[unlikely]]
      record(*t.trace, child.index_, status, out);
    return status;
  }
  /// Takes a child whose answer means nothing as one that failed; what was going on in it forgets.
  [[gnu::cold, gnu::noinline]] Status refuse(const AnyNode& child, const Tick<State>& t,
                                             Proposal<Action>& out, Status answered) const {
    detail::note_mistake(t, child.index_, out);
    if (left_open(child, answered))
      halt(child, t);
    out.clear();
    return Status::failure;
  }
  /// Whether a proposal that outvotes another one counts: -0 abstains as 0 does.
  [[nodiscard]] bool is_heard(const AnyNode& child, const Tick<State>& t, Proposal<Action>& out,
                              Status answered) const {
    const bool meant = fields_mean_something(out);
    if (detail::is_plain_vote(out.vote) && meant) [[likely]]
      return true;
    if (!meant || !is_vote(out.vote))
      refuse(child, t, out, answered);
    return false;
  }
  /// What came from a leaf is led by it.
  static void name_leader(const AnyNode& child, Proposal<Action>& out) {
    if (out.leader == kNone)
      out.leader = child.index_;
  }
  /// Asks a child whose proposal replaces what is in `out`, unless it fails or proposes nothing, as
  /// a condition does.
  Status ask_over(const AnyNode& child, const Tick<State>& t, Proposal<Action>& out) const {
    if (out.is_empty()) {
      const Status status = ask(child, t, out);
      if (status == Status::failure)
        out.clear();
      else if (!out.is_empty())
        took(t, child);
      return status;
    }
    Scratch<Action> scratch;
    Proposal<Action>& next = scratch.get();
    const Status status = ask(child, t, next);
    if (status != Status::failure && !next.is_empty()) {
      out.copy(next);
      took(t, child);
    }
    return status;
  }

  /// The child's subtree starts anew, without having lost control.
  void forget(const AnyNode& child, const Tick<State>& t) const {
    const std::size_t bytes = child.memory_end_ - child.memory_begin_;
    if (bytes)
      std::memset(t.memory + child.memory_begin_, 0, bytes);
  }
  /// The child's subtree loses control: it forgets.
  void halt(const AnyNode& child, const Tick<State>& t) const {
    forget(child, t);
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).halted(child.index_, child.end_index_);
  }
  /// Whether a child that gave this answer has something in it that still goes on, so that it has
  /// to be halted by whoever stops asking it.
  [[nodiscard]] static bool left_open(const AnyNode& child, Status answer) {
    return answer == Status::running || child.stands_;
  }
  /// The child ended and will not be asked again before this node starts anew.
  void close(const AnyNode& child, const Tick<State>& t) const {
    if (child.stands_)
      halt(child, t);
  }
  /// Tells the trace that what a child proposed in an earlier tick goes up.
  void supplied(const Tick<State>& t, const AnyNode& child, const Proposal<Action>& out) const {
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).supplied(this->index(), child.index_, out.action);
  }
  /// Tells the trace whose proposal goes up.
  void took(const Tick<State>& t, const AnyNode& child) const {
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).took(this->index(), child.index_);
  }

  [[nodiscard]] static const Node& typed(const AnyNode& node) {
    return static_cast<const Node&>(node);
  }

 private:
  [[gnu::noinline]] static void record(AnyTrace& trace, NodeIndex node, Status status,
                                       const Proposal<Action>& out) {
    Trace<Action>::of(trace).record(node, status, out);
    trace.answered();
  }
};

/// A composite that may rescale what it sends up.
template <class State, class Action>
class Voting : public Composite<State, Action> {
 public:
  std::optional<float> vote;  ///< what goes up votes exactly this
  float vote_scale = 1;       ///< the vote that goes up is multiplied by this

  [[nodiscard]] std::string problem() const override {
    return vote && vote_scale != 1 ? "give either 'vote' or 'vote_scale', not both" : "";
  }
  [[nodiscard]] static constexpr auto params() {
    return Lines{
        param("vote", &Voting::vote, range(0, 1000), "fixed vote of what this node sends up"),
        param("vote_scale", &Voting::vote_scale, range(0, 1000),
              "factor on the vote of what this node sends up")};
  }
  /// The parameters of a node that has others besides.
  template <class... Own>
  [[nodiscard]] static constexpr auto with_vote(const Own&... own) {
    return joined(Lines{own...}, Voting::params());
  }

 protected:
  /// Never turns an empty proposal into one.
  void rescale(Proposal<Action>& out) const {
    if (!vote)
      out.vote *= vote_scale;
    else if (!out.is_empty())
      out.vote = *vote;
  }
  /// Sends up what `child` proposed and answered.
  Status hand_on(const Tick<State>& t, const AnyNode& child, Proposal<Action>& out,
                 Status answer) const {
    this->took(t, child);
    rescale(out);
    return answer;
  }
};

/// The base of arbiters, which ask every child in every tick.
template <class State, class Action>
class Arbiter : public Voting<State, Action> {
 public:
  static constexpr Kind kind = Kind::arbiter;

  [[nodiscard]] bool stands() const noexcept override { return true; }

 protected:
  using Voting<State, Action>::hand_on;

  /// The position of the child that was chosen, kNone for none, and what it answered.
  struct Choice {
    NodeIndex child = kNone;
    Status status = Status::failure;
  };
  /// Asks every child. Of those that neither fail nor abstain the last one that
  /// `takes(child, proposal, chosen_so_far)` is chosen; `out` holds what it proposes.
  template <class Takes>
  Choice choose(const Tick<State>& t, Proposal<Action>& out, Takes takes) const {
    Choice chosen;
    Scratch<Action> other;
    BestSoFar<Action> best(out, other);
    for (NodeIndex i = 0; i < this->children_.size(); ++i) {
      const Status answer = this->ask(*this->children_[i], t, best.next());
      if (answer == Status::failure || best.next().vote == 0 ||
          !takes(i, best.next(), chosen.child))
        continue;
      chosen = {i, answer};
      best.keep();
    }
    best.hand_on();
    return chosen;
  }
  /// Sends up what the chosen child proposed and answered; fails without one.
  Status hand_on(const Tick<State>& t, const Choice& chosen, Proposal<Action>& out) const {
    return chosen.child == kNone ? Status::failure
                                 : hand_on(t, *this->children_[chosen.child], out, chosen.status);
  }
};

/// The base of control nodes, which decide by the statuses of their children whom they ask.
template <class State, class Action>
class Control : public Voting<State, Action> {
 public:
  static constexpr Kind kind = Kind::control;
  static constexpr std::size_t kMostInABitSet = 64;  ///< children of a node that notes them in bits

 protected:
  [[nodiscard]] std::string too_many(std::string_view name) const {
    return fmt::format("{} takes at most {} children, here are {}", name, kMostInABitSet,
                       this->children_.size());
  }
};

/// The base of nodes with exactly one child.
template <class State, class Action>
class Decorator : public Composite<State, Action> {
 public:
  static constexpr Kind kind = Kind::decorator;
  static constexpr std::array<std::string_view, 1> slots{"child"};

  [[nodiscard]] bool stands() const noexcept override { return this->any_child_stands(); }

 protected:
  [[nodiscard]] const AnyNode& child() const { return *this->children_.front(); }

  /// Asks the child on behalf of this node.
  Status ask_child(const Tick<State>& t, Proposal<Action>& out) const {
    const Status answer = this->ask(child(), t, out);
    this->took(t, child());
    return answer;
  }
  /// The same for a node that will not ask it again before it starts anew, once it has ended.
  Status ask_to_its_end(const Tick<State>& t, Proposal<Action>& out) const {
    const Status answer = ask_child(t, out);
    if (answer != Status::running)
      this->close(child(), t);
    return answer;
  }
};

}  // namespace eyrie::ubf
