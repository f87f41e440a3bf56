// SPDX-License-Identifier: MIT
#pragma once
/// \file  Whose fault it was that a decision came to nothing: the node that threw, or that first
/// recommended what means nothing.
#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>
#include <typeinfo>

#include "sim/fault.hpp"
#include "team/moment.hpp"
#include "ubf/agent.hpp"

namespace eyrie::team {

/// The decision that a thread is making, for whoever has to say who ended the program.
struct Underway {
  PlayerId player;
  std::uint64_t step;
  double time;  ///< s
  std::string_view tree;
};
[[nodiscard]] const Underway*& underway();

class UnderwayGuard {
 public:
  explicit UnderwayGuard(const Underway& now) : place_(underway()) { place_ = &now; }
  ~UnderwayGuard() { place_ = nullptr; }
  UnderwayGuard(const UnderwayGuard&) = delete;
  UnderwayGuard& operator=(const UnderwayGuard&) = delete;

 private:
  const Underway*& place_;
};

/// What a tree remembered before it was asked, so that it can be asked the same again. Of much only
/// what it remembers afterwards is there; that is good enough to find a node.
class KeptMemory {
 public:
  explicit KeptMemory(std::span<const std::byte> memory) : size_(memory.size()) {
    if (size_ <= kMost)
      std::memcpy(kept_, memory.data(), size_);
  }
  [[nodiscard]] std::span<const std::byte> bytes(std::span<const std::byte> now) const {
    return size_ <= kMost ? std::span<const std::byte>(kept_, size_) : now.first(size_);
  }

 private:
  static constexpr std::size_t kMost = 512;
  std::size_t size_;
  std::byte kept_[kMost];  // not cleared: that costs more than what is used
};

/// The exception that is being handled: "threw: no fuel", "votes what means nothing: vote is nan".
[[nodiscard]] std::string exception_text();
/// Which node it names; kNone if it is none of ours.
[[nodiscard]] ubf::NodeIndex exception_node();

/// The deepest node that set a field to what means nothing, along whom it came from.
template <class State, class Action>
[[nodiscard]] ubf::NodeIndex origin_of(const ubf::Tree<State, Action>& tree,
                                       const ubf::Trace<Action>& trace, std::size_t field) {
  const auto wrong = [&](ubf::NodeIndex node) {
    bool found = false;
    ubf::for_each_field<Action>([&](const auto& f, auto i) {
      const auto& value = trace.row(node).proposal.action.*f.member;
      found |= i == field && trace.row(node).ticked && value && !f.is_plausible(*value);
    });
    return found;
  };
  ubf::NodeIndex node = 0;
  for (bool deeper = true; deeper;) {
    deeper = false;
    const ubf::NodeIndex from = trace.row(node).supplier[field];
    for (const auto& child : tree.node(node).children()) {
      const bool supplies = from >= child->index() && from < child->end_index();
      if (!wrong(child->index()) || (from != node && !supplies))
        continue;
      node = child->index();
      deeper = true;
      break;
    }
  }
  return node;
}

/// Asks again, with a trace, to find the node; `node` is what is known of it. `thrown` are the
/// words of an exception; without them `decided` holds what means nothing. Of a node that answers
/// otherwise the second time only the tree is known, or who led.
template <class State, class Action>
[[gnu::noinline, gnu::cold]] sim::Fault fault_of(const ubf::Tree<State, Action>& tree,
                                                 const Moment<State>& moment, std::string thrown,
                                                 ubf::NodeIndex node,
                                                 const ubf::Proposal<Action>* decided = nullptr) {
  const std::size_t field =
      decided ? ubf::implausible_field(decided->action) : ubf::kFields<Action>;
  ubf::Trace<Action> trace(tree.size());
  try {
    static_cast<void>(ask_again(tree, moment, &trace));
    if (decided)
      node = origin_of(tree, trace, field);
  } catch (...) {
    if (node == ubf::kNone)
      node = trace.unanswered().empty() ? ubf::NodeIndex{0} : trace.unanswered().back();
  }
  const bool known = node < tree.size();
  return {.player = moment.who,
          .agent = known ? fmt::format("{} of tree '{}'", tree.path(node), tree.name())
                         : fmt::format("a node of tree '{}'", tree.name()),
          .node = known ? &typeid(tree.node(node)) : nullptr,
          .what = decided ? "recommends what means nothing: " +
                                ubf::implausible_text(decided->action, field)
                          : std::move(thrown)};
}

}  // namespace eyrie::team
