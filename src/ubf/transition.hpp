// SPDX-License-Identifier: MIT
#pragma once
/// \file  How a sequencer reports, without allocating, which tree it left and which it entered.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace eyrie::ubf {

/// Pre-order position of a node in its tree.
using NodeIndex = std::uint16_t;
/// No node, no child.
inline constexpr NodeIndex kNone = 0xffff;

/// A sequencer changed its tree. `from` and `to` count the sequencer's trees in file order;
/// `from` is kNone when it enters its first tree. Names: Tree::node(node).children()[to]->label().
struct Transition {
  NodeIndex node = kNone;  ///< the sequencer
  std::uint16_t from = kNone;
  std::uint16_t to = kNone;
  bool operator==(const Transition&) const = default;
};

/// The transitions of one tick of one agent, in the order in which they happened. Whoever owns the
/// log reads it after the tick and clears it.
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

}  // namespace eyrie::ubf
