// SPDX-License-Identifier: MIT
#pragma once
/// \file  An immutable tree, shared by every agent that uses it.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/assert.hpp"
#include "core/diagnostics.hpp"
#include "ubf/behavior.hpp"
#include "ubf/trace.hpp"

namespace eyrie::ubf {

/// A tree has at most this many nodes, so that an index fits 16 bits and kNone stays free.
inline constexpr std::size_t kMaxNodes = 65'535;
/// No node stands deeper, so that a tick cannot exhaust the stack.
inline constexpr std::size_t kMaxDepth = 64;
/// The slab of one agent has at most this many bytes.
inline constexpr std::size_t kMaxMemory = 1 << 20;

/// Owns the nodes, numbers them in pre-order and lays out the memory that each agent needs.
template <class State, class Action>
class Tree {
 public:
  using Node = Behavior<State, Action>;

  static_assert(std::is_trivially_copyable_v<Action>, "an action is a value");
  static_assert(fields_cover_action<Action>(),
                "ActionTraits<Action>::fields must list every member of the action once");

  /// Refuses (std::logic_error) a null root, nodes without the children they need, with parameters
  /// out of their range or that contradict each other, all of them with their paths and reasons,
  /// and a tree beyond kMaxNodes, kMaxDepth or kMaxMemory.
  Tree(std::string name, std::unique_ptr<Node> root)
      : name_(std::move(name)), root_(std::move(root)) {
    EYRIE_THROW_UNLESS(root_ != nullptr, "a tree needs a root");
    std::vector<Problem> problems;
    lay_out(*root_, kNone, 0, problems);
    if (!problems.empty())
      refuse(problems);
    settle(*root_);
  }

