// SPDX-License-Identifier: MIT
#pragma once
/// \file  A node with children: how it asks them, makes them forget, and hands on what they say.
#include <fmt/format.h>

#include <concepts>
#include <cstring>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "core/describe.hpp"
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

  Composite() = default;
  explicit Composite(Children children) : children_(std::move(children)) {}
  template <std::convertible_to<Child>... C>
  requires(sizeof...(C) > 0) explicit Composite(C... children) {
    (children_.push_back(std::move(children)), ...);
  }

  [[nodiscard]] std::span<const Child> children() const noexcept final { return children_; }
  /// Gives a node its children while the tree is being built.
  void adopt(Children children) { children_ = std::move(children); }

 protected:
  /// Asks a child for its proposal. Everything goes through here: what arrives in `out` is emptied
  /// first, and the answer is checked and traced. An answer that means nothing is a failure.
  Status ask(const Node& child, const Tick<State>& t, Proposal<Action>& out) const {
    if (out.leader != kNone)  // somebody was asked into it; a fresh one is empty
      out.clear();
    if (t.trace) [[unlikely]]
      t.trace->asking(child.index_);
    Status status = child.decide(t, out);
    if (status != Status::failure && !(is_vote(out.vote) && fields_mean_something(out)))
        [[unlikely]]
      status = refuse(child, t, out, status);
    name_leader(child, out);
    if (t.trace) [[unlikely]]
      record(*t.trace, child.index_, status, out);
    return status;
  }
  /// Takes a child whose answer means nothing as one that failed; what was going on in it forgets.
  [[gnu::cold, gnu::noinline]] Status refuse(const Node& child, const Tick<State>& t,
                                             Proposal<Action>& out, Status answered) const {
    detail::note_mistake(t, child.index_, out);
    if (answered == Status::running)
      halt(child, t);
    out.clear();
    return Status::failure;
  }
  /// Whether a proposal that outvotes another one counts: -0 abstains as 0 does.
  [[nodiscard]] bool is_heard(const Node& child, const Tick<State>& t, Proposal<Action>& out,
                              Status answered) const {
    const bool meant = fields_mean_something(out);
    if (detail::is_plain_vote(out.vote) && meant) [[likely]]
      return true;
    if (!meant || !is_vote(out.vote))
      refuse(child, t, out, answered);
    return false;
  }
  /// What came from a leaf is led by it.
  static void name_leader(const Node& child, Proposal<Action>& out) {
    if (out.leader == kNone)
      out.leader = child.index_;
  }
  /// Asks a child whose proposal replaces what is in `out`, unless it fails or proposes nothing, as
  /// a condition does.
  Status ask_over(const Node& child, const Tick<State>& t, Proposal<Action>& out) const {
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
  void forget(const Node& child, const Tick<State>& t) const {
    const std::size_t bytes = child.memory_end_ - child.memory_begin_;
    if (bytes)
      std::memset(t.memory + child.memory_begin_, 0, bytes);
  }
  /// The child's subtree loses control: it forgets.
  void halt(const Node& child, const Tick<State>& t) const {
    forget(child, t);
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).halted(child.index_, child.end_index_);
  }
  /// Whether a child that gave this answer has something in it that still goes on, so that it has
  /// to be halted by whoever stops asking it.
  [[nodiscard]] static bool left_open(const Node& child, Status answer) {
    return answer == Status::running || child.stands_;
  }
  /// The child ended and will not be asked again before this node starts anew.
  void close(const Node& child, const Tick<State>& t) const {
    if (child.stands_)
      halt(child, t);
  }
  [[nodiscard]] bool any_child_stands() const noexcept {
    for (const Child& child : children_)
      if (child->stands_)
        return true;
    return false;
  }

  /// Tells the trace whose proposal goes up.
  void took(const Tick<State>& t, const Node& child) const {
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).took(this->index(), child.index_);
  }

  Children children_;

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
  using Composite<State, Action>::Composite;

  std::optional<float> vote;  ///< what goes up votes exactly this
  float vote_scale = 1;       ///< the vote that goes up is multiplied by this

  [[nodiscard]] std::string problem() const override {
    return vote && vote_scale != 1 ? "give either 'vote' or 'vote_scale', not both" : "";
  }

  template <class Self>
  [[nodiscard]] static auto vote_params() {
    return std::tuple{
        param("vote", &Self::vote, "", range(0, 1000), "fixed vote of what this node sends up"),
        param("vote_scale", &Self::vote_scale, "", range(0, 1000),
              "factor on the vote of what this node sends up")};
  }

 protected:
  /// Never turns an empty proposal into one.
  void rescale(Proposal<Action>& out) const {
    if (!vote)
      out.vote *= vote_scale;
    else if (!out.is_empty())
      out.vote = *vote;
  }
};

}  // namespace eyrie::ubf
