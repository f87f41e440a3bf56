// SPDX-License-Identifier: MIT
#pragma once
/// \file  An action with a vote, and the places that arbiters keep proposals in.
#include <new>

#include "ubf/action_traits.hpp"
#include "ubf/memory.hpp"

namespace eyrie::ubf {

/// An action together with how strongly it is recommended. The vote is finite and not negative; a
/// vote of 0 abstains from every arbiter. A proposal that means nothing is a failure (Mistake).
template <class Action>
struct Proposal {
  Action action{};
  float vote = 0;
  /// The node that this comes from: the behavior that recommended it, of several mixed field by
  /// field the strongest, or the arbiter that blended it; kNone for no proposal. Filled in on the
  /// way up, not by behaviors, so that it is known without a trace.
  NodeIndex leader = kNone;

  void clear() noexcept {
    // Many small writes are what a tick waits for: few large ones, unless a field is large.
    if constexpr (sizeof(Proposal) <= 16 * (kFields<Action> + 2)) {
      static constexpr Proposal kEmpty{};
      std::memcpy(static_cast<void*>(this), &kEmpty, sizeof kEmpty);
    } else {
      ubf::clear(action);
      vote = 0;
      leader = kNone;
    }
  }
  /// What plain assignment does, faster just after the other was written.
  void copy(const Proposal& other) noexcept {
    ubf::copy(other.action, action);
    vote = other.vote;
    leader = other.leader;
  }
  /// Neither a vote nor any field: this is no proposal.
  [[nodiscard]] bool is_empty() const noexcept { return vote == 0 && ubf::is_empty(action); }
};

/// To Scratch: it is cleared before anybody is asked into it.
struct ClearedLater {};

/// An empty proposal on the stack, for a node to ask its children into. It is cleared and not made
/// by Proposal{}, which writes a large action value by value: that took 40 % of a tick.
template <class Action>
class Scratch {
 public:
  Scratch() noexcept { get().clear(); }
  /// Only its vote is written, so that what is asked first can be compared with it.
  explicit Scratch(ClearedLater) noexcept { get().vote = 0; }
  [[nodiscard]] Proposal<Action>& get() noexcept {
    return *std::launder(reinterpret_cast<Proposal<Action>*>(bytes_));
  }
  [[nodiscard]] const Proposal<Action>& get() const noexcept {
    return *std::launder(reinterpret_cast<const Proposal<Action>*>(bytes_));
  }

 private:
  static_assert(std::is_trivially_copyable_v<Proposal<Action>>);
  alignas(Proposal<Action>) std::byte bytes_[sizeof(Proposal<Action>)];
};

/// Two places that children propose into in turn, one of them the node's own `out`: what is chosen
/// is kept by exchanging the places, and copied at most once, at the end. The second place stays
/// outside: what children may write to must not be one object with the two pointers, or they are
/// read from memory again after every child (measured: 57 ns of 13 nodes became 85).
template <class Action>
class BestSoFar {
 public:
  BestSoFar(Proposal<Action>& out, Scratch<Action>& other) noexcept
      : out_(out), best_(&other.get()), next_(&out) {}
  BestSoFar(const BestSoFar&) = delete;
  BestSoFar& operator=(const BestSoFar&) = delete;

  /// Where the next child proposes.
  [[nodiscard]] Proposal<Action>& next() noexcept { return *next_; }
  /// The best so far, empty before the first. Compare with it, not with a copy of its vote: that
  /// one goes through memory too, with a store after every choice and more to hold during a call.
  [[nodiscard]] const Proposal<Action>& kept() const noexcept { return *best_; }
  /// What is in next() is the best so far.
  void keep() noexcept { std::swap(best_, next_); }
  /// Leaves the best in `out`.
  void hand_on() noexcept {
    if (best_ != &out_)
      out_.copy(*best_);
  }

 private:
  Proposal<Action>& out_;
  Proposal<Action>*best_, *next_;
};

namespace detail {
/// The sign is not set, and it is neither infinite nor NaN.
[[nodiscard]] constexpr bool is_plain_vote(float vote) {
  return std::bit_cast<std::uint32_t>(vote) <= 0x7f7fffffU;
}
}  // namespace detail

/// A vote in [0, infinity), which NaN is not. One comparison of bits: every node's vote is looked
/// at (as two comparisons of numbers it was 15 % of a tick).
[[nodiscard]] constexpr bool is_vote(float vote) {
  return detail::is_plain_vote(vote) || vote == 0;
}
/// Of two votes the larger, as their bits are in the same order; what is no vote beats every vote,
/// and so does -0. So who looks for the largest has to look only at what beats the others.
[[nodiscard]] constexpr bool outvotes(float vote, float other) {
  return std::bit_cast<std::uint32_t>(vote) > std::bit_cast<std::uint32_t>(other);
}

/// Whether an answer means something. Fields are looked at where they come from, that is as long as
/// nobody leads.
template <class Action>
[[nodiscard]] bool fields_mean_something(const Proposal<Action>& proposal) {
  return proposal.leader != kNone || implausible_field(proposal.action) == kFields<Action>;
}

/// A proposal kept in the slab, to stand in for a child that fell silent.
template <class Action>
struct HeldProposal {
  PackedAction<Action> action;
  float vote = 0;
  NodeIndex leader = 0;
  std::uint16_t reserved = 0;

  void keep(const Proposal<Action>& proposal) {
    action.assign(proposal.action);
    vote = proposal.vote;
    leader = proposal.leader;
  }
  void get(Proposal<Action>& proposal) const {
    action.unpack(proposal.action);
    proposal.vote = vote;
    proposal.leader = leader;
  }
};

}  // namespace eyrie::ubf