  /// One decision. `t.memory` must be this agent's slab: memory_bytes() bytes at an address that
  /// is a multiple of 8, zero before the first tick. After a failure `out` is empty.
  Status tick(const Tick<State>& t, Proposal<Action>& out) const {
    EYRIE_ASSERT(t.memory != nullptr || memory_bytes() == 0);
    EYRIE_ASSERT(reinterpret_cast<std::uintptr_t>(t.memory) % 8 == 0);
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).begin(size());
    out.clear();
    Status status = root_->decide(t, out);
    if (status != Status::failure && !(is_vote(out.vote) && fields_mean_something(out)))
        [[unlikely]] {
      detail::note_mistake(t, 0, out);
      if (memory_bytes())
        std::memset(t.memory, 0, memory_bytes());
      if (t.trace)
        Trace<Action>::of(*t.trace).halted(0, root_->end_index());
      status = Status::failure;
    }
    if (status == Status::failure || out.is_empty())
      out.clear();
    else if (out.leader == kNone)
      out.leader = 0;
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).record(0, status, out);
    return status;
  }

  [[nodiscard]] std::string_view name() const { return name_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  /// Bytes of slab per agent, a multiple of 8.
  [[nodiscard]] std::size_t memory_bytes() const { return root_->memory_end_; }
  [[nodiscard]] const Node& root() const { return *root_; }
  /// Nodes in pre-order: the root is 0.
  [[nodiscard]] const Node& node(NodeIndex index) const { return *nodes_[index].node; }
  /// kNone for the root.
  [[nodiscard]] NodeIndex parent(NodeIndex index) const { return nodes_[index].parent; }
  /// The root has depth 0.
  [[nodiscard]] std::size_t depth(NodeIndex index) const { return nodes_[index].depth; }

  /// What the first sequencer of the tree has in charge according to a slab: its label, such as
  /// "ingress". Empty if the tree has no sequencer or was not ticked yet.
  [[nodiscard]] std::string_view active_name(std::span<const std::byte> memory) const {
    if (sequencer_ == kNone)
      return {};
    const Node& node = this->node(sequencer_);
    const NodeIndex active = node.active_child(memory.data());
    return active == kNone ? std::string_view{} : node.children()[active]->label();
  }

  /// "root/engage[1]/pursue": labels from the root down; siblings of one label are counted from 0.
  [[nodiscard]] std::string path(NodeIndex index) const {
    if (index == 0)
      return "root";
    const NodeIndex up = parent(index);
    const std::string_view label = node(index).label();
    std::size_t same = 0, before = 0;
    for (const auto& sibling : node(up).children()) {
      if (!sibling || sibling->label() != label)
        continue;
      before += sibling->index() < index;
      ++same;
    }
    std::string text = fmt::format("{}/{}", path(up), label);
    return same > 1 ? fmt::format("{}[{}]", text, before) : text;
  }
  [[nodiscard]] std::optional<NodeIndex> find(std::string_view path) const {
    for (std::size_t i = 0; i < size(); ++i)
      if (this->path(static_cast<NodeIndex>(i)) == path)
        return static_cast<NodeIndex>(i);
    return std::nullopt;
  }

  /// This tree with another node in place of the one at `path` and all below it, as a test needs it
  /// that wants to say what a behavior does. A node without a label takes that of the one before,
  /// so paths stay. Refuses (std::logic_error) a path that is none, and what the constructor
  /// refuses.
  [[nodiscard]] Tree replace(std::string_view path, std::unique_ptr<Node> by) && {
    const std::optional<NodeIndex> at = find(path);
    if (!at) {
      std::vector<std::string> paths;
      for (std::size_t i = 0; i < size(); ++i)
        paths.push_back(this->path(static_cast<NodeIndex>(i)));
      throw std::logic_error(fmt::format("tree {} has no node {}{}", quote(name_), quote(path),
                                         did_you_mean(path, paths)));
    }
    EYRIE_THROW_UNLESS(by != nullptr, "a child is missing");
    if (by->label_.empty())
      by->set_label(std::string(node(*at).label()));
    std::unique_ptr<Node>* place = &root_;
    while (*at > (*place)->index()) {
      const auto& children = (*place)->children();
      std::size_t below = 0;
      while (children[below]->end_index() <= *at)
        ++below;
      // the tree owns it; only the view of a parent's children is const
      place = const_cast<std::unique_ptr<Node>*>(&children[below]);
    }
    *place = std::move(by);
    return Tree(std::move(name_), std::move(root_));
  }

 private:
  struct Place {
    const Node* node;
    NodeIndex parent;
    std::uint16_t depth;
  };

  struct Problem {
    NodeIndex node;
    std::string what;
  };

  void lay_out(Node& node, NodeIndex parent, std::size_t depth, std::vector<Problem>& problems) {
    EYRIE_THROW_UNLESS(depth < kMaxDepth, "the tree is deeper than 64 levels");
    EYRIE_THROW_UNLESS(nodes_.size() < kMaxNodes, "the tree has more than 65535 nodes");
    node.index_ = static_cast<NodeIndex>(nodes_.size());
    nodes_.push_back({&node, parent, static_cast<std::uint16_t>(depth)});
    for (std::string& what : problems_of(node))
      problems.push_back({node.index_, std::move(what)});
    if (sequencer_ == kNone && node.is_sequencer())
      sequencer_ = node.index_;
    node.memory_begin_ = static_cast<std::uint32_t>(memory_);
    memory_ += slab_bytes(node.memory_bytes());
    EYRIE_THROW_UNLESS(memory_ <= kMaxMemory, "the tree needs more than 1 MiB per agent");
    for (const auto& child : node.children())
      if (child)
        lay_out(*child, node.index_, depth + 1, problems);
    node.end_index_ = static_cast<NodeIndex>(nodes_.size());
    node.memory_end_ = static_cast<std::uint32_t>(memory_);
  }
  [[nodiscard]] static std::vector<std::string> problems_of(const Node& node) {
    std::vector<std::string> problems;
    if (node.type_->check)
      node.type_->check(node, problems);
    std::size_t missing = 0;
    for (const auto& child : node.children())
      missing += child == nullptr;
    if (missing)
      problems.push_back("a child is missing");
    else if (std::string problem = node.problem(); !problem.empty())
      problems.push_back(std::move(problem));
    else if (node.node_kind() >= Kind::arbiter && node.children().empty())
      problems.push_back("needs at least one child");
    return problems;
  }
  [[noreturn]] void refuse(const std::vector<Problem>& problems) const {
    std::string text = fmt::format("tree {} cannot be made", quote(name_));
    for (const auto& [node, what] : problems)
      text += fmt::format("\n  {}: {}: {}", path(node), nodes_[node].node->type(), what);
    throw std::logic_error(text);
  }
  /// Whether a node stands depends on its children, so from the leaves up.
  static void settle(Node& node) {
    for (const auto& child : node.children())
      settle(*child);
    node.stands_ = node.stands();
  }

  std::string name_;
  std::unique_ptr<Node> root_;
  std::vector<Place> nodes_;
  NodeIndex sequencer_ = kNone;  ///< the first one
  std::size_t memory_ = 0;
};

}  // namespace eyrie::ubf
