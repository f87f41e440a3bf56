// SPDX-License-Identifier: MIT
#pragma once
/// \file  One moment of an agent: asked again, and who is to blame.
#include <exception>

#include "sim/event.hpp"
#include "sim/system.hpp"
#include "ubf/agent.hpp"
#include "ubf/tree.hpp"

namespace eyrie::team {

/// What an agent perceived at a decision that is looked at again; good during the call that gets
/// it.
template <class State>
struct Moment {
  const State& state;
  const sim::StepInfo& info;
  double dt;  ///< s, from decision to decision
  PlayerId who;
  std::span<const std::byte> memory;  ///< of its tree, before the decision
  std::span<const ubf::NodeVote> votes = {};
};
template <class State>
using UseMoment = std::function<void(const Moment<State>&)>;

/// What a tree recommends at such a moment; works on `memory`, which is as large as it needs.
template <class State, class Action>
ubf::Proposal<Action> ask_again(const ubf::Tree<State, Action>& tree, const Moment<State>& m,
                                std::byte* memory, ubf::Trace<Action>* trace = nullptr) {
  ubf::Proposal<Action> out;
  tree.tick({.state = m.state,
             .time = m.info.time(),
             .dt = m.dt,
             .step = m.info.step,
             .seed = m.info.seed,
             .player = m.who,
             .memory = memory,
             .trace = trace,
             .votes = m.votes},
            out);
  return out;
}
/// The same on a copy of what the agent remembered then. Allocates.
template <class State, class Action>
ubf::Proposal<Action> ask_again(const ubf::Tree<State, Action>& tree, const Moment<State>& m,
                                ubf::Trace<Action>* trace = nullptr) {
  std::vector<std::uint64_t> slab(tree.memory_bytes() / 8 + 1);
  std::copy_n(m.memory.begin(), tree.memory_bytes(), reinterpret_cast<std::byte*>(slab.data()));
  return ask_again(tree, m, reinterpret_cast<std::byte*>(slab.data()), trace);
}

/// The decision that a thread is making, for whoever has to say who ended the program.
struct Underway {
  PlayerId player;
  std::uint64_t step;
  double time;  ///< s
  std::string_view tree;
};
[[nodiscard]] inline const Underway*& underway() {
  static thread_local const Underway* now = nullptr;
  return now;
}

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
[[nodiscard]] inline std::string exception_text() {
  try {
    throw;
  } catch (const std::exception& e) {
    return fmt::format("threw: {}", e.what());
  } catch (...) {
    return "threw something that is no std::exception";
  }
}

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
