// SPDX-License-Identifier: MIT
#pragma once
/// \file  An agent's brain as a row: which tree it uses, and the slab that the tree works on.
#include "ubf/tree.hpp"

namespace eyrie::ubf {

/// What an agent carries from tick to tick, as plain bytes: copying it in mid-run copies the agent,
/// and its hash is the hash of what it remembers. Fresh is zero: the first tree, nothing
/// remembered.
template <std::size_t Bytes>
struct Brain {
  static_assert(Bytes % 8 == 0);
  static constexpr std::size_t kBytes = Bytes;

  std::uint16_t tree = 0;  ///< index into Trees
  std::uint8_t reserved[6] = {};
  alignas(8) std::array<std::byte, Bytes> memory{};
};

/// From now on the agent uses another tree, which begins with nothing remembered. Swapping to the
/// tree it already uses starts that tree anew.
template <std::size_t Bytes>
void swap_tree(Brain<Bytes>& brain, std::uint16_t tree) {
  brain.tree = tree;
  std::memset(brain.memory.data(), 0, Bytes);
}

/// The trees of a scenario, which its agents share.
template <class State, class Action>
class Trees {
 public:
  using TreeType = Tree<State, Action>;

  /// Refuses (std::logic_error) a name that is taken, and more than 65535 trees.
  std::uint16_t add(TreeType tree) {
    EYRIE_THROW_UNLESS(!find(tree.name()), "two trees have the same name");
    EYRIE_THROW_UNLESS(trees_.size() < kNone, "too many trees");
    max_memory_ = std::max(max_memory_, tree.memory_bytes());
    max_size_ = std::max(max_size_, tree.size());
    trees_.push_back(std::move(tree));
    return static_cast<std::uint16_t>(trees_.size() - 1);
  }

  [[nodiscard]] const TreeType& operator[](std::uint16_t index) const { return trees_[index]; }
  [[nodiscard]] std::size_t size() const { return trees_.size(); }
  [[nodiscard]] auto begin() const { return trees_.begin(); }
  [[nodiscard]] auto end() const { return trees_.end(); }
  /// The same, whatever their states and actions are.
  [[nodiscard]] std::vector<const AnyTree*> all() const {
    std::vector<const AnyTree*> trees;
    for (const TreeType& tree : trees_)
      trees.push_back(&tree);
    return trees;
  }
  [[nodiscard]] std::optional<std::uint16_t> find(std::string_view name) const {
    for (std::size_t i = 0; i < trees_.size(); ++i)
      if (trees_[i].name() == name)
        return static_cast<std::uint16_t>(i);
    return std::nullopt;
  }

  /// The slab that is large enough for every tree, in bytes.
  [[nodiscard]] std::size_t max_memory() const { return max_memory_; }
  /// The trace that is large enough for every tree, in nodes.
  [[nodiscard]] std::size_t max_size() const { return max_size_; }

 private:
  std::vector<TreeType> trees_;
  std::size_t max_memory_ = 0, max_size_ = 0;
};

/// One decision of one agent: its tree looks at `tick.state`, works on its memory, and leaves its
/// recommendation in `out` (empty after a failure). `tick.memory` is set here.
template <class State, class Action, std::size_t Bytes>
Status tick_agent(const Trees<State, Action>& trees, Brain<Bytes>& brain, Tick<State> tick,
                  Proposal<Action>& out) {
  EYRIE_DEMAND(brain.tree < trees.size(), "a brain with a tree that there is not");
  const auto& tree = trees[brain.tree];
  EYRIE_DEMAND(tree.memory_bytes() <= Bytes, "a brain smaller than the memory of its tree");
  tick.memory = brain.memory.data();
  return tree.tick(tick, out);
}

}  // namespace eyrie::ubf
