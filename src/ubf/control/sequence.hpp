// SPDX-License-Identifier: MIT
#pragma once
/// \file  Selector and sequence, which start from the first child in every tick, and the same with
/// memory, which go on where they left off.
#include "ubf/composite.hpp"

namespace eyrie::ubf {

/// Which children a reactive node asked in its last tick: the first `asked` of them.
struct ReactiveMemory {
  std::uint16_t asked = 0;
  std::uint8_t running = 0;  ///< 1: the last of them answered running
  std::uint8_t reserved = 0;
};

/// The base of selector and sequence: starts from the first child in every tick, stops at some
/// child, and makes those forget that it asked in the last tick, did not reach in this one, and
/// that were still going on.
template <class State, class Action>
class Reactive : public WithMemory<Control<State, Action>, ReactiveMemory> {
 public:
  [[nodiscard]] bool remembers() const noexcept final { return false; }
  [[nodiscard]] bool stands() const noexcept final { return this->any_child_stands(); }
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept final {
    const auto& m = this->memory(slab);
    return m.running ? static_cast<NodeIndex>(m.asked - 1) : kNone;
  }

 protected:
  /// Called once per tick: this tick asked the first `asked` children, and the last of them
  /// answered `last`.
  void settle(const Tick<State>& t, std::size_t asked, Status last) const {
    auto& m = this->memory(t);
    for (std::size_t i = asked; i < m.asked; ++i) {
      const bool was_running = m.running && i + 1 == m.asked;
      if (this->left_open(*this->children_[i], was_running ? Status::running : Status::success))
        this->halt(*this->children_[i], t);
    }
    m.asked = static_cast<std::uint16_t>(asked);
    m.running = last == Status::running;
  }
};

/// Asks the children in order, from the first in every tick, until one does not fail; that child's
/// proposal and status go up. Fails if every child fails. Also called fallback; reactive, so a
/// child further left takes over as soon as it can. Isla, "Handling Complexity in the Halo 2 AI"
/// (GDC 2005); Colledanchise and Ogren, Behavior Trees in Robotics and AI (2018), algorithm 2.
///   selector: [break_turn, pursue, navigate]
template <class State, class Action>
class Selector final : public Reactive<State, Action> {
 public:
  static constexpr std::string_view type_name = "selector";
  static constexpr std::string_view help = "the first child that does not fail";

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    Status status = Status::failure;
    std::size_t asked = 0;
    for (const auto& child : this->children_) {
      ++asked;
      status = this->ask(*child, t, out);
      if (status == Status::failure)
        continue;
      this->hand_on(t, *child, out, status);
      break;
    }
    this->settle(t, asked, status);
    return status;
  }
};

/// Asks the children in order, from the first in every tick, until one does not succeed, and
/// answers what that one did; succeeds if every child succeeds. What goes up is the proposal of the
/// last child asked that made one: conditions make none, so [condition, action] sends up the
/// action. A failing sequence proposes nothing. Reactive: a condition further left is checked again
/// in every tick. Colledanchise and Ogren, Behavior Trees in Robotics and AI (2018), algorithm 1.
///   sequence: [has_target, pursue]
template <class State, class Action>
class Sequence final : public Reactive<State, Action> {
 public:
  static constexpr std::string_view type_name = "sequence";
  static constexpr std::string_view help = "one child after the other, as long as they succeed";
  static constexpr std::string_view decided_by = "order";

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    Status status = Status::success;
    std::size_t asked = 0;
    for (const auto& child : this->children_) {
      status = this->ask_over(*child, t, out);
      ++asked;
      if (status != Status::success)
        break;
    }
    this->settle(t, asked, status);
    this->rescale(out);
    return status;
  }
};

struct ResumingMemory {
  ChildSlot child;  ///< the one that was left running
};

/// The base of the control nodes with memory: children before the one left running are not asked
/// again until the node itself has ended. When it ends, nothing in it goes on.
template <class State, class Action>
class Resuming : public WithMemory<Control<State, Action>, ResumingMemory> {
 protected:
  /// Asks from the child that was left running, while children answer `go_on`; answers what the
  /// last one asked did.
  Status resume(const Tick<State>& t, Proposal<Action>& out, Status go_on) const {
    auto& m = this->memory(t);
    Status status = go_on;
    for (std::size_t i = m.child ? m.child.get() : 0u;
         i < this->children_.size() && status == go_on; ++i) {
      const auto& child = *this->children_[i];
      status = this->ask_over(child, t, out);
      m.child.clear();
      if (status == Status::running)
        m.child.set(i);
      else
        this->close(child, t);
    }
    this->rescale(out);
    return status;
  }
};

/// A selector that resumes: while a child is running, those before it are not asked again. Fails
/// when the last child has failed; succeeds or fails, it starts from the first child the next time.
/// Marzinotto et al., "Towards a Unified Behavior Trees Framework for Robot Control" (ICRA 2014),
/// "selector*".
///   selector_with_memory: [release_weapon, pursue]
template <class State, class Action>
class SelectorWithMemory final : public Resuming<State, Action> {
 public:
  static constexpr std::string_view type_name = "selector_with_memory";
  static constexpr std::string_view help =
      "the first child that does not fail; a running child is not interrupted";

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->resume(t, out, Status::failure);
  }
};

/// A sequence that resumes: a child that succeeded is not asked again until the sequence has ended.
/// What goes up is the proposal of the last child asked in this tick that made one. Succeeds when
/// the last child has succeeded; succeeds or fails, it starts from the first child the next time.
/// Marzinotto et al., "Towards a Unified Behavior Trees Framework for Robot Control" (ICRA 2014),
/// "sequence*".
///   sequence_with_memory: [navigate, release_weapon, egress]
template <class State, class Action>
class SequenceWithMemory final : public Resuming<State, Action> {
 public:
  static constexpr std::string_view type_name = "sequence_with_memory";
  static constexpr std::string_view help =
      "one child after the other; what has succeeded is not asked again";
  static constexpr std::string_view decided_by = "order";

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->resume(t, out, Status::success);
  }
};

}  // namespace eyrie::ubf
