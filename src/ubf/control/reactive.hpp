// SPDX-License-Identifier: MIT
#pragma once
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
class Reactive : public WithMemory<Voting<State, Action>, ReactiveMemory> {
 public:
  using WithMemory<Voting<State, Action>, ReactiveMemory>::WithMemory;

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

}  // namespace eyrie::ubf
