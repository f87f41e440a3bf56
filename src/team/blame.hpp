// SPDX-License-Identifier: MIT
#pragma once
/// \file  Whose fault it was that a decision came to nothing.
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

/// The exception that is being handled: "threw: no fuel".
[[nodiscard]] std::string exception_text();

/// The node that threw: the tree is asked again, with a trace. Of one that does otherwise the
/// second time nothing is known.
template <class State, class Action>
[[gnu::noinline, gnu::cold]] ubf::NodeIndex who_threw(const ubf::Tree<State, Action>& tree,
                                                      const Moment<State>& moment) {
  ubf::Trace<Action> trace(tree.size());
  try {
    static_cast<void>(ask_again(tree, moment, &trace));
  } catch (...) {
    return trace.unanswered().empty() ? ubf::NodeIndex{0} : trace.unanswered().back();
  }
  return ubf::kNone;
}

template <class State, class Action>
[[gnu::noinline, gnu::cold]] sim::Fault fault_of(const ubf::Tree<State, Action>& tree, PlayerId who,
                                                 std::string what, ubf::NodeIndex node) {
  const bool known = node < tree.size();
  return {.player = who,
          .agent = known ? fmt::format("{} of tree '{}'", tree.path(node), tree.name())
                         : fmt::format("a node of tree '{}'", tree.name()),
          .node = known ? &typeid(tree.node(node)) : nullptr,
          .what = std::move(what)};
}

}  // namespace eyrie::team
