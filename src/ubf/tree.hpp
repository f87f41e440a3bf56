// SPDX-License-Identifier: MIT
#pragma once
/// \file  An immutable tree, shared by every agent that uses it.
#include "ubf/behavior.hpp"
#include "ubf/trace.hpp"

namespace eyrie::ubf {

/// Owns the nodes, numbers them in pre-order and lays out the memory that each agent needs. Nothing
/// in it changes once it is made: any number of threads may tick it, each with other agents.
template <class State, class Action>
class Tree : public AnyTree {
 public:
  using Node = Behavior<State, Action>;

  static_assert(std::is_trivially_copyable_v<Action>, "an action is a value");
  static_assert(fields_cover_action<Action>(),
                "ActionTraits<Action>::fields must list every member of the action once");

  /// Refuses what AnyTree does.
  Tree(std::string name, std::unique_ptr<Node> root)
      : Tree(AnyTree(std::move(name), std::move(root))) {}

  /// One decision. `t.memory` must be this agent's slab: memory_bytes() bytes at an address that
  /// is a multiple of 8, zero before the first tick. After a failure `out` is empty.
  Status tick(const Tick<State>& t, Proposal<Action>& out) const {
    EYRIE_DEMAND(t.memory != nullptr || memory_bytes() == 0, "a tick without the agent's memory");
    EYRIE_ASSERT(reinterpret_cast<std::uintptr_t>(t.memory) % 8 == 0);
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).begin(size());
    out.clear();
    Status status = root().decide(t, out);
    // also what a node on the way up changed
    if (status != Status::failure &&
        !(is_vote(out.vote) && implausible_field(out.action) == kFields<Action>)) [[unlikely]] {
      detail::note_mistake(t, 0, out);
      if (memory_bytes())
        std::memset(t.memory, 0, memory_bytes());
      if (t.trace)
        Trace<Action>::of(*t.trace).halted(0, root().end_index());
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

  [[nodiscard]] const Node& root() const { return static_cast<const Node&>(AnyTree::root()); }
  [[nodiscard]] const Node& node(NodeIndex index) const {
    return static_cast<const Node&>(AnyTree::node(index));
  }

  /// This tree with another node in place of the one at `path` and all below it, as a test needs it
  /// that wants to say what a behavior does. A node without a label takes that of the one before,
  /// so paths stay. Refuses (std::logic_error) a path that is none, and what the constructor
  /// refuses.
  [[nodiscard]] Tree replace(std::string_view path, std::unique_ptr<Node> by) && {
    put(path, std::move(by));
    check_vote_curves();
    return std::move(*this);
  }

 private:
  template <class, class>
  friend class Registry;
  explicit Tree(AnyTree&& tree) : AnyTree(std::move(tree)) { check_vote_curves(); }
  void check_vote_curves() const {
    for (std::size_t i = 0; i < size(); ++i)
      if (const VoteCurve* curve = AnyTree::node(static_cast<NodeIndex>(i)).vote_curve())
        for (const Consideration& one : curve->product)
          EYRIE_THROW_UNLESS(one.field < StateFields<State>::all().size(),
                             "the vote of a node follows a field that its state does not have");
  }
};

}  // namespace eyrie::ubf
