// SPDX-License-Identifier: MIT
#pragma once
/// \file  Rank instead of votes: the first that is heard, and Brooks' suppression and inhibition.
#include "ubf/composite.hpp"

namespace eyrie::ubf {

/// The base of priority and suppress: asks every child, and the first one that is heard leads.
template <class State, class Action, NodeMemory Memory>
class Ranked : public WithMemory<Arbiter<State, Action>, Memory> {
 public:
  static constexpr std::string_view decided_by = "rank";

 protected:
  /// Leaves in `out` what the first child proposes that neither fails nor abstains, or else `held`
  /// if that one is heard.
  auto first_heard(const Tick<State>& t, Proposal<Action>& out, NodeIndex held = kNone) const {
    return this->choose(t, out, [held](NodeIndex i, const auto&, NodeIndex chosen) {
      return chosen == kNone || i == held;
    });
  }
};

struct PriorityMemory {
  ChildSlot child;  ///< the one that may not be interrupted
};

/// Asks every child and hands on the proposal of the first one that is heard, however it votes: the
/// order in the file is the order of rank. A child that is not interruptible, once it is chosen and
/// running, keeps control over those before it until it succeeds, fails or abstains. Failing and
/// abstaining children are ignored; if that leaves none, it fails. Vote and status are those of the
/// chosen child. A selector differs in that it does not ask those behind the chosen child, and in
/// that it hears who does not vote.
///   priority: {interruptible: [true, false, true], children: [avoid_ground, release_weapon,
///   pursue]}
template <class State, class Action>
class Priority final : public Ranked<State, Action, PriorityMemory> {
 public:
  static constexpr std::string_view type_name = "priority";
  static constexpr std::string_view help = "the proposal of the first child that makes one";
  [[nodiscard]] static constexpr auto params() {
    return Priority::with_vote(
        param("interruptible", &Priority::interruptible,
              "one per child: may those before it take over while it runs? none: all"));
  }

  std::vector<bool> interruptible;

  [[nodiscard]] bool remembers() const noexcept override {
    return std::ranges::find(interruptible, false) != interruptible.end();
  }
  [[nodiscard]] std::string problem() const override {
    const std::size_t count = this->children_.size();
    if (!interruptible.empty() && interruptible.size() != count)
      return fmt::format("'interruptible' has {} items for {} children", interruptible.size(),
                         count);
    return Arbiter<State, Action>::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    ChildSlot& held = this->memory(t).child;
    const auto chosen = this->first_heard(t, out, held.get());
    held.clear();
    if (chosen.status == Status::running && !interruptible.empty() && !interruptible[chosen.child])
      held.set(chosen.child);
    return this->hand_on(t, chosen, out);
  }
};

template <class Action>
struct SuppressMemory {
  double last = 0;  ///< s, when the higher layer last proposed
  HeldProposal<Action> proposal;
  std::uint8_t holding = 0;  ///< 1: `proposal` and `last` count
  std::uint8_t reserved[7] = {};
};

/// Two layers: what the higher one (`by`) proposes replaces what the lower one (`child`) proposes,
/// and its last proposal stands in for it for `hold` after it spoke last, with the status
/// running. Both layers are asked in every tick. A layer that fails or abstains is silent; if both
/// are and nothing is held, it fails. The suppression node of Brooks, "A Robust Layered Control
/// System for a Mobile Robot" (IEEE Journal of Robotics and Automation, 1986).
///   suppress: {hold: 2 s, by: avoid_ground, child: pursue}
template <class State, class Action>
class Suppress final : public Ranked<State, Action, SuppressMemory<Action>> {
 public:
  static constexpr std::string_view type_name = "suppress";
  static constexpr std::string_view help =
      "a higher layer's proposal replaces a lower one's, for a while";
  static constexpr std::array<std::string_view, 2> slots{"by", "child"};
  [[nodiscard]] static constexpr auto params() {
    return Suppress::with_vote(param("hold", &Suppress::hold, "s", range(0, 1e6),
                                     "how long the higher layer's last proposal goes on to "
                                     "replace"));
  }

  double hold = 0;  ///< s

  [[nodiscard]] bool remembers() const noexcept override { return hold > 0; }
  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    const auto chosen = this->first_heard(t, out);
    if (chosen.child == 0) {
      if (hold > 0) {
        m.proposal.keep(out);
        m.last = t.time;
        m.holding = 1;
      }
    } else if (m.holding && !passed(t.time, m.last, hold)) {
      m.proposal.get(out);
      this->supplied(t, *this->children_[0], out);
      this->rescale(out);
      return Status::running;
    } else {
      m = {};
    }
    return this->hand_on(t, chosen, out);
  }
};

struct InhibitMemory {
  double last = 0;           ///< s, when `by` last did not fail
  std::uint8_t blocked = 0;  ///< 1: `last` counts
  std::uint8_t reserved[7] = {};
};

/// Two layers: while the higher one (`by`) does not fail, and for `hold` after that, what the lower
/// one (`child`) proposes is lost, and it fails. What `by` proposes is ignored, so a condition will
/// do. Both are asked in every tick. A lower layer that fails or abstains is a failure. The
/// inhibition node of Brooks, "A Robust Layered Control System for a Mobile Robot" (IEEE Journal of
/// Robotics and Automation, 1986).
///   inhibit: {by: bingo, hold: 10 s, child: pursue}
template <class State, class Action>
class Inhibit final : public WithMemory<Arbiter<State, Action>, InhibitMemory> {
 public:
  static constexpr std::string_view type_name = "inhibit";
  static constexpr std::string_view help = "a higher layer blocks a lower one, for a while";
  static constexpr std::array<std::string_view, 2> slots{"by", "child"};
  [[nodiscard]] static constexpr auto params() {
    return Inhibit::with_vote(param("hold", &Inhibit::hold, "s", range(0, 1e6),
                                    "how long the lower layer stays blocked afterwards"));
  }

  double hold = 0;  ///< s

  [[nodiscard]] bool remembers() const noexcept override { return hold > 0; }
  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto &higher = *this->children_[0], &lower = *this->children_[1];
    auto& m = this->memory(t);
    const Status above = this->ask(higher, t, out);
    const Status answer = this->ask(lower, t, out);
    if (above != Status::failure) {
      m = {.last = t.time, .blocked = 1};
      return Status::failure;
    }
    if (m.blocked && !passed(t.time, m.last, hold))
      return this->fails(t, "it was inhibited a moment ago");
    m = {};
    if (answer == Status::failure || out.vote == 0)
      return Status::failure;
    return this->hand_on(t, lower, out, answer);
  }
};

}  // namespace eyrie::ubf
