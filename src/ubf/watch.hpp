// SPDX-License-Identifier: MIT
#pragma once
/// \file  What whoever watches a tick is told, without the types of states and actions.
#include <typeinfo>

#include "ubf/memory.hpp"
#include "ubf/vote_curve.hpp"

namespace eyrie::ubf {

/// A sequencer changed its tree. `from` and `to` count the sequencer's trees in file order;
/// `from` is kNone when it enters its first tree. Names: Tree::node(node).children()[to]->label().
struct Transition {
  NodeIndex node = kNone;  ///< the sequencer
  std::uint16_t from = kNone;
  std::uint16_t to = kNone;
  bool operator==(const Transition&) const = default;
};

/// The transitions of one tick of one agent, in the order in which they happened. Whoever owns the
/// log reads it after the tick and clears it. It allocates nothing.
class TransitionLog {
 public:
  static constexpr std::size_t kCapacity = 16;

  void add(const Transition& transition) noexcept {
    if (count_ < kCapacity)
      entries_[count_++] = transition;
    else
      ++dropped_;
  }
  void clear() noexcept { count_ = dropped_ = 0; }

  [[nodiscard]] std::span<const Transition> entries() const noexcept {
    return {entries_.data(), count_};
  }
  /// Transitions that found the log full.
  [[nodiscard]] std::size_t dropped() const noexcept { return dropped_; }

 private:
  std::array<Transition, kCapacity> entries_;
  std::size_t count_ = 0, dropped_ = 0;
};

/// An answer that means nothing: a vote or a status that is none, or a field that is NaN, infinite
/// or beyond what is plausible. Whoever gives it is taken to have failed.
struct Mistake {
  NodeIndex node = kNone;
  std::string what;  ///< "votes what means nothing: vote is nan"
};

/// What a Tick carries of a Trace<Action>; it knows which action it was made for.
class AnyTrace {
 public:
  /// Why a node failed, or what its parent said of its answer (that it refused it), in words that
  /// outlive the trace, such as a literal; null if nobody said anything.
  [[nodiscard]] const char* why(NodeIndex node) const { return reasons_[node]; }
  void because(NodeIndex node, const char* why) { reasons_[node] = why; }
  /// What the considerations of a node's vote came to.
  [[nodiscard]] const VoteCurve::Scores& scores(NodeIndex node) const { return scores_[node]; }
  void weighed(NodeIndex node, const VoteCurve::Scores& scores) { scores_[node] = scores; }
  /// The vote that an arbiter gave a node in the place of its own; NaN if none did.
  [[nodiscard]] float given_vote(NodeIndex node) const { return given_votes_[node]; }
  void voted(NodeIndex node, float vote) { given_votes_[node] = vote; }
  /// Told before a node is asked, so that it is known who threw: the one that was asked last and
  /// has not answered.
  void asking(NodeIndex node) {
    reasons_[node] = nullptr;
    asked_.push_back(node);
  }
  void answered() { asked_.pop_back(); }
  [[nodiscard]] std::span<const NodeIndex> unanswered() const { return asked_; }

 protected:
  AnyTrace(const std::type_info& action, std::size_t nodes)
      : action_(&action), reasons_(nodes, nullptr), scores_(nodes), given_votes_(nodes) {
    asked_.reserve(64);  // no tree is deeper
  }
  ~AnyTrace() = default;

  /// Compared by what it names and not by its place: a plug-in has one of its own.
  const std::type_info* action_;
  std::vector<const char*> reasons_;
  std::vector<VoteCurve::Scores> scores_;
  std::vector<float> given_votes_;
  std::vector<NodeIndex> asked_;
};

}  // namespace eyrie::ubf
