// SPDX-License-Identifier: MIT
#pragma once
/// \file  Selector and sequence that go on where they left off.
#include "ubf/composite.hpp"

namespace eyrie::ubf {

struct ResumingMemory {
  std::uint16_t running = 0;  ///< 1 + the child that was left running, 0 for none
};

/// The base of the control nodes with memory: children before the one left running are not asked
/// again until the node itself has ended. When it ends, nothing in it goes on.
template <class State, class Action>
class Resuming : public WithMemory<Voting<State, Action>, ResumingMemory> {
 public:
  using WithMemory<Voting<State, Action>, ResumingMemory>::WithMemory;

  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept final {
    const auto& m = this->memory(slab);
    return m.running ? static_cast<NodeIndex>(m.running - 1) : kNone;
  }

 protected:
  /// Asks from the child that was left running, while children answer `go_on`; answers what the
  /// last one asked did.
  Status resume(const Tick<State>& t, Proposal<Action>& out, Status go_on) const {
    auto& m = this->memory(t);
    Status status = go_on;
    for (std::size_t i = m.running ? m.running - 1u : 0u;
         i < this->children_.size() && status == go_on; ++i) {
      const auto& child = *this->children_[i];
      status = this->ask_over(child, t, out);
      m.running = status == Status::running ? static_cast<std::uint16_t>(i + 1) : 0;
      if (status != Status::running)
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
template <class State, class Action>
class SelectorWithMemory final : public Resuming<State, Action> {
 public:
  static constexpr std::string_view type_name = "selector_with_memory";
  static constexpr std::string_view help =
      "the first child that does not fail; a running child is not interrupted";
  static constexpr Kind kind = Kind::control;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<SelectorWithMemory>();
  }
  using Resuming<State, Action>::Resuming;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->resume(t, out, Status::failure);
  }
};

/// A sequence that resumes: a child that succeeded is not asked again until the sequence has ended.
/// What goes up is the proposal of the last child asked in this tick that made one. Succeeds when
/// the last child has succeeded; succeeds or fails, it starts from the first child the next time.
/// Marzinotto et al., "Towards a Unified Behavior Trees Framework for Robot Control" (ICRA 2014),
/// "sequence*".
template <class State, class Action>
class SequenceWithMemory final : public Resuming<State, Action> {
 public:
  static constexpr std::string_view type_name = "sequence_with_memory";
  static constexpr std::string_view help =
      "one child after the other; what has succeeded is not asked again";
  static constexpr Kind kind = Kind::control;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<SequenceWithMemory>();
  }
  using Resuming<State, Action>::Resuming;

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    return this->resume(t, out, Status::success);
  }
};

}  // namespace eyrie::ubf
