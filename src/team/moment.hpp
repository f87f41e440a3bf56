// SPDX-License-Identifier: MIT
#pragma once
/// \file  A decision that is looked at again: what the agent perceived and remembered then.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/system.hpp"
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
             .trace = trace},
            out);
  return out;
}
/// What `tree` remembers at a moment of an agent that has flown with `flown`: the same if both
/// remember the same things in the same places, otherwise nothing. Allocates.
template <class State, class Action>
std::vector<std::uint64_t> memory_for(const ubf::Tree<State, Action>& tree,
                                      const ubf::Tree<State, Action>& flown,
                                      const Moment<State>& m) {
  std::vector<std::uint64_t> slab(tree.memory_bytes() / 8 + 1);
  bool alike = tree.size() == flown.size() && tree.memory_bytes() == flown.memory_bytes();
  for (std::size_t i = 0; alike && i < tree.size(); ++i) {
    const auto node = static_cast<ubf::NodeIndex>(i);
    alike = tree.node(node).type() == flown.node(node).type();
  }
  if (alike)
    std::copy_n(m.memory.begin(), tree.memory_bytes(), reinterpret_cast<std::byte*>(slab.data()));
  return slab;
}
/// The same on a copy of what the agent remembered then. Allocates.
template <class State, class Action>
ubf::Proposal<Action> ask_again(const ubf::Tree<State, Action>& tree, const Moment<State>& m,
                                ubf::Trace<Action>* trace = nullptr) {
  auto slab = memory_for(tree, tree, m);
  return ask_again(tree, m, reinterpret_cast<std::byte*>(slab.data()), trace);
}

}  // namespace eyrie::team
