// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every arbiter, control node, decorator and leaf that comes with the library.
#include "ubf/arbiter/fusion.hpp"
#include "ubf/arbiter/grid.hpp"
#include "ubf/arbiter/layers.hpp"
#include "ubf/arbiter/verify.hpp"
#include "ubf/arbiter/weighted_random.hpp"
#include "ubf/arbiter/winner_takes_all.hpp"
#include "ubf/control/branch.hpp"
#include "ubf/control/parallel.hpp"
#include "ubf/control/random_selector.hpp"
#include "ubf/control/sequence.hpp"
#include "ubf/decorator/for_each.hpp"
#include "ubf/decorator/outcome.hpp"
#include "ubf/decorator/timing.hpp"
#include "ubf/leaf.hpp"
#include "ubf/registry.hpp"
#include "ubf/sequencer.hpp"

namespace eyrie::ubf {

namespace detail {
template <template <class, class> class... Nodes, class State, class Action>
void add_all(Registry<State, Action>& registry) {
  (registry.template add<Nodes<State, Action>>(), ...);
}
}  // namespace detail

template <class State, class Action>
void add_standard_nodes(Registry<State, Action>& registry) {
  detail::add_all<Holds, AlwaysSuccess, AlwaysFailure, Wait>(registry);
  detail::add_all<WinnerTakesAll, PerField, Fusion, PaperFusion, Commitment, Priority, Suppress,
                  Inhibit, WeightedRandom, Verify, MotorSchema, VoteGrid, Utility>(registry);
  detail::add_all<Selector, Sequence, SelectorWithMemory, SequenceWithMemory, Parallel, ParallelAll,
                  RandomSelector, IfThenElse, While, Switch, Sequencer>(registry);
  detail::add_all<Inverter, ForceSuccess, ForceFailure, Timeout, Cooldown, Guard, Repeat, Retry,
                  RunOnce, RateLimit, Delay, ForEach>(registry);
  registry.mark_standard();
}

}  // namespace eyrie::ubf
